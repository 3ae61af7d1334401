"""Two bonded spheres pulled, sheared, bent, twisted: F = k A delta, M = k I theta, and the step of breaking.

The motion is prescribed (fix move); forces and torques are read from the spheres. Bonds along x, a face diagonal and
a random direction. Loads follow to 1e-6 and the bond breaks within one step of the formula's.
"""

import math

from bond_dem import *

L = 1.004 * D  # a small gap, so that no contact force is mixed in
DT = 1e-8
STEPS = 1000
KN, KS = E * A / L, E * A / L / KAPPA  # [N/m]
KB, KT = E * I / L, E * J / L / KAPPA  # [N m]


def pair(check, n, motion, bonds, steps=STEPS, more=""):
    script = head() + MODEL + spheres([[0, 0, 0], scaled(n, L)]) + f"timestep {DT}\n" + bonds
    script += "group one id 1\ngroup two id 2\n" + motion
    script += dump("d", steps, "fx fy fz tqx tqy tqz") + "thermo_style custom step f_bonds[1] f_bonds[3] f_bonds[4]\n"
    return check.run(script + more + f"run {steps}\n")


def turning(group, centre, axis, rate):
    return f"fix move_{group} {group} move rotate {vec(centre)} {vec(axis)} {2 * math.pi / rate:.17g}\n"


def still(group):
    return f"fix move_{group} {group} move linear 0 0 0\n"


def moving(group, velocity):
    return f"fix move_{group} {group} move linear {vec(velocity)}\n"


def vector_near(check, what, measured, reference, tolerance, scale):
    error = norm(add(measured, reference, -1)) / scale
    check.true(what, error <= tolerance, f"|{norm(measured):.9g}| reference |{norm(reference):.9g}| error {error:.2e} <= {tolerance:g}")


def loads(check, name, n):
    t = across(n)
    b = cross(n, t)
    time = DT * STEPS
    delta = 1e-4 * L
    angle = 1e-4
    cases = {
        "pull": (still("one") + moving("two", scaled(n, delta / time)), scaled(n, KN * delta), [0, 0, 0]),
        "push": (still("one") + moving("two", scaled(n, -delta / time)), scaled(n, -KN * delta), [0, 0, 0]),
        "bend": (turning("one", [0, 0, 0], t, -0.5 * angle / time) + turning("two", scaled(n, L), t, 0.5 * angle / time),
                 [0, 0, 0], scaled(t, KB * angle)),
        "twist": (still("one") + turning("two", scaled(n, L), n, angle / time), [0, 0, 0], scaled(n, KT * angle)),
    }
    for case, (motion, force, moment) in cases.items():
        rows = pair(check, n, motion, bond()).rows("d", STEPS)
        for i, sign in ((1, 1), (2, -1)):
            vector_near(check, f"{case} along {name}, force on {i}", rows[i][:3], scaled(force, sign), 1e-6, KN * delta)
            vector_near(check, f"{case} along {name}, torque on {i}", rows[i][3:], scaled(moment, sign), 1e-6, KB * angle)
    shear = still("one") + moving("two", scaled(t, delta / time))
    rows = pair(check, n, shear, bond()).rows("d", STEPS)
    # At a finite angle phi = atan(delta/L) the slip is the path along the turning tangent; the spring stretches.
    phi = math.atan(delta / L)
    along = add(scaled(n, math.cos(phi)), t, math.sin(phi))
    tangent = add(scaled(t, math.cos(phi)), n, -math.sin(phi))
    force = add(scaled(tangent, KS * L * math.asinh(delta / L)), along, KN * (math.hypot(L, delta) - L))
    torque = scaled(b, 0.5 * math.hypot(L, delta) * KS * L * math.asinh(delta / L))
    vector_near(check, f"shear along {name}, force on 1", rows[1][:3], force, 1e-6, KS * delta)
    vector_near(check, f"shear along {name}, force on 2", rows[2][:3], scaled(force, -1), 1e-6, KS * delta)
    for i in (1, 2):
        vector_near(check, f"shear along {name}, torque on {i}", rows[i][3:], torque, 1e-6, 0.5 * L * KS * delta)


def breaking(check, name, n):
    """Each mode is driven to 1.5 times its strength; sigma and tau include the moments with factor 1."""
    t = across(n)
    time = DT * STEPS
    delta, angle = SIGMA_C * A / KN, SIGMA_C * I / (R * KB)
    slip, twist = L * math.sinh(TAU_C * A / (KS * L)), TAU_C * J / (R * KT)
    pull = still("one") + moving("two", scaled(n, 1.5 * delta / time))
    shear = still("one") + moving("two", scaled(t, 1.5 * slip / time))
    bend = (turning("one", [0, 0, 0], t, -0.75 * angle / time) + turning("two", scaled(n, L), t, 0.75 * angle / time))
    torsion = still("one") + turning("two", scaled(n, L), n, 1.5 * twist / time)
    push = still("one") + moving("two", scaled(n, -3 * delta / time))
    for case, motion, mode in (("pull", pull, "tension"), ("shear", shear, "shear"), ("bend", bend, "tension"),
                               ("twist", torsion, "shear")):
        run = pair(check, n, motion, bond(tensile=SIGMA_C, shear=TAU_C, more="events events.csv"))
        event = run.events()[0]
        step = float(event["time"]) / DT
        check.near(f"{case} along {name} breaks in {event['mode']}, at step", step, STEPS / 1.5, 1, scale=1)
        check.true(f"{case} along {name}, mode", event["mode"] == mode, f"{event['mode']}, expected {mode}")
        check.true(f"{case} along {name}, counts", run.thermo()[-1][1:] == [0, mode == "tension", mode == "shear"],
                   str(run.thermo()[-1]))
    run = pair(check, n, push, bond(tensile=SIGMA_C, shear=TAU_C))
    check.true(f"compression to 3 sigma_c along {name}: no break", run.thermo()[-1][1] == 1, str(run.thermo()[-1]))


def friction(check, n):
    """Mohr-Coulomb: under compression to 0.5 sigma_c first, tau_c grows by tan(30 deg) times the compression."""
    t = across(n)
    squeeze = 0.5 * SIGMA_C * A / KN
    grown = TAU_C + 0.5 * SIGMA_C * math.tan(math.radians(30))
    time = DT * STEPS
    angle = grown * J / (R * KT)
    first = still("one") + moving("two", scaled(n, -squeeze / time))
    centre = scaled(n, L - squeeze)
    then = "unfix move_two\n" + turning("two", centre, n, 1.5 * angle / time) + f"run {STEPS}\n"
    script = head() + MODEL + spheres([[0, 0, 0], scaled(n, L)]) + f"timestep {DT}\n"
    script += bond(tensile=SIGMA_C, shear=TAU_C, more="friction_angle 30 events events.csv")
    script += "group one id 1\ngroup two id 2\n" + first + f"run {STEPS}\n" + then
    step = float(check.run(script).events()[0]["time"]) / DT - STEPS
    check.near("friction_angle 30 under compression, twist breaks at step", step, STEPS / 1.5, 1, scale=1)


def main():
    check = Check()
    for name, n in DIRECTIONS.items():
        loads(check, name, n)
        breaking(check, name, n)
    friction(check, DIRECTIONS["random"])
    check.finish()


main()
