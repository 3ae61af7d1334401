"""Sizes of the fragments in the last snapshot."""
from __future__ import annotations

import numpy
from matplotlib import pyplot

from diagnostics import Missing, Run
from diagnostics.ice import fragments, Fragments

from .figure import colour, embed, Picture


def found(runs: list[Run]) -> list[tuple[int, Fragments]]:
    """(number of the run, its fragments) of those that have them."""
    result, reasons = [], []
    for number, run in enumerate(runs):
        try:
            result.append((number, fragments(run)))
        except Missing as missing:
            reasons.append(str(missing))
    if not result:
        raise Missing(reasons[0])
    return result


def draw_counts(runs: list[Run]) -> Picture:
    """Number of fragments by size, in classes that double: 1, 2-3, 4-7, ... spheres."""
    what = found(runs)
    classes = max(int(numpy.log2(each.spheres.max())) for _, each in what) + 1
    figure, axis = pyplot.subplots(figsize=(5.0, 3.1))
    width = 0.8 / len(what)
    for place, (number, each) in enumerate(what):
        counts = numpy.bincount(numpy.log2(each.spheres).astype(int), minlength=classes)
        at = numpy.arange(classes) + (place - 0.5 * (len(what) - 1)) * width
        axis.bar(at, counts, width, color=colour(number), label=runs[number].name)
    names = ["1"] + [f"{2**n}-{2 ** (n + 1) - 1}" for n in range(1, classes)]
    axis.set_xticks(range(classes), names, rotation=45, ha="right", fontsize=7.5)
    axis.set(xlabel="spheres in the fragment", ylabel="fragments", yscale="log", ylim=(0.7, None))
    if len(runs) > 1:
        axis.legend()
    return embed(figure, "Fragments by size in the last snapshot")


def draw_shares(runs: list[Run]) -> Picture:
    """Share of the ice's volume in fragments of at most that many spheres."""
    figure, axis = pyplot.subplots(figsize=(5.0, 3.1))
    least = 1.0
    for number, each in found(runs):
        spheres, share = each.share_of_smaller()
        axis.step(numpy.append(spheres, 2 * spheres[-1]), numpy.append(share, 1), where="post", color=colour(number),
                  label=runs[number].name)
        least = min(least, share[0])
    axis.set(xlabel="spheres in the fragment, n", ylabel="share of the volume in\nfragments of at most n spheres", xscale="log",
             yscale="log", ylim=(0.5 * least, 1.5))
    if len(runs) > 1:
        axis.legend()
    return embed(figure, "Share of the ice in small fragments, last snapshot")
