"""Rigid rotation leaves the loads of a bond unchanged in the co-rotating frame, to 1e-6 of the breaking load.

1. Prescribed: the pair is loaded in all four modes, then turned 10 times as one rigid body about an axis that is
   parallel, perpendicular or oblique to the bond. After whole turns forces and torques must be what they were.
2. Free: a pair spins about its centre of mass across the bond; only the centripetal tension m w^2 L/2 appears.
"""

import math

from bond_dem import *

L = 1.004 * D
DT = 1e-7
TURNS, STEPS_PER_TURN = 10, 400
FORCE_SCALE = TAU_C * A  # breaking load [N]
TORQUE_SCALE = 0.5 * L * FORCE_SCALE


def preload(n):
    """Motion that loads stretch, shear, bending and torsion to parts of their strengths within 500 steps."""
    t = across(n)
    time = 500 * DT
    velocity = add(scaled(n, 0.2 * SIGMA_C / E * L / time), t, 0.3 * TAU_C * KAPPA / E * L / time)
    angle = 0.2 * SIGMA_C / E * L / R
    axis = unit(add(n, cross(n, t), 0.7))
    return (
        f"fix move_one one move rotate 0 0 0 {vec(axis)} {-2 * math.pi * time / angle:.17g}\n"
        f"fix move_two two move linear {vec(velocity)}\nrun 500\nunfix move_one\nunfix move_two\n"
    )


def prescribed(check, name, n, axis_name, axis):
    period = STEPS_PER_TURN * DT
    steps = TURNS * STEPS_PER_TURN
    script = head() + MODEL + spheres([[0, 0, 0], scaled(n, L)]) + f"timestep {DT}\n" + bond()
    script += "group one id 1\ngroup two id 2\n" + dump("d", 100, "fx fy fz tqx tqy tqz") + preload(n)
    script += f"fix spin all move rotate {vec(scaled(n, 0.3 * D))} {vec(axis)} {period:.17g}\nrun {steps}\n"
    run = check.run(script)
    before, after = run.rows("d", 500), run.rows("d", 500 + steps)
    for i in (1, 2):
        force = norm(add(after[i][:3], before[i][:3], -1)) / FORCE_SCALE
        torque = norm(add(after[i][3:], before[i][3:], -1)) / TORQUE_SCALE
        loaded = norm(before[i][:3]) / FORCE_SCALE
        check.true(f"bond along {name}, 10 turns about {axis_name} axis, sphere {i}", max(force, torque) <= 1e-6 and loaded > 0.1,
                   f"load {loaded:.2f} of breaking; change of force {force:.1e}, of torque {torque:.1e} <= 1e-6")


def centripetal(omega):
    """Tension m w^2 d/2 at the stretched length d, where the spin has slowed to keep the angular momentum."""
    inertia = lambda d: MASS * d**2 / 2 + 0.8 * MASS * R**2
    stretched = L
    for _ in range(20):
        pull = MASS * (omega * inertia(L) / inertia(stretched))**2 * stretched / 2
        stretched = L + pull / (E * A / L)
    return pull


def free(check, name, n):
    axis = across(n)
    turns, dt = 10, 1e-7
    omega = 2 * math.pi * turns / (40000 * dt)  # [rad/s]
    half = scaled(n, 0.5 * L)
    speed = scaled(cross(axis, half), omega)
    script = head() + MODEL + spheres([scaled(half, -1), half]) + f"timestep {dt}\n" + bond(more="damping 0.2")
    for i, sign in ((1, -1), (2, 1)):
        v, w = scaled(speed, sign), scaled(axis, omega)
        script += f"group g{i} id {i}\nvelocity g{i} set {vec(v)} units box\n"
        script += f"set group g{i} omegax {w[0]:.17g} omegay {w[1]:.17g} omegaz {w[2]:.17g}\n"
    script += "fix nve all nve/sphere\n" + dump("d", 40000, "x y z fx fy fz tqx tqy tqz") + "run 40000\n"
    rows = check.run(script).rows("d", 40000)
    d = unit(add(rows[2][:3], rows[1][:3], -1))
    f = rows[1][3:6]
    check.near(f"free spin along {name}: tension", dot(f, d), centripetal(omega), 1e-5)
    shear = norm(add(f, d, -dot(f, d))) / FORCE_SCALE
    moment = norm(rows[1][6:9]) / TORQUE_SCALE
    check.true(f"free spin along {name}: shear and moments", max(shear, moment) <= 1e-6, f"{shear:.1e}, {moment:.1e} <= 1e-6")


def main():
    check = Check()
    for name, n in DIRECTIONS.items():
        axes = {"a parallel": n, "a perpendicular": across(n), "an oblique": unit([0.2, 0.6, -0.9])}
        for axis_name, axis in axes.items():
            prescribed(check, name, n, axis_name, axis)
        free(check, name, n)
    check.finish()


main()
