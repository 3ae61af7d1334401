"""The cut z = z0 through the body's axis: water fraction, the spheres near it, the body's outline. y is up."""
from __future__ import annotations

import re
from dataclasses import dataclass

import numpy

from . import foam
from .catalogue import Missing
from .loads import contact_force
from .run import Run
from .surface import placed, poses, vertices


@dataclass(frozen=True)
class Spheres:
    """Those within one diameter of the cut, the farthest from the viewer first: position [m], radius [m], speed [m/s]."""

    position: numpy.ndarray
    radius: numpy.ndarray
    speed: numpy.ndarray


@dataclass(frozen=True)
class Cut:
    """What is seen at one time [s] in the plane z [m]: cell centres x, y [m], water fraction [y, x]; spheres and outline [m]
    where there are."""

    time: float
    plane: float
    x: numpy.ndarray
    y: numpy.ndarray
    water: numpy.ndarray
    spheres: Spheres | None
    outline: numpy.ndarray | None


def write_times(run: Run) -> numpy.ndarray:
    """Times [s] of which a cut can be drawn: the fluid's, or the coarse grid's where the fluid's mesh is no single block."""
    try:
        foam.edges(run)
        return numpy.array([time for time, _ in foam.write_times(run)])
    except Missing:
        return run.coarse.times


def choose(run: Run, times: numpy.ndarray) -> list[float]:
    """Four times, or all if there are fewer: before the first contact, after the largest contact force, half-way to the end,
    the end; even ones without a contact."""
    if len(times) <= 4:
        return list(times)
    even = [times[n] for n in numpy.linspace(0, len(times) - 1, 4).round().astype(int)]
    try:
        force = contact_force(run)
    except Missing:
        return even
    if force.first_above() is None:
        return even
    before = max(0, numpy.searchsorted(times, force.first_above()) - 1)
    hardest = min(max(before + 1, numpy.searchsorted(times, force.time_of_peak())), len(times) - 3)
    return [times[n] for n in (before, hardest, (hardest + len(times) - 1) // 2, len(times) - 1)]


def cut(run: Run, moment: float) -> Cut:
    """The cut at the write time nearest to a moment [s], with the spheres of the snapshot nearest to that."""
    times, plane = write_times(run), plane_of(run)
    time = float(times[numpy.argmin(numpy.abs(times - moment))])
    apart = float(numpy.diff(times).min()) if len(times) > 1 else numpy.inf
    try:
        x, y, water = water_cut(run, time, plane)
    except Missing:
        x, y, water = coarse_cut(run, time, plane)
    return Cut(time, plane, x, y, water, optional(spheres_near, run, time, plane, 0.5 * apart),
               optional(outline_at, run, time))


def optional(function, *arguments):
    """What the function finds; None where the run has no such thing."""
    try:
        return function(*arguments)
    except Missing:
        return None


def plane_of(run: Run) -> float:
    """z0 [m]: of the body's centre of mass at the start; 0 without a body."""
    try:
        return float(run.column("z").values[0])
    except Missing:
        return 0.0


def water_cut(run: Run, time: float, plane: float) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
    """(x, y, water fraction[y, x]) at the fluid's cell centres, interpolated across z to the plane."""
    axes = foam.edges(run)
    name = min(foam.write_times(run), key=lambda item: abs(item[0] - time))[1]
    x, y, z = (0.5 * (axis[1:] + axis[:-1]) for axis in axes)
    return x, y, across(z, foam.scalar_field(run, name, "alpha.water", axes), plane)


def coarse_cut(run: Run, time: float, plane: float) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
    """The same on the coarse grid, whose place is in the snapshot's XDMF text: origin z y x, cell size."""
    n = run.coarse.nearest(time)
    water, = run.coarse.read(n, "water fraction")
    items = re.findall(r">([^<>]+)</DataItem>", run.coarse.xdmf(n))[:2]
    origin, size = (numpy.array(item.split(), float) for item in items)
    z, y, x = (low + step * (0.5 + numpy.arange(count)) for low, step, count in zip(origin, size, water.shape))
    return x, y, across(z, water, plane)


def across(z: numpy.ndarray, field: numpy.ndarray, plane: float) -> numpy.ndarray:
    """field[z, y, x] interpolated to the plane; held beyond the outer cell centres."""
    if len(z) == 1:
        return field[0]
    behind = int(numpy.clip(numpy.searchsorted(z, plane) - 1, 0, len(z) - 2))
    share = numpy.clip((plane - z[behind]) / (z[behind + 1] - z[behind]), 0.0, 1.0)
    return (1 - share) * field[behind] + share * field[behind + 1]


def spheres_near(run: Run, time: float, plane: float, within: float) -> Spheres:
    """Spheres within one diameter of the plane, at the snapshot nearest to `time`, at most `within` [s] away."""
    position, radius, velocity = run.particles.read(run.particles.nearest(time, within), "position", "radius", "velocity")
    near = numpy.flatnonzero(numpy.abs(position[:, 2] - plane) <= 2 * radius)
    near = near[numpy.argsort(position[near, 2])]
    return Spheres(position[near], radius[near], numpy.linalg.norm(velocity[near], axis=1))


def outline_at(run: Run, time: float) -> numpy.ndarray:
    """The body's outline [m] seen along z: a polygon, counter-clockwise."""
    centre, attitude = poses(run)
    row = int(numpy.argmin(numpy.abs(run.column("x").time - time)))
    return hull(placed(vertices(run), centre, attitude, row)[:, :2])


def hull(points: numpy.ndarray) -> numpy.ndarray:
    """Convex hull of points in the plane, counter-clockwise (Andrew's monotone chain): the body is taken as convex."""
    left = lambda a, b, c: (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])

    def chain(ordered):
        ends = []
        for p in ordered:
            while len(ends) > 1 and left(ends[-2], ends[-1], p) <= 0:
                ends.pop()
            ends.append(p)
        return ends[:-1]

    ordered = points[numpy.lexsort((points[:, 1], points[:, 0]))]
    return numpy.array(chain(ordered) + chain(ordered[::-1]))
