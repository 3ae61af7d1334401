"""One cut through the body's axis (diagnostics.cut), drawn in millimetres."""
from __future__ import annotations

import numpy
from matplotlib.collections import EllipseCollection
from matplotlib.colors import LinearSegmentedColormap

WATER = LinearSegmentedColormap.from_list("water", ["#ffffff", "#cfe3f1", "#6fa8cf"])
ICE = LinearSegmentedColormap.from_list("ice", ["#f4f1e6", "#f6d98b", "#ee9a3a", "#c8371d", "#6d1010"])
BODY, INK = "#4a4f57", "#22262b"


def view(axis, cut, colours):
    """Water, its surface at one half, spheres coloured by speed, body."""
    axis.contourf(1e3 * cut.x, 1e3 * cut.y, numpy.clip(cut.water, 0, 1), levels=numpy.linspace(0, 1, 21), cmap=WATER)
    if cut.water.min() < 0.5 < cut.water.max():
        axis.contour(1e3 * cut.x, 1e3 * cut.y, cut.water, levels=[0.5], colors="#2f6690", linewidths=0.9)
    if cut.spheres is not None:
        size = 2e3 * cut.spheres.radius
        axis.add_collection(EllipseCollection(
            size, size, numpy.zeros_like(size), units="xy", offsets=1e3 * cut.spheres.position[:, :2],
            offset_transform=axis.transData, array=cut.spheres.speed, cmap=ICE, norm=colours, edgecolors="#5b5348",
            linewidths=0.45))
    if cut.outline is not None:
        axis.fill(*(1e3 * cut.outline.T), facecolor=BODY, edgecolor="black", linewidth=0.9, zorder=5)
    axis.set_aspect("equal")


def window(cuts):
    """Limits [mm] of views of the same run: everything the body passes and the spheres below, three lengths of it wide;
    without a body everything."""
    outlines = [cut.outline for cut in cuts if cut.outline is not None]
    if not outlines:
        return tuple((1e3 * axis[0], 1e3 * axis[-1]) for axis in (cuts[0].x, cuts[0].y))
    low, high = (1e3 * limit for limit in (min(o[:, 1].min() for o in outlines), max(o[:, 1].max() for o in outlines)))
    half, middle = 0.36 * (high - low), 1e3 * numpy.mean([o[:, 0].mean() for o in outlines])
    beside = [cut.spheres.position[:, :2] * 1e3 for cut in cuts if cut.spheres is not None]
    low = min([low, *(y for places in beside for x, y in places if abs(x - middle) < half)])
    return (middle - half, middle + half), (low - 0.2 * half, high + 0.15 * half)
