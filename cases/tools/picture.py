#!/usr/bin/env python3
"""A figure of a run in which a body falls through ice or water: picture.py RUNFOLDER OUT.png

Above, four cuts through the body's axis (the plane z = 0, y is up): water fraction, the spheres near the cut, the body.
Below, speed of the body, contact force and broken bonds against time.
"""
import sys

try:
    import numpy as np
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.colors import Normalize
except ImportError as missing:
    sys.exit(f"picture: no figure, because {missing.name} is not installed")

from diagnostics import Missing, Run, SERIES
from diagnostics.cut import choose, cut, write_times
from report.views import ICE, INK, view, window


def name_phases(axis, spheres):
    """Says in the first view which shade is what."""
    axis.text(0.04, 0.97, "air", transform=axis.transAxes, va="top", style="italic")
    axis.text(0.04, 0.36, "water", transform=axis.transAxes, va="top", style="italic")
    if spheres is not None:
        top = 1e3 * (spheres.position[:, 1] + spheres.radius).max()
        axis.text(0.04, top + 2, "ice", transform=axis.get_yaxis_transform(), va="bottom", style="italic")


def views(figure, axes, run, cuts):
    """The upper row and its scale of colours."""
    colours = Normalize(0, 5 * np.ceil(0.2 * np.abs(run.column("vy").values).max() - 0.02))
    x, y = window(cuts)
    for axis, letter, each in zip(axes, "abcd", cuts):
        view(axis, each, colours)
        axis.set(xlim=x, ylim=y, xlabel="x [mm]")
        axis.set_title(f"({letter})  t = {1e3 * each.time:.1f} ms", loc="left")
    axes[0].set_ylabel("height y [mm]")
    name_phases(axes[0], cuts[0].spheres)
    if cuts[0].spheres is not None:
        scale = axes[0].inset_axes((0.12, 0.12, 0.76, 0.025))
        bar = figure.colorbar(pyplot.cm.ScalarMappable(colours, ICE), cax=scale, orientation="horizontal")
        bar.set_label("speed of the spheres [m/s]", labelpad=2)


def panels(run):
    """[(label, {name: (series, colour)})] of the lower row; without what the run has not."""
    rows = [("body speed [m/s]", {"": ("speed", INK)}), ("contact force [N]", {"": ("contact_force", "#c8371d")}),
            ("broken bonds", {"in tension": ("broken_tension", "#2f6690"), "in shear": ("broken_shear", "#ee9a3a")})]
    found = []
    for label, lines in rows:
        try:
            lines = {name: (SERIES[which](run), colour) for name, (which, colour) in lines.items()}
        except Missing:
            continue
        if any(np.any(series.values) for series, _ in lines.values()):
            found.append((label, lines))
    return found


def curves(figure, run, cuts):
    """The lower row, with the times of the views marked."""
    rows = panels(run)
    for axis, letter, (label, lines) in zip(figure.subplots(1, len(rows), squeeze=False)[0], "efg", rows):
        for name, (series, colour) in lines.items():
            axis.plot(1e3 * series.time, series.values, color=colour, label=name)
        axis.set(xlabel="time t [ms]", ylabel=label, xlim=(0, 1e3 * run.history["time"][-1]), ylim=(0, None))
        axis.set_title(f"({letter})", loc="left", x=-0.043 * len(rows))
        if len(lines) > 1:
            axis.legend(frameon=False, loc="lower right")
        for name, each in zip("abcd", cuts):
            axis.axvline(1e3 * each.time, color="#7d8790", linewidth=0.8, linestyle=":", zorder=0)
            axis.text(1e3 * each.time, 1.01, name, transform=axis.get_xaxis_transform(), ha="center", color="#5c656e",
                      fontsize=9)


def draw(run):
    """The figure."""
    moments = choose(run, write_times(run))
    if len(moments) < 4:
        raise Missing(f"{run.folder}/foam: has {len(moments)} times with alpha.water, four are needed.")
    cuts = [cut(run, moment) for moment in moments]
    pyplot.rcParams.update({"font.size": 11, "axes.titlesize": 12, "axes.linewidth": 0.8, "axes.edgecolor": INK,
                            "lines.linewidth": 1.5})
    figure = pyplot.figure(figsize=(13.4, 8.6), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.08, h_pad=0.06)
    upper, lower = figure.subfigures(2, 1, height_ratios=(2.05, 1))
    views(upper, upper.subplots(1, 4, sharey=True), run, cuts)
    curves(lower, run, cuts)
    return figure


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: picture.py RUNFOLDER OUT.png")
    try:
        draw(Run(sys.argv[1])).savefig(sys.argv[2], dpi=120)
    except Missing as missing:
        sys.exit(f"picture: no figure: {missing}")


if __name__ == "__main__":
    main()
