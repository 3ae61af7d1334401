"""The map of the cracks: every broken bond where it was in the unbroken ice, coloured by the time of its breaking."""
from __future__ import annotations

import numpy
from matplotlib import pyplot
from matplotlib.collections import LineCollection

from diagnostics import Run
from diagnostics.ice import cracks, Cracks

from .figure import embed, Picture, TIME


def faces(found: Cracks, across: int) -> numpy.ndarray:
    """Both ends [mm] of each crack's face, seen along one axis of space: the disc across a bond shows its full width where
    it is normal to both the bond and the line of sight."""
    sight = numpy.eye(3)[across]
    edge = numpy.cross(found.normal, sight)
    edge *= 0.5 * found.length[:, None] / numpy.maximum(numpy.linalg.norm(edge, axis=1, keepdims=True), 1e-12)
    return 1e3 * numpy.stack([found.place - edge, found.place + edge], axis=1)


def draw(run: Run) -> Picture:
    """From above (x, z), and below it through the thickness (x, y), the height stretched."""
    found = cracks(run)
    ice = 1e3 * run.particles.read(0, "position")[0]
    figure, (above, through) = pyplot.subplots(2, 1, figsize=(5.0, 6.6), sharex=True, height_ratios=(4, 1))
    for axis, (up, across) in ((above, (2, 1)), (through, (1, 2))):
        axis.grid(False)
        axis.plot(ice[:, 0], ice[:, up], ".", color="#e4e8eb", markersize=1.5, zorder=0, rasterized=True)
        lines = LineCollection(faces(found, across)[:, :, [0, up]], array=1e3 * found.time, cmap=TIME, linewidths=1.1)
        axis.add_collection(lines)
    above.set(ylabel="z [mm]", aspect="equal", title="from above")
    through.set(xlabel="x [mm]", ylabel="height y [mm]", title="through the thickness (stretched)")
    figure.colorbar(lines, ax=(above, through), label="time [ms]", aspect=40, pad=0.02)
    return embed(figure, f"{run.name}: {len(found.time)} broken bonds, where they were in the unbroken ice", "png")
