"""Curves over time, scaled time or depth: a figure with one line per run and diagnostic."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable

import numpy
from matplotlib import pyplot

from diagnostics import Missing, Run, Series, SERIES
from diagnostics import body, loads, scales

from .figure import colour, embed, labelled, Picture, readable

DASHES = ("-", "--", ":")


@dataclass(frozen=True)
class Curve:
    """Diagnostics of SERIES in one figure, told apart by their dashes; `over` makes the abscissa of a series."""

    names: tuple[str, ...]
    over: str = "time"
    log: bool = False
    label: str = ""


def time(run: Run, series: Series) -> numpy.ndarray:
    """Time of the run [s]."""
    return series.time


def scaled_time(run: Run, series: Series) -> numpy.ndarray:
    """t* = (t - touch)/(D0/c): from the first touch of ice or water on."""
    return (series.time - loads.touch(run)) / scales.time_scale(run)


def depth(run: Run, series: Series) -> numpy.ndarray:
    """Depth of the body's lowest point [m]."""
    deep = body.depth(run)
    return numpy.interp(series.time, deep.time, deep.values)


ABSCISSAE: dict[str, tuple[Callable, str, str]] = {
    "time": (time, "time", "s"), "scaled time": (scaled_time, "scaled time t* since the first touch", ""),
    "depth": (depth, "depth of the lowest point", "m")}


@dataclass
class Lines:
    """What the runs have of a figure: (run's number, number of the diagnostic, x, y), and why others are not there."""

    found: list = field(default_factory=list)
    missing: list = field(default_factory=list)

    def limit(self, axis: int) -> float:
        """Largest magnitude of x (2) or y (3)."""
        return max((float(numpy.nanmax(numpy.abs(line[axis]))) for line in self.found if len(line[axis])), default=0.0)

    def least(self) -> float:
        """Smallest y above zero, for an axis of logarithms."""
        return min(float(y[y > 0].min()) for _, _, _, y in self.found if numpy.any(y > 0))


def lines(runs: list[Run], curve: Curve) -> Lines:
    """Asks every run for every diagnostic of the figure."""
    result = Lines()
    for number, run in enumerate(runs):
        for which, name in enumerate(curve.names):
            try:
                series = SERIES[name](run)
                result.found.append((number, which, ABSCISSAE[curve.over][0](run, series), series.values))
            except Missing as missing:
                result.missing.append(str(missing))
    if not result.found:
        raise Missing(result.missing[0])
    if not result.limit(3):
        raise Missing(f"{SERIES[curve.names[0]].label}: zero throughout.")
    return result


def draw(runs: list[Run], curve: Curve) -> Picture:
    """The figure: colours are runs, dashes are diagnostics."""
    what = lines(runs, curve)
    figure, axis = pyplot.subplots(figsize=(5.0, 3.1))
    _, x_label, x_unit = ABSCISSAE[curve.over]
    diagnostic = SERIES[curve.names[0]]
    x_factor, x_unit = readable(x_unit, what.limit(2))
    y_factor, y_unit = readable(diagnostic.unit, what.limit(3))
    for number, which, x, y in what.found:
        names = [runs[number].name] if len(runs) > 1 else []
        names += [SERIES[curve.names[which]].label] if len(curve.names) > 1 else []
        axis.plot(x_factor * x, y_factor * y, DASHES[which], color=colour(number if len(runs) > 1 else which),
                  label=", ".join(names) or None)
    label = curve.label or diagnostic.label
    axis.set(xlabel=labelled(x_label, x_unit), ylabel=labelled(label, y_unit))
    if curve.log:
        axis.set(yscale="log", ylim=(what.least() / 3, 3 * what.limit(3)))
    if len(what.found) > 1:
        axis.legend(loc="best")
    return embed(figure, f"{label} over {x_label}", note=" ".join(SERIES[name].definition for name in curve.names))
