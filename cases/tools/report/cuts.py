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
    fastest = max((each.spheres.speed.max() for each in cuts if each.spheres is not None and len(each.spheres.speed)), default=1)
    colours = Normalize(0, 5 * numpy.ceil(0.2 * max(fastest, 0.1)) if fastest > 1 else fastest)
    return [one(run, each, window(cuts), colours) for each in cuts]


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
    return embed(figure, f"{run.name}, {1e3 * cut.time:.3g} ms: cut with water, spheres and body", "png", note=" ", shape="small")
