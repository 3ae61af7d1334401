"""The map of the cracks: every broken bond where it was in the unbroken ice, coloured by the time of its breaking."""
from __future__ import annotations

import numpy
from matplotlib import pyplot
from matplotlib.collections import LineCollection

from diagnostics import Run
from diagnostics.ice import cracks, Cracks

from .figure import embed, Picture, TIME

SLICE = 0.26  # height of the view through the thickness over its width


def faces(found: Cracks, across: int) -> numpy.ndarray:
    """Both ends [mm] of each crack's face, seen along one axis of space: the disc across a bond shows its full width where
    it is normal to both the bond and the line of sight."""
    sight = numpy.eye(3)[across]
    edge = numpy.cross(found.normal, sight)
    edge *= 0.5 * found.length[:, None] / numpy.maximum(numpy.linalg.norm(edge, axis=1, keepdims=True), 1e-12)
    return 1e3 * numpy.stack([found.place - edge, found.place + edge], axis=1)


def reach(found: Cracks, ice: numpy.ndarray) -> float:
    """Half width [mm] of the map: the cracks with a margin, the whole ice at most."""
    across = [0, 2]
    return min(1.4e3 * numpy.abs(found.place[:, across]).max(), 1.05 * numpy.abs(ice[:, across]).max())


def draw(run: Run) -> Picture:
    """From above (x, z), and below it through the thickness (x, y), the height to a scale of its own."""
    found = cracks(run)
    ice = 1e3 * run.particles.read(0, "position")[0]
    figure, (above, through) = pyplot.subplots(2, 1, figsize=(5.0, 7.4), sharex=True, height_ratios=(1, SLICE))
    for axis, (up, across) in ((above, (2, 1)), (through, (1, 2))):
        axis.grid(False)
        axis.plot(ice[:, 0], ice[:, up], ".", color="#e4e8eb", markersize=1.5, zorder=0, rasterized=True)
        lines = LineCollection(faces(found, across)[:, :, [0, up]], array=1e3 * found.time, cmap=TIME, linewidths=1.1)
        axis.add_collection(lines)
    half = reach(found, ice)
    above.set(ylabel="z [mm]", xlim=(-half, half), ylim=(-half, half), box_aspect=1, title="from above")
    through.set(xlabel="x [mm]", ylabel="height y [mm]", box_aspect=SLICE, title="through the thickness")
    figure.colorbar(lines, ax=[above, through], label="time [ms]", location="bottom", aspect=40, pad=0.02)
    return embed(figure, f"{run.name}: {len(found.time)} broken bonds, where they were in the unbroken ice", "png")
