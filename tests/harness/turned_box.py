"""A block of hexahedra whose edges are parallel to no axis, for tests on a real mesh: no component of a vector is zero
by accident. Its patch `top` is the +y face before it was turned, all others are `walls`. Lengths in m."""
import math

AXIS, ANGLE = (1 / 3, 2 / 3, 2 / 3), 0.4  # [rad]


def turned(p):
    """The point turned by ANGLE around AXIS (Rodrigues)."""
    c, s = math.cos(ANGLE), math.sin(ANGLE)
    along = sum(a * b for a, b in zip(AXIS, p)) * (1 - c)
    cross = [AXIS[(i + 1) % 3] * p[(i + 2) % 3] - AXIS[(i + 2) % 3] * p[(i + 1) % 3] for i in range(3)]
    return [c * x + s * k + along * a for x, k, a in zip(p, cross, AXIS)]


def block_mesh(half, cells, grading=(1, 1, 1)):
    """Dictionary of the block from -half to half, turned around the origin."""
    corners = [[h * s for h, s in zip(half, signs)] for signs in (
        (-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))]
    vertices = "\n".join("({:.17g} {:.17g} {:.17g})".format(*turned(p)) for p in corners)
    n, g = (" ".join(map(str, numbers)) for numbers in (cells, grading))
    return f"""scale 1;
vertices ({vertices});
blocks (hex (0 1 2 3 4 5 6 7) ({n}) simpleGrading ({g}));
edges ();
boundary ( top {{ type patch; faces ((3 7 6 2)); }} );
defaultPatch {{ name walls; type wall; }}
"""
