"""Shapes that are filled with spheres: a box, a prism over a polygon, a closed STL surface. y is up. See the package."""
import math
import re
import struct

import numpy

GAP = 0.05  # of the mean radius: neighbours closer than this are bonded


class Prism:
    """Between two heights [m] over a polygon of (x, z) corners [m], convex or not."""

    def __init__(self, corners, low, high):
        self.corners, self.low, self.high = numpy.asarray(corners, float), low, high

    def bounds(self):
        """Lower and upper corner of the box around it."""
        (x, z), (X, Z) = self.corners.min(axis=0), self.corners.max(axis=0)
        return numpy.array((x, self.low, z)), numpy.array((X, self.high, Z))

    def depth(self, points):
        """Distance [m] from the surface into the body, for points inside; negative outside."""
        flat = points[:, (0, 2)]
        inside = numpy.zeros(len(points), bool)
        nearest = numpy.full(len(points), math.inf)
        for a, b in zip(self.corners, numpy.roll(self.corners, -1, axis=0)):
            rises = (a[1] > flat[:, 1]) != (b[1] > flat[:, 1])
            slope = (b[0] - a[0]) / (b[1] - a[1]) if b[1] != a[1] else 0.0
            inside ^= rises & (flat[:, 0] < a[0] + slope * (flat[:, 1] - a[1]))
            along = numpy.clip((flat - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
            nearest = numpy.minimum(nearest, numpy.linalg.norm(flat - a - along[:, None] * (b - a), axis=1))
        across = numpy.minimum(points[:, 1] - self.low, self.high - points[:, 1])
        return numpy.minimum(numpy.where(inside, nearest, -nearest), across)


def box(lower, upper):
    """A box as a prism."""
    (x, y, z), (X, Y, Z) = lower, upper
    return Prism([(x, z), (X, z), (X, Z), (x, Z)], y, Y)


class Surface:
    """Inside a closed surface of triangles (n x 3 x 3) [m]."""

    def __init__(self, triangles):
        self.triangles = numpy.asarray(triangles, float)

    def bounds(self):
        """Lower and upper corner of the box around it."""
        corners = self.triangles.reshape(-1, 3)
        return corners.min(axis=0), corners.max(axis=0)

    def depth(self, points):
        """Distance [m] from the surface into the body, for points inside; negative outside."""
        turns, nearest = numpy.zeros(len(points)), numpy.full(len(points), math.inf)
        for triangle in self.triangles:
            turns += solid_angle(points, *triangle)
            nearest = numpy.minimum(nearest, distance_to_triangle(points, *triangle))
        return numpy.where(numpy.abs(turns) > 2 * math.pi, nearest, -nearest)


def solid_angle(points, a, b, c):
    """Under which each point sees a triangle (Van Oosterom & Strackee 1983); ±4π in total from inside a closed surface."""
    a, b, c = a - points, b - points, c - points
    la, lb, lc = (numpy.linalg.norm(v, axis=1) for v in (a, b, c))
    dot = lambda u, v: (u * v).sum(axis=1)
    return 2 * numpy.arctan2(dot(a, numpy.cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb)


def distance_to_triangle(points, a, b, c):
    """Least distance of each point from a triangle [m]: above its face, else from its nearest edge."""
    nearest = numpy.full(len(points), math.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        along = numpy.clip((points - p) @ (q - p) / max((q - p) @ (q - p), 1e-300), 0, 1)
        nearest = numpy.minimum(nearest, numpy.linalg.norm(points - p - along[:, None] * (q - p), axis=1))
    normal = numpy.cross(b - a, c - a)
    size = numpy.linalg.norm(normal)
    if size == 0:
        return nearest
    above = numpy.ones(len(points), bool)
    for p, q in ((a, b), (b, c), (c, a)):
        above &= (points - p) @ numpy.cross(normal, q - p) >= 0
    return numpy.where(above, numpy.abs((points - a) @ normal) / size, nearest)


def read_stl(path):
    """Triangles (n x 3 x 3) of an STL file, ascii or binary. ValueError if there are none."""
    content = open(path, "rb").read()
    count = struct.unpack_from("<I", content, 80)[0] if len(content) >= 84 else 0
    if len(content) == 84 + 50 * count and count:
        rows = numpy.frombuffer(content, numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")]), offset=84)
        return rows["corners"].astype(float)
    numbers = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", content)
    if not numbers or len(numbers) % 3:
        raise ValueError(f"{path}: no STL file, or cut off: {len(numbers)} corners of triangles")
    return numpy.array(numbers, float).reshape(-1, 3, 3)


def fill(shape, cell):
    """Centres and diameters of the spheres that lie inside the shape as a whole, from copies of a periodic cell."""
    lower, upper = shape.bounds()
    first, last = numpy.floor(lower / cell.side).astype(int), numpy.ceil(upper / cell.side).astype(int)
    kept = []
    for shift in numpy.ndindex(*(last - first)):
        points = cell.points + (first + numpy.array(shift)) * cell.side
        near = ((points > lower) & (points < upper)).all(axis=1)
        points, diameters = points[near], cell.diameters[near]
        inside = shape.depth(points) >= 0.5 * diameters
        kept.append(numpy.column_stack((points[inside], diameters[inside])))
    rows = numpy.vstack(kept)
    return rows[:, :3], rows[:, 3]


def bonds(points, diameters, gap=GAP):
    """Pairs (n, m), n < m, of spheres with a gap of at most `gap` of their mean radius."""
    from scipy.spatial import cKDTree
    pairs = cKDTree(points).query_pairs(diameters.max() * (1 + gap / 2), output_type="ndarray")
    distance = numpy.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    radius = 0.25 * diameters[pairs].sum(axis=1)
    return pairs[distance <= (2 + gap) * radius]
