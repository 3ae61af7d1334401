"""Closed surfaces as triangles, counter-clockwise seen from outside, and the STL files that hold them. Lengths in m."""
import math
import pathlib

QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]  # of a box, corner bits xyz


def write_stl(path, triangles, digits=17):
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w") as out:
        out.write("solid body\n")
        for triangle in triangles:
            out.write("facet normal 0 0 0\nouter loop\n")
            out.writelines("vertex " + " ".join(f"{x:.{digits}g}" for x in corner) + "\n" for corner in triangle)
            out.write("endloop\nendfacet\n")
        out.write("endsolid body\n")


def quads(*corners):
    """Two triangles for each quad of four corners."""
    return [triangle for a, b, c, d in corners for triangle in ((a, b, c), (a, c, d))]


def cuboid(size, centre=(0, 0, 0)):
    low = [c - s / 2 for c, s in zip(centre, size)]
    high = [c + s / 2 for c, s in zip(centre, size)]
    corner = [tuple((low, high)[n >> axis & 1][axis] for axis in range(3)) for n in range(8)]
    return quads(*([corner[n] for n in quad] for quad in QUADS))


def revolve(profile, segments, centre, axis=1):
    """The surface that the profile [(r, height), ...] makes around the y axis (or another one); r = 0 at both ends."""
    first, second = (axis - 1) % 3, (axis + 1) % 3

    def at(r, height, k):
        angle = 2*math.pi*(k % segments)/segments
        point = list(centre)
        point[axis] += height
        point[first] += r*math.cos(angle)
        point[second] += r*math.sin(angle)
        return tuple(point)
    triangles = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        for k in range(segments):
            a, b, c, d = at(r0, y0, k), at(r0, y0, k + 1), at(r1, y1, k + 1), at(r1, y1, k)
            if r0 > 0:
                triangles.append((a, c, b))
            if r1 > 0:
                triangles.append((a, d, c))
    return triangles


def volume(triangles):
    """Enclosed volume [m3]."""
    return sum(a[0]*(b[1]*c[2] - b[2]*c[1]) + a[1]*(b[2]*c[0] - b[0]*c[2]) + a[2]*(b[0]*c[1] - b[1]*c[0])
               for a, b, c in triangles)/6


def sphere(diameter, centre, rings=64):
    """Sphere about the y axis."""
    r = diameter/2
    profile = [(r*math.sin(math.pi*i/rings), -r*math.cos(math.pi*i/rings)) for i in range(rings + 1)]
    profile[0], profile[-1] = (0.0, -r), (0.0, r)
    return revolve(profile, 2*rings, centre)


def cone(diameter, length, centre_tip, full_angle=120.0):
    """Cone with its tip down and a cylinder above, about the y axis; centre_tip is the tip [m]."""
    r = diameter/2
    h = r/math.tan(math.radians(full_angle/2))
    return revolve([(0.0, 0.0), (r, h), (r, length), (0.0, length)], 128, centre_tip)
