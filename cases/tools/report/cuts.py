"""Cuts through the axis: cavity, spheres and body at four moments of each run."""
from __future__ import annotations

import numpy
from matplotlib import pyplot
from matplotlib.colors import Normalize

from diagnostics import Missing, Run
from diagnostics.cut import choose, Cut, cut, write_times

from .figure import embed, Picture
from .views import ICE, view, window


def draw(run: Run) -> list[Picture]:
    """One picture for each moment, all of the same part of space, and the scale of colours in the first."""
    cuts = [cut(run, moment) for moment in choose(run, write_times(run))]
    if not any(map(shows_something, cuts)):
        raise Missing(f"{run.name}: the cut z = {cuts[0].plane:g} m shows neither surface nor spheres nor body.")
    return [one(run, each, window(cuts), colours_of(cuts)) for each in cuts]


def colours_of(cuts: list[Cut]) -> Normalize:
    """From rest to the fastest sphere [m/s], in steps of 5 m/s above the first."""
    speeds = [each.spheres.speed for each in cuts if each.spheres is not None]
    fastest = max((float(speed.max()) for speed in speeds if len(speed)), default=0.0)
    return Normalize(0, 5 * numpy.ceil(0.2 * fastest) if fastest > 1 else max(fastest, 1e-6))


def shows_something(cut: Cut) -> bool:
    """Whether there is more in the cut than water or air."""
    spheres = cut.spheres is not None and len(cut.spheres.radius) > 0
    return spheres or cut.outline is not None or cut.water.min() < 0.5 < cut.water.max()


def one(run: Run, cut: Cut, limits: tuple, colours: Normalize) -> Picture:
    """One moment."""
    (left, right), (bottom, top) = limits
    figure, axis = pyplot.subplots(figsize=(3.4, 1.0 + 2.8 * min(max((top - bottom) / (right - left), 0.4), 2.2)))
    axis.grid(False)
    view(axis, cut, colours)
    axis.set(xlim=(left, right), ylim=(bottom, top), xlabel="x [mm]", ylabel="height y [mm]")
    axis.set_title(f"{run.name}, {1e3 * cut.time:.3g} ms", loc="left", fontsize=8.5)
    if cut.spheres is not None:
        figure.colorbar(pyplot.cm.ScalarMappable(colours, ICE), ax=axis, orientation="horizontal", pad=0.02, aspect=30,
                        label="speed of the spheres [m/s]")
    text = f"{run.name}, {1e3 * cut.time:.3g} ms: cut with water, spheres and body"
    return embed(figure, text, "png", note="", shape="small")
