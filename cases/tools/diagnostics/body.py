"""The body's motion, from history.csv. y is up and the still surface is at y = 0."""
from __future__ import annotations

import numpy

from .catalogue import series, Series, value
from .run import Run
from .surface import length, motion, placed, poses, vertices


@series("speed", "m/s")
def speed(run: Run) -> Series:
    """|v| of the centre of mass [m/s]."""
    return length(run, "vx", "vy", "vz")


@series("depth of the lowest point", "m")
def depth(run: Run) -> Series:
    """-min y over the body's surface [m]: how far its lowest point is below the still surface; negative above."""
    centre, attitude = poses(run)
    points = vertices(run)
    lowest = [placed(points, centre, attitude, row)[:, 1].min() for row in range(len(centre))]
    return Series(run.column("y").time, -numpy.array(lowest))


@series("drift off the axis", "m")
def drift(run: Run) -> Series:
    """√((x - x0)² + (z - z0)²) of the centre of mass [m]."""
    time, across = run.column("x").time, motion(run, "x", "z")
    return Series(time, numpy.linalg.norm(across - across[0], axis=1))


@series("tilt", "°")
def tilt(run: Run) -> Series:
    """Angle between the body's axis, vertical at the start, and the vertical [°]: arccos R_yy of its rotation R."""
    _, attitude = poses(run)
    upright = numpy.array([rotation[1, 1] for rotation in attitude])
    return Series(run.column("wx").time, numpy.degrees(numpy.arccos(numpy.clip(upright, -1, 1))))


@series("wetted share of the body's volume", "")
def wetted(run: Run) -> Series:
    """Volume of the body in water over its volume [-]."""
    return run.column("wetted")


@value("speed at the end", "m/s")
def end_speed(run: Run) -> float:
    """|v| in the last row [m/s]."""
    return speed(run).last()


@value("speed lost", "m/s")
def speed_lost(run: Run) -> float:
    """|v| in the first row less that in the last [m/s]."""
    return float(speed(run).values[0]) - end_speed(run)


@value("depth of the lowest point at the end", "m")
def end_depth(run: Run) -> float:
    """Depth in the last row [m]."""
    return depth(run).last()


@value("tilt at the end", "°")
def end_tilt(run: Run) -> float:
    """Tilt in the last row [°]."""
    return tilt(run).last()
