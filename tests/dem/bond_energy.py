"""Energy while a plate breaks: kinetic + elastic + contact + dissipated + released = what the striker brought, to 1e-3.

A heavy sphere strikes a small HCP plate at 20 m/s. Contacts are Hertzian without loss (restitution 1, no friction), so
that all energy can be counted: kinetic energy and that of the bonds from the run, the contacts' 2/5 k d^2.5 from the
positions. Without and with dashpots in the bonds.

    bond_energy.py --dem PROGRAM [--plot FILE]     --plot draws the balance against time
"""

import itertools
import math
import sys

from bond_dem import *

MODULUS, POISSON = 5e8, 0.33  # of the contacts [Pa], [-]
STRIKER = 0.008  # diameter [m]
SPEED = 20.0  # [m/s]
COLUMNS, ROWS, LAYERS = 9, 9, 3
STEP, STEPS, EVERY = 5e-8, 6000, 60

CONTACTS = f"""
fix m1 all property/global youngsModulus peratomtype {MODULUS}
fix m2 all property/global poissonsRatio peratomtype {POISSON}
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
pair_style gran model hertz tangential off
pair_coeff * *
"""


def plate_and_striker():
    points = hcp(COLUMNS, ROWS, LAYERS)
    middle = [(min(axis) + max(axis)) / 2 for axis in zip(*points)]
    top = max(p[2] for p in points)
    spheres = [(add(p, [middle[0], middle[1], 0], -1), D, RHO) for p in points]
    height = top + D / 2 + STRIKER / 2 + 1e-5
    return spheres + [([3e-4, 2e-4, height], STRIKER, 1500.0)]


def contact_energy(rows, diameters):
    """Σ 2/5 k d^2.5, k = 4/3 E* √R*, over the overlaps d of a dump's rows [J]."""
    modulus = MODULUS / (2 * (1 - POISSON**2))
    cells = {}
    size = STRIKER / 2 + D
    for i, row in rows.items():
        cells.setdefault(tuple(math.floor(c / size) for c in row[:3]), []).append(i)
    total = 0
    for cell, members in cells.items():
        around = [j for shift in itertools.product((-1, 0, 1), repeat=3)
                  for j in cells.get(tuple(a + b for a, b in zip(cell, shift)), [])]
        for i, j in ((i, j) for i in members for j in around if i < j):
            r1, r2 = diameters[i] / 2, diameters[j] / 2
            overlap = r1 + r2 - math.dist(rows[i][:3], rows[j][:3])
            if overlap > 0:
                total += 8 / 15 * modulus * math.sqrt(r1 * r2 / (r1 + r2)) * overlap**2.5
    return total


def kinetic_energy(rows, spheres):
    """Of translation and spin [J]."""
    total = 0
    for i, row in rows.items():
        _, diameter, density = spheres[i - 1]
        mass = density * math.pi / 6 * diameter**3
        total += 0.5 * mass * dot(row[3:6], row[3:6]) + 0.05 * mass * diameter**2 * dot(row[6:9], row[6:9])
    return total


def balance(check, damping):
    """Rows of (time, kinetic, bonds, contacts, dashpots, fracture) [s], [J]; number of broken bonds."""
    spheres = plate_and_striker()
    diameters = {i: s[1] for i, s in enumerate(spheres, 1)}
    box = "-0.03 0.03 -0.03 0.03 -0.03 0.03"
    script = head(skin=0.001, data_file="plate.data") + CONTACTS + f"timestep {STEP}\n"
    script += f"group ice id <= {len(spheres) - 1}\ngroup striker id {len(spheres)}\n"
    script += bond(group="ice", tensile=SIGMA_C, shear=TAU_C, more=f"create_gap 0.001 damping {damping}")
    script += f"fix integrate all nve/sphere\nvelocity striker set 0 0 {-SPEED}\n"
    script += "thermo_style custom step f_bonds[2] f_bonds[5] f_bonds[6] f_bonds[9]\nthermo_modify format float %.17g\n"
    script += f"thermo {EVERY}\n" + dump("d", EVERY, "x y z vx vy vz omegax omegay omegaz") + f"run {STEPS}\n"
    run = check.run(script, files={"plate.data": data(spheres, box)})
    rows = []
    for step, _, elastic, lost, released in run.thermo():
        at = run.rows("d", int(step))
        rows.append((step * STEP, kinetic_energy(at, spheres), elastic, contact_energy(at, diameters), lost - released, released))
    return rows, run.thermo()[-1][1]


def plot(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    time, *parts = zip(*rows)
    figure, axes = pyplot.subplots(figsize=(6, 4))
    axes.stackplot([1e3 * t for t in time], [[1e3 * e for e in part] for part in parts],
                   labels=("kinetic", "bonds, elastic", "contacts, elastic", "dashpots", "fracture"))
    axes.set(xlabel="time [ms]", ylabel="energy [mJ]", xlim=(0, 1e3 * time[-1]))
    axes.legend(loc="lower left")
    figure.savefig(path, dpi=150, bbox_inches="tight")


def main():
    path = None
    if "--plot" in sys.argv:
        at = sys.argv.index("--plot")
        path = sys.argv[at + 1]
        del sys.argv[at:at + 2]
    check = Check()
    for damping in (0, 0.1):
        rows, broken = balance(check, damping)
        sums = [sum(row[1:]) for row in rows]
        worst = max(abs(s / sums[0] - 1) for s in sums)
        last = rows[-1]
        check.true(f"damping {damping}: bonds break", broken > 20, f"{broken:g} broken")
        check.near(f"damping {damping}: balance, worst of {len(rows)} instants", sums[0] * (1 + worst), sums[0], 1e-3)
        print("     shares at the end: " + ", ".join(f"{name} {part / sums[0]:.4f}" for name, part in zip(
            ("kinetic", "bonds", "contacts", "dashpots", "fracture"), last[1:])))
        check.true(f"damping {damping}: dashpots take energy only if there are any", (last[4] > 0) == (damping > 0))
    if path:
        plot(rows, path)
    check.finish()


main()
