"""Figures of a study: each metric over each parameter, and maps over each pair of parameters. Only numbers are drawn; seeds
are no axis: repeats are drawn with the span from the smallest to the largest."""
from __future__ import annotations

import itertools
import textwrap
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy
from matplotlib import pyplot, tri

from .study import SEED
from .table import Column

MOST_CURVES = 8  # of a second parameter's values; more are drawn as loose points


def drawn(table: list[Column], kind: str, distinct: int) -> list[Column]:
    """Columns of numbers with at least so many different values."""
    return [column for column in table if column.kind == kind and column.name != SEED and column.numbers()
            and len(set(column.values) - {None}) >= distinct]


def rows(*columns: Column) -> numpy.ndarray:
    """Rows in which every column has a value."""
    return numpy.array([row for row in zip(*(column.values for column in columns)) if None not in row], float)


def repeats(places: numpy.ndarray, values: numpy.ndarray):
    """Equal places once: (places, mean, smallest, largest)."""
    unique, number = numpy.unique(places, axis=0, return_inverse=True)
    groups = [values[number.ravel() == n] for n in range(len(unique))]
    return unique, *(numpy.array([function(group) for group in groups]) for function in (numpy.mean, numpy.min, numpy.max))


def tied(one: Column, other: Column) -> bool:
    """Whether one rises or falls with the other from point to point, as zipped lists do: they are one parameter then."""
    steps = numpy.diff(numpy.unique(rows(one, other), axis=0), axis=0)
    return bool((steps[:, 0] > 0).all() and ((steps[:, 1] > 0).all() or (steps[:, 1] < 0).all()))


def wrapped(label: str) -> str:
    """A label in lines that fit beside a figure; the unit stays with its word."""
    return textwrap.fill(label.replace(" [", "\xa0["), 36)


def curve(axis, x: numpy.ndarray, y: numpy.ndarray, label: str = "") -> None:
    """Points in the order of x with a line through their means, and the span of repeats."""
    places, mean, low, high = repeats(x[:, None], y)
    axis.errorbar(places[:, 0], mean, [mean - low, high - mean], fmt="o-", markersize=4, linewidth=1, capsize=2, label=label)


def over(path: Path, parameter: Column, metric: Column, others: list[Column]) -> None:
    """A metric over a parameter: a curve for each value of the other one, loose points where there are several others."""
    figure, axis = pyplot.subplots(figsize=(4.6, 3.4), layout="constrained")
    if not others:
        curve(axis, *rows(parameter, metric).T)
    elif len(others) == 1 and len(set(others[0].values)) <= MOST_CURVES:
        data = rows(parameter, metric, others[0])
        for value in numpy.unique(data[:, 2]):
            curve(axis, *data[data[:, 2] == value, :2].T, f"{value:.4g} {others[0].unit}")
        axis.legend(title=others[0].label, frameon=False, fontsize="small")
    else:
        axis.plot(*rows(parameter, metric).T, "o", markersize=4)
    axis.set(xlabel=parameter.title, ylabel=wrapped(metric.title))
    axis.locator_params(axis="x", nbins=6)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def plane(axis, places: numpy.ndarray, mean: numpy.ndarray, limits: dict) -> None:
    """The metric between the points, linear in triangles; nothing where all points lie on a line."""
    scaled = (places - places.min(axis=0)) / numpy.ptp(places, axis=0)
    if numpy.linalg.matrix_rank(scaled - scaled[0], tol=1e-6) < 2 or not numpy.ptp(mean):
        return
    axis.tricontourf(tri.Triangulation(*places.T, tri.Triangulation(*scaled.T).triangles), mean, levels=20, **limits)


def over_pair(path: Path, pair: tuple[Column, Column], metric: Column) -> None:
    """A map of a metric over two parameters: points, and the plane between them."""
    data = rows(*pair, metric)
    places, mean, _, _ = repeats(data[:, :2], data[:, 2])
    limits = {"vmin": mean.min(), "vmax": mean.max()}
    figure, axis = pyplot.subplots(figsize=(4.6, 3.4), layout="constrained")
    plane(axis, places, mean, limits)
    points = axis.scatter(*places.T, c=mean, edgecolors="black", linewidths=1, zorder=2, **limits)
    figure.colorbar(points, label=wrapped(metric.title))
    axis.use_sticky_edges = False  # room around the outermost points
    axis.margins(0.06)
    axis.set(xlabel=pair[0].title, ylabel=pair[1].title)
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def draw(folder: Path, table: list[Column]) -> dict[str, list[Path]]:
    """All figures, by the heading under which they stand."""
    folder.mkdir(exist_ok=True)
    parameters, metrics = drawn(table, "parameter", 2), drawn(table, "metric", 1)
    single, pairs = [], []
    for one, metric in itertools.product(parameters, metrics):
        if len(set(rows(one, metric)[:, 0])) > 1:
            single.append(folder / f"{metric.name}_over_{one.name}.png")
            over(single[-1], one, metric, [other for other in parameters if other is not one and not tied(one, other)])
    for pair, metric in itertools.product(itertools.combinations(parameters, 2), metrics):
        if not tied(*pair) and all(len(set(column)) > 1 for column in rows(*pair, metric)[:, :2].T):
            pairs.append(folder / f"{metric.name}_over_{pair[0].name}_{pair[1].name}.png")
            over_pair(pairs[-1], pair, metric)
    return {"Over each parameter": single, "Over two parameters": pairs}
