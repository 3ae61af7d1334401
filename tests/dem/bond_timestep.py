"""The critical time step that fix bond/parallel finds: bonds, contacts, damping; refused above, stable just below.

bonds      2/omega_max of a free pair (axial 2 kn A/m, or rocking ks A (2 + 5 (L/D)^2)/m) and of the paper's HCP plate
contacts   overlap: max(kn/m*, kt (1/m* + 2 R^2/I)), kn = 2 E* sqrt(R* d), kt = 8 G* sqrt(R* d); speed: the same for a
           sphere that hits something heavy, at Hertz's overlap
damping    (sqrt(a^2 + 4 w^2) - a)/w^2, a = eta w^2, eta the largest dashpot over spring
stability  a pair that is kicked in all modes stays bounded over 20,000 steps at 0.97 of the limit
"""

import math
import re

from bond_dem import *

S = 1.004 * D  # distance of a pair [m]: no contact
KN = E * A / S
YOUNG, POISSON = 5e8, 0.33  # of MODEL [Pa], [-]


def message(check, script, **options):
    """What the fix says of a time step that is far too long."""
    output = check.run(script + "timestep 1\nrun 1\n", expect_failure=True, **options).output
    return next(line for line in output.splitlines() if "critical" in line)


def number(text, before):
    """The number behind a word."""
    return float(re.search(before + r" ([\d.e+-]+) s", text).group(1))


def pair(distance=S, more="", kappa=KAPPA):
    return head() + MODEL + spheres([[0, 0, 0], [distance, 0, 0]]) + bond(kappa=kappa, more=more)


def stiffest(kappa):
    """Square of a free pair's largest frequency [1/s2]."""
    return max(2 * KN, KN / kappa * (2 + 5 * (S / D)**2)) / MASS


def bonds(check):
    for kappa in (0.2, 2.66, 50):
        found = number(message(check, pair(kappa=kappa)), "bonds alone")
        check.near(f"bonds of a pair, kappa {kappa} [s]", found, 2 / math.sqrt(stiffest(kappa)), 1e-3)
    box = "-0.01 0.05 -0.01 0.05 -0.01 0.05"
    plate = {"plate.data": data([(c, D, RHO) for c in hcp(16, 18, 8)], box)}
    for kappa, reference in ((1, 0.81e-6), (2.66, 1.26e-6)):
        for ranks in (1, 2):
            script = head(box, data_file="plate.data") + MODEL + bond(kappa=kappa)
            found = number(message(check, script, ranks=ranks, files=plate), "critical")
            check.near(f"HCP, kappa {kappa}, {ranks} ranks [s]", found, reference, 1e-2)


def contact_square(overlap, radius, per_mass):
    """Square of a contact's largest frequency [1/s2]."""
    normal, tangential = YOUNG / (2 * (1 - POISSON**2)), YOUNG / (4 * (2 - POISSON) * (1 + POISSON))
    root = math.sqrt(radius * overlap)
    return root * max(2 * normal * per_mass, 8 * tangential * 3.5 * per_mass)


def contacts(check):
    overlap = 0.01 * D
    text = message(check, pair(D - overlap))
    square = contact_square(overlap, R / 2, 2 / MASS)
    check.near("contact at an overlap [s]", number(text, "contacts alone"), 2 / math.sqrt(square), 1e-3)
    together = (2 / number(text, "critical"))**2 - (2 / number(text, "bonds alone"))**2
    check.near("bonds and contacts add up [1/s2]", together, square, 5e-3)

    for name, motion, speed in (("spheres", "velocity all set 10 0 0\nvelocity one set -10 0 0\n", 20), ("one way", "velocity all set 0 3 4\n", 5)):
        depth = (15 * MASS * speed**2 * 2 * (1 - POISSON**2) / (16 * YOUNG * math.sqrt(R)))**0.4
        found = number(message(check, pair() + "group one id 1\n" + motion), "contacts alone")
        check.near(f"contact to come at {speed} m/s, {name} [s]", found, 2 / math.sqrt(contact_square(depth, R, 1 / MASS)), 1e-3)


def limit(square, fraction):
    """Stable step of a damped pair [s]: dashpot over spring of shear, normal, torsion, bending, 2 zeta sqrt(m*/k)."""
    slowest = 2 * fraction * math.sqrt(max(0.5, 0.5 * KAPPA, 0.4 * KAPPA, 0.8) * MASS / KN)
    a = slowest * square
    return (math.sqrt(a * a + 4 * square) - a) / square


def damping(check):
    for fraction in (0.05, 0.5):
        found = number(message(check, pair(more=f"damping {fraction}")), "limit to")
        check.near(f"limit with damping {fraction} [s]", found, limit(stiffest(KAPPA), fraction), 2e-3)


def stability(check):
    for fraction in (0, 0.5):
        dt = 0.97 * limit(stiffest(KAPPA), fraction)
        script = pair(more=f"damping {fraction}") + f"timestep {dt:.17g}\ngroup two id 2\n"
        script += "velocity two set 1e-3 2e-3 -1e-3\nset group two omegax 1 omegay 2 omegaz -1\nfix nve all nve/sphere\n"
        script += "compute rot all erotate/sphere\nvariable total equal ke+c_rot+f_bonds[5]\n"
        script += "thermo_style custom step v_total ke f_bonds[5]\nthermo_modify norm no format float %.9g\nthermo 20\nrun 20000\n"
        energy = [row[1] for row in check.run(script).thermo()]
        check.true(f"stable at 0.97 of the limit, damping {fraction}", max(energy) < 20 * energy[0], f"{max(energy) / energy[0]:.3g} of the first energy")


def main():
    check = Check()
    for case in (bonds, contacts, damping, stability):
        case(check)
    check.finish()


main()
