"""A plate of ice in hexagonal close packing under in-plane tension by given forces, frazilDem alone.

stiffness   E/E_b of the paper's ice (kappa 2.66) against lattice sums, 1.546, within 2 %
stress      the per-particle tensor's mean times the solid share, and the virial of `compute pressure`: load over section
theory      cases/tools/lattice.py, the reference of the ice cases, gives the lattice sums known for three ratios

Other ratios and the first failure: cases/ice_tension, whose check has the same reference.

The plate is 24 x 36 x 8 spheres with close-packed rows along x. The spheres of three columns at both ends are pulled by
equal forces, which leaves them free to thin with the rest; a viscous drag lets the plate come to rest. Strain: slope of the mean displacement over the middle half. Section: width and thickness over
all spheres, as the paper gives its plate (16.12 mm for eight layers). Spheres are 0.5 % smaller than the spacing, discs are not: the plate thins as it is
pulled, and Hertz contacts would take part.
"""

import math
import statistics
import sys
from pathlib import Path

from bond_dem import *

import lattice

SIZE = 0.995 * D
NX, NY, NZ = 24, 36, 8
ROW, LAYER = D * math.sqrt(3) / 2, D * math.sqrt(2 / 3)
WIDTH, THICKNESS = (NY - 1) * ROW + D, (NZ - 1) * LAYER + D
SECTION = WIDTH * THICKNESS  # [m2]
GRIP = 3  # columns
REFERENCE = {1: 2.093, 2.66: 1.546, 5: 1.354}
SCRIPT = """
timestep {step:.17g}
group left id {left}
group right id {right}
{bonds}
fix integrate all nve/sphere
fix drag all viscous {drag:.17g}
variable pull equal {force:.17g}*(step>={ramp})+{force:.17g}*(step<{ramp})*step/{ramp}
variable back equal -v_pull
fix a left addforce v_back 0 0
fix b right addforce v_pull 0 0
compute heat all temp
compute virial all pressure heat virial
thermo_style custom step v_pull f_bonds[2] c_virial[1] vol
thermo_modify format float %.17g
thermo {every}
{dump}
run {steps}
"""


def specimen():
    """Centres, ids of both grips, centred about x = 0; grips are whole columns of the lattice."""
    points = hcp(NX, NY, NZ)
    ids = lambda chosen: " ".join(str(n + 1) for n in range(len(points)) if chosen(n % NX))
    middle = 0.5 * (max(p[0] for p in points) + min(p[0] for p in points))
    return [add(p, [middle, 0, 0], -1) for p in points], ids(lambda i: i < GRIP), ids(lambda i: i >= NX - GRIP)


def pull(check, kappa, stress, ramp, steps, **strengths):
    """Raises the stress [Pa] over `ramp` steps and goes on to `steps`. The run, the centres."""
    points, left, right = specimen()
    step = 0.1 * (1.26e-6 if kappa > 2 else 0.81e-6)
    bonds = bond(kappa=kappa, more=f"radius_factor {D / SIZE:.17g} create_gap 0.02 events events.csv", **strengths)
    text = head(data_file="plate.data") + MODEL
    text += SCRIPT.format(step=step, left=left, right=right, bonds=bonds, drag=0.4, ramp=ramp, steps=steps, every=50,
                          force=stress * SECTION / (GRIP * NY * NZ), dump=dump("d", steps, "x f_bonds[3]"))
    box = f"{points[0][0] - 0.02} {points[-1][0] + 0.02} -0.01 {WIDTH + 0.01} -0.01 {THICKNESS + 0.01}"
    return check.run(text, files={"plate.data": data([(p, SIZE, RHO) for p in points], box)}), points


def stiffness(check, kappa):
    ramp, steps, stress = 2000, 7000, 1e6
    run, points = pull(check, kappa, stress, ramp, steps)
    first, last = run.rows("d", 0), run.rows("d", steps)
    gauge = [i for i, p in enumerate(points, 1) if abs(p[0]) < NX * D / 4]
    x = [points[i - 1][0] for i in gauge]
    u = [last[i][0] - first[i][0] for i in gauge]
    slope = sum(a * b for a, b in zip(x, u)) / sum(a * a for a in x)
    check.near(f"E/E_b for kappa {kappa}", stress / slope / E, REFERENCE[kappa], 0.02)
    sphere = math.pi / 6 * SIZE**3
    solid = len(points) * sphere / (NX * D * SECTION)
    mean = statistics.mean(last[i][1] for i in gauge) * solid
    check.near(f"mean stress of the particles, kappa {kappa}, and load over section", mean, stress, 0.02)
    total = sphere * sum(row[1] for row in last.values())
    _, _, _, pressure, volume = run.thermo()[-1]
    check.near(f"virial of compute pressure, kappa {kappa}, and the particles' stress", -pressure * volume, total, 1e-6)


def theory(check):
    plates = {kappa: lattice.Plate(lattice.Ice(D, RHO, E, kappa, SIGMA_C, TAU_C), NZ) for kappa in REFERENCE}
    for kappa, plate in plates.items():
        check.near(f"lattice.py, E/E_b for kappa {kappa}", plate.young() / E, REFERENCE[kappa], 5e-4)
    check.near("lattice.py, first failure in tension [Pa]", plates[2.66].first_failure(lattice.TENSION)[0], 1.86e6, 5e-3)
    thick = lattice.Plate(lattice.Ice(D, RHO, E, 1, SIGMA_C, TAU_C), 4 * NZ)  # its faces matter less
    check.near("lattice.py, modulus in bending of a thick plate", thick.bending_young(), thick.young(), 0.06)


def main():
    check = Check()
    theory(check)
    stiffness(check, 2.66)
    check.finish()


if __name__ == "__main__":
    main()
