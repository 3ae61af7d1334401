"""The body's surface and its attitude: from its STL, and from its motion in history.csv. y is up."""
from __future__ import annotations

import re
from pathlib import Path

import numpy

from .catalogue import Missing, Series
from .run import Run


def surface_path(run: Run) -> Path:
    """The STL of the first body of foam/constant/couplingProperties, which is that of history.csv."""
    text = run.text("foam/constant/couplingProperties")
    found = re.search(r'\bsurface\s+"?([^";]+)"?\s*;', text)
    if not found:
        raise Missing(f"{run.folder / 'foam/constant/couplingProperties'}: names no body.")
    return run.folder / "foam" / found.group(1)


def read_stl(path: Path) -> numpy.ndarray:
    """Corners [m] of the triangles, n x 3 x 3, of an ascii or a binary STL."""
    if not path.is_file():
        raise Missing(f"{path}: does not exist.")
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    if len(data) == 84 + 50 * count:
        facets = numpy.frombuffer(data, numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")]),
                                  count, 84)
        return facets["corners"].astype(float)
    words = re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data.decode(errors="replace"))
    return numpy.array(words, float).reshape(-1, 3, 3)


def vertices(run: Run) -> numpy.ndarray:
    """Points [m] of the body's surface, each once, as it lies at the start."""
    return numpy.unique(read_stl(surface_path(run)).reshape(-1, 3), axis=0)


def turn(rotation: numpy.ndarray) -> numpy.ndarray:
    """Matrix of a rotation vector [rad] (Rodrigues)."""
    angle = numpy.linalg.norm(rotation)
    if angle == 0:
        return numpy.eye(3)
    a, b, c = rotation / angle
    cross = numpy.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def motion(run: Run, *names: str) -> numpy.ndarray:
    """Columns of the body in history.csv side by side."""
    return numpy.column_stack([run.column(name).values for name in names])


def length(run: Run, *names: str) -> Series:
    """Magnitude √(a² + b² + ...) of columns of the history."""
    return Series(run.column(names[0]).time, numpy.linalg.norm(motion(run, *names), axis=1))


def poses(run: Run) -> tuple[numpy.ndarray, list[numpy.ndarray]]:
    """Centre of mass [m] and attitude of the body at every row of the history; the attitude is first the STL's, then it is
    turned by the mean angular velocity of each step."""
    centre, spin, time = motion(run, "x", "y", "z"), motion(run, "wx", "wy", "wz"), run.column("x").time
    attitude = [numpy.eye(3)]
    for n in range(1, len(time)):
        attitude.append(turn(0.5 * (spin[n - 1] + spin[n]) * (time[n] - time[n - 1])) @ attitude[-1])
    return centre, attitude


def placed(points: numpy.ndarray, centre: numpy.ndarray, attitude: list[numpy.ndarray], row: int) -> numpy.ndarray:
    """Points of the body [m] at a row of the history."""
    return (points - centre[0]) @ attitude[row].T + centre[row]
