"""What theory says of a plate of bonded spheres in hexagonal close packing: stiffness, first failure and wave speed of the
endless plate, from the bonds' own law. The reference that the ice cases are held against.

Cauchy-Born method for a plate: the centres follow an even strain ε and curvature χ of the mid-plane,
    u = (ε - z χ) r,   u_z = r.χ r/2,   rotation (∂u_z/∂y, -∂u_z/∂x, 0),
plus shifts and rotations of the spheres of each layer that repeat from cell to cell and make the bonds' energy least.
Directions: x along close-packed rows, y across them, z through the plate. One sphere per layer in a cell of area √3/2 D².

Law of a bond (Potyondy & Cundall 2004; parallel_bond.h): force ks A slip + (kn - ks) A (slip.n) n, moment
kn I turn + (ks J - kn I) (turn.n) n, of slip = u2 - u1 - (ω1 + ω2)/2 × d and turn = ω2 - ω1.
Contacts and damping take no part. SI units. Cost: one linear system of six unknowns per layer.
"""
import math
from dataclasses import dataclass

import numpy

TENSION, COMPRESSION, BENDING = "tension", "compression", "bending"
CYCLES = ((0.5, 0.5 / math.sqrt(3)), (-0.5, 0.5 / math.sqrt(3)), (0.0, -1 / math.sqrt(3)))  # to the layer above, over D


@dataclass
class Ice:
    """A material and its spheres: diameter [m], density [kg/m3], modulus of the bonds [Pa], κ [-], strengths [Pa], angle by
    which compression raises the shear strength [degrees]."""
    diameter: float
    density: float
    young: float
    stiffness_ratio: float
    tensile_strength: float = math.inf
    shear_strength: float = math.inf
    friction_angle: float = 0.0


def cross_matrix(v):
    """The matrix of v ×."""
    return numpy.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def bond_directions(layers):
    """(lower layer, upper layer, d/D) of the bonds of one cell."""
    half = math.sqrt(3) / 2
    bonds = [(k, k, (c, s, 0.0)) for k in range(layers) for c, s in ((1.0, 0.0), (0.5, half), (-0.5, half))]
    for k in range(layers - 1):
        sign = 1 if k % 2 == 0 else -1
        bonds += [(k, k + 1, (sign * x, sign * y, math.sqrt(2 / 3))) for x, y in CYCLES]
    return bonds


