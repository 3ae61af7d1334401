"""A sphere strikes a wall at 1 m/s without loss: Hertz's overlap, force and duration within 1 %, frazilDem alone.

    K = 4/3 E* sqrt(R),  overlap (5 m V^2/4K)^0.4,  force K overlap^1.5,  duration 2.943 overlap/V
"""

import math

from bond_dem import *

YOUNG, POISSON, SPEED, STEP = 5e8, 0.33, 1.0, 1e-8

SCRIPT = f"""
fix m1 all property/global youngsModulus peratomtype {YOUNG}
fix m2 all property/global poissonsRatio peratomtype {POISSON}
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
pair_style gran model hertz tangential off
pair_coeff * *
fix wall all wall/gran model hertz tangential off primitive type 1 zplane 0
fix integrate all nve/sphere
timestep {STEP}
velocity all set 0 0 {-SPEED}
compute force all reduce sum fz
compute height all reduce max z
compute speed all reduce max vz
thermo_style custom step c_force c_height c_speed
thermo_modify format float %.17g
thermo 1
run 5000
"""


def main():
    check = Check()
    modulus = YOUNG / (2 * (1 - POISSON**2))
    stiffness = 4 / 3 * modulus * math.sqrt(R)
    overlap = (5 * MASS * SPEED**2 / (4 * stiffness))**0.4
    rows = check.run(head() + spheres([[0, 0, R + 1e-7]]) + SCRIPT).thermo()
    pressed = [row for row in rows if row[1] > 0]
    check.near("greatest overlap [m]", R - min(row[2] for row in rows), overlap, 0.01)
    check.near("greatest force [N]", max(row[1] for row in rows), stiffness * overlap**1.5, 0.01)
    check.near("duration [s]", len(pressed) * STEP, 2.943 * overlap / SPEED, 0.01)
    check.near("speed afterwards [m/s]", rows[-1][3], SPEED, 1e-3)
    check.finish()


main()
