"""Floating structures of randomly packed spheres: a hexagonal floe, a ridge of rubble, a log. y is up; SI units.

Each gives centres, diameters and the pairs to be bonded. The ridge is ice that has broken: its spheres are divided among
blocks, the cells of points thrown into it (Voronoi), and only spheres of one block are bonded.
"""
import math

import numpy

from packing import shapes

BLOCKS = 12  # of the ridge


def hexagon(cell, size):
    """A floe of circumradius `size` and half of that thick."""
    angle = numpy.arange(6) * math.pi / 3
    return filled(shapes.Prism(size * numpy.column_stack((numpy.cos(angle), numpy.sin(angle))), 0.0, 0.5 * size), cell)


def log(cell, size):
    """A trunk along x, 3 `size` long, of radius `size`/2."""
    angle = numpy.arange(24) * math.pi / 12
    upright = shapes.Prism(0.5 * size * numpy.column_stack((numpy.cos(angle), numpy.sin(angle))), 0.0, 3 * size)
    points, diameters, pairs = filled(upright, cell)
    return numpy.column_stack((points[:, 1] - 1.5 * size, points[:, 0], points[:, 2])), diameters, pairs


def ridge(cell, size):
    """A keel, a triangle 2 `size` wide and `size` deep, 2 `size` long along z, in blocks that are not bonded to each other."""
    wedge = shapes.Prism([(-size, 0.0), (size, 0.0), (0.0, -size)], -size, size)  # in (x, y), along z
    points, diameters, pairs = filled(wedge, cell)
    points = points[:, (0, 2, 1)]
    generator = numpy.random.default_rng(1)
    seeds = points[generator.choice(len(points), BLOCKS, replace=False)]
    block = numpy.linalg.norm(points[:, None] - seeds, axis=2).argmin(axis=1)
    return points, diameters, pairs[block[pairs[:, 0]] == block[pairs[:, 1]]]


STRUCTURES = {"hexagon": hexagon, "ridge": ridge, "log": log}


def filled(shape, cell):
    """A shape's spheres and their bonds."""
    points, diameters = shapes.fill(shape, cell)
    return points, diameters, shapes.bonds(points, diameters)


def submerged(heights, diameters, level):
    """Share of the spheres' volume below a level [-]."""
    s = numpy.clip((level - heights) / diameters + 0.5, 0.0, 1.0)
    return float((diameters**3 * s * s * (3 - 2 * s)).sum() / (diameters**3).sum())


def afloat(points, diameters, share):
    """The centres at the height at which `share` of the volume is below y = 0."""
    low, high = -points[:, 1].max() - diameters.max(), -points[:, 1].min() + diameters.max()
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if submerged(points[:, 1] + middle, diameters, 0.0) > share else (low, middle)
    return points + numpy.array((0.0, 0.5 * (low + high), 0.0))