class Plate:
    """The endless plate of some layers: `load` answers to a load, the methods below it to questions."""

    def __init__(self, ice, layers):
        self.ice, self.layers = ice, layers
        self.thickness = ice.diameter * (1 + math.sqrt(2 / 3) * (layers - 1))  # lowest to highest point [m]
        self.area = math.sqrt(3) / 2 * ice.diameter**2                         # of the cell [m2]
        self.bonds = [self.bond(*which) for which in bond_directions(layers)]
        self.relax()

    def bond(self, lower, upper, direction):
        """(n, stiffness 6x6, slip and turn per shift of the spheres 6 x 6 layers, the same per ε and χ 6x6)."""
        ice, n = self.ice, numpy.array(direction)
        d, radius = ice.diameter * n, ice.diameter / 2
        area, kn = math.pi * radius**2, ice.young / ice.diameter
        ks, along = kn / ice.stiffness_ratio, numpy.outer(n, n)
        stiffness = numpy.zeros((6, 6))
        stiffness[:3, :3] = area * (ks * numpy.eye(3) + (kn - ks) * along)
        stiffness[3:, 3:] = area * radius**2 / 4 * (kn * numpy.eye(3) + (2 * ks - kn) * along)
        of_shifts = numpy.zeros((6, 6 * self.layers))
        for layer, sign in ((lower, -1), (upper, 1)):
            of_shifts[:, 6 * layer:6 * layer + 6] += numpy.block(
                [[sign * numpy.eye(3), 0.5 * cross_matrix(d)], [numpy.zeros((3, 3)), sign * numpy.eye(3)]])
        height = (lower - (self.layers - 1) / 2) * math.sqrt(2 / 3) * ice.diameter
        ends = [self.field(point) for point in (numpy.array((0, 0, height)), d + numpy.array((0, 0, height)))]
        of_plate = ends[1] - ends[0]
        of_plate[:3] += 0.5 * cross_matrix(d) @ (ends[0][3:] + ends[1][3:])
        return n, stiffness, of_shifts, of_plate

    @staticmethod
    def field(r):
        """Displacement and rotation at r per ε and χ (xx, yy, xy each; 6 x 6)."""
        x, y, z = r
        strain = numpy.array([[x, 0, y / 2], [0, y, x / 2], [0, 0, 0]])
        curvature = numpy.vstack((-z * strain[:2], (x * x / 2, y * y / 2, x * y / 2)))
        turn = numpy.array([[0, y, x / 2], [-x, 0, -y / 2], [0, 0, 0]])
        return numpy.block([[strain, curvature], [numpy.zeros((3, 3)), turn]])

    def relax(self):
        """Shifts per ε and χ of least energy; stiffness of the plate per area [N/m], [N], [N m]."""
        total = lambda a, b: sum(bond[a].T @ bond[1] @ bond[b] for bond in self.bonds)
        self.shifts = -numpy.linalg.pinv(total(2, 2), rcond=1e-12) @ total(2, 3)
        self.stiffness = (total(3, 3) + total(3, 2) @ self.shifts) / self.area
        self.compliance = numpy.linalg.inv(self.stiffness)

    def young(self):
        """E in the plate's plane, over the section from lowest to highest point [Pa]."""
        return 1 / (self.compliance[0, 0] * self.thickness)

    def bending_young(self):
        """E that a beam of the plate shows in bending, 12 D/thickness^3 [Pa]."""
        return 12 / (self.compliance[3, 3] * self.thickness**3)

    def poisson(self):
        """ν in the plate's plane [-]."""
        return -self.compliance[1, 0] / self.compliance[0, 0]

    def wave_speed(self):
        """Of long plane waves in the plate's plane, straight fronts, no strain along them [m/s]."""
        mass = self.ice.density * math.pi / 6 * self.ice.diameter**3 * self.layers / self.area
        return math.sqrt(self.stiffness[0, 0] / mass)

    def first_failure(self, load):
        """(nominal stress [Pa] at which the first bond breaks, its mode) along x; in bending stress of the outer fibre."""
        forces = {TENSION: (0, self.thickness), COMPRESSION: (0, -self.thickness), BENDING: (3, self.thickness**2 / 6)}
        index, per_stress = forces[load]
        motion = self.compliance[:, index] * per_stress
        return min(self.strength_over_stress(bond, motion) for bond in self.bonds)

    def strength_over_stress(self, bond, motion):
        """(strength over the stress that ε and χ bring on a bond, mode)."""
        n, stiffness, of_shifts, of_plate = bond
        load = stiffness @ (of_shifts @ (self.shifts @ motion) + of_plate @ motion)
        force, moment = load[:3], load[3:]
        radius = self.ice.diameter / 2
        area = math.pi * radius**2
        bending = numpy.linalg.norm(moment - n * (n @ moment))
        sigma = (n @ force) / area + 4 * bending / (area * radius)
        tau = numpy.linalg.norm(force - n * (n @ force)) / area + 2 * abs(n @ moment) / (area * radius)
        tension = self.ice.tensile_strength / sigma if sigma > 0 else math.inf
        over = tau + math.tan(math.radians(self.ice.friction_angle)) * min(n @ force, 0.0) / area
        shear = self.ice.shear_strength / over if over > 0 else math.inf
        return (tension, "tension") if tension < shear else (shear, "shear")


def main():
    """Prints the table of the paper's ice."""
    print(" kappa  E/E_b  E_bend/E_b  poisson  c [m/s]   first failure [MPa]: tension  compression  bending")
    for kappa in (1, 2, 2.66, 4.1, 5):
        plate = Plate(Ice(0.0024, 900.0, 0.5e9, kappa, 1.2e6, 0.8e6), 8)
        first = [plate.first_failure(load) for load in (TENSION, COMPRESSION, BENDING)]
        print(f"{kappa:6.3g} {plate.young() / 0.5e9:6.3f} {plate.bending_young() / 0.5e9:9.3f} {plate.poisson():10.3f}"
              f" {plate.wave_speed():8.0f}          " + " ".join(f"{1e-6 * s:6.3f} {mode}" for s, mode in first))


if __name__ == "__main__":
    main()
