"""The projectile of the study: flat-tailed cylinder with a rounded cone, axis along y, nose down. Lengths in m.

Meridian from the tip: arc of radius r up to where its slope is the cone's, cone of half-angle θ, cylinder, flat tail.
"""
import math


def meridian(diameter, length, half_angle, tip_radius, facets):
    """Points (distance from the axis, height above the tip) from tip to tail centre; about as many steps along the
    cylinder as give facets no longer than four times their width."""
    radius, arc_end = diameter / 2, math.pi / 2 - half_angle
    arc = [(tip_radius * math.sin(a), tip_radius * (1 - math.cos(a))) for a in (arc_end * n / 3 for n in range(4))]
    neck, start = arc[-1]
    shoulder = start + (radius - neck) / math.tan(half_angle)
    width = math.pi * diameter / facets
    cone = [(neck + (radius - neck) * s, start + (shoulder - start) * s) for s in graded(neck / radius, width / radius)]
    steps = max(2, math.ceil((length - shoulder) / (4 * width)))
    wall = [(radius, shoulder + (length - shoulder) * n / steps) for n in range(1, steps + 1)]
    tail = [(radius * s, length) for s in (0.6, 0.3)]
    return arc + cone + wall + tail + [(0.0, length)]


def graded(first, last):
    """Shares 0..1 of the way from a small ring to the rim, steps growing with the ring's radius; without 0, with 1."""
    rings, r = [], first
    while r < 1 - 0.5 * last:
        r = min(1.0, r + max(last * max(r, 0.2) * 2, 0.04))
        rings.append((r - first) / (1 - first))
    rings[-1] = 1.0
    return rings


def triangles(profile, facets, tip):
    """Surface of revolution about y through `tip`, corners counter-clockwise from outside; closed because
    neighbouring rings share their points exactly."""
    angles = [2 * math.pi * n / facets for n in range(facets)]
    ring = lambda r, h: [(tip[0] + r * math.cos(a), tip[1] + h, tip[2] + r * math.sin(a)) for a in angles]
    rings = [ring(*point) for point in profile]
    result = []
    for (r0, _), (r1, _), lower, upper in zip(profile, profile[1:], rings, rings[1:]):
        for n in range(facets):
            a, b, c, d = lower[n], lower[(n + 1) % facets], upper[(n + 1) % facets], upper[n]
            if r0 > 0:
                result.append((a, d, b) if r1 > 0 else (a, upper[0], b))
            if r1 > 0:
                result.append((b, d, c) if r0 > 0 else (lower[0], d, c))
    return result


def write_stl(path, corners, name):
    """ASCII STL with all digits, so that two programs read the same points."""
    with open(path, "w") as stl:
        stl.write(f"solid {name}\n")
        for triangle in corners:
            stl.write("facet normal 0 0 0\n outer loop\n")
            stl.writelines("  vertex %.17g %.17g %.17g\n" % point for point in triangle)
            stl.write(" endloop\nendfacet\n")
        stl.write(f"endsolid {name}\n")


def volume(corners):
    """Volume inside the triangles [m3], positive if they look outwards."""
    det = lambda a, b, c: (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                           + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(det(*triangle) for triangle in corners) / 6
