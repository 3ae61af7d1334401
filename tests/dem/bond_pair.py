"""Two bonded spheres pulled, sheared, bent, twisted: F = k A delta, M = k I theta, and the step of breaking.

The motion is prescribed (fix move variable); forces and torques are read from the spheres. Bonds along x, a face diagonal
and a random direction; each case in a frame at rest, and in one that flies at 37 m/s and turns by 1.2 rad meanwhile. Loads
follow to 1e-6 in the frame and the bond breaks within one step of the formula's.
"""

import math

from bond_dem import *

L = 1.004 * D  # a small gap, so that no contact force is mixed in
DT = 1e-8
STEPS = 1000
TIME = DT * STEPS
KN, KS = E * A / L, E * A / L / KAPPA  # [N/m]
KB, KT = E * I / L, E * J / L / KAPPA  # [N m]
OBLIQUE = unit([0.2, 0.6, -0.9])
ZERO = [0, 0, 0]


class Frame:
    """A frame that flies [m/s] and has turned by `angle` [rad] about an axis through the origin at the end of a run."""

    def __init__(self, velocity=(0, 0, 0), axis=OBLIQUE, angle=0.0):
        self.velocity, self.axis, self.rate = list(velocity), axis, angle / TIME

    def turned(self, v, time=TIME):
        """A vector of the frame, seen from outside (Rodrigues)."""
        angle = self.rate * time
        result = add(scaled(v, math.cos(angle)), cross(self.axis, v), math.sin(angle))
        return add(result, self.axis, dot(self.axis, v) * (1 - math.cos(angle)))

    def path(self, name, group, start, shift, spin):
        """Script: the group's sphere moves in the frame from `start` by `shift` [m] within a run, evenly, and spins at
        `spin` [rad/s], which must be along the frame's axis if the frame turns."""
        a, text = self.axis, ""
        for k, c in enumerate("xyz"):
            part = lambda v: f"({v[0]:.17g}+v_share*({v[1]:.17g}))"
            place = part((start[k], shift[k]))
            aside = part((cross(a, start)[k], cross(a, shift)[k]))
            along = part((a[k] * dot(a, start), a[k] * dot(a, shift)))
            text += (f"variable {name}{c} equal {place}*cos(v_angle)+{aside}*sin(v_angle)+{along}*(1-cos(v_angle))"
                     f"+({self.velocity[k]:.17g})*v_now-({start[k]:.17g})\n")
        omega = add(spin, a, self.rate)
        moves = " ".join(f"v_{name}{c}" for c in "xyz")
        return text + f"fix {name} {group} move variable {moves} NULL NULL NULL\n" + "".join(
            f"set group {group} omega{c} {omega[k]:.17g}\n" for k, c in enumerate("xyz"))

    def clock(self):
        """Script: what the paths depend on."""
        return (f"variable now equal step*dt\nvariable share equal step*dt/{TIME:.17g}\n"
                f"variable angle equal step*dt*({self.rate:.17g})\n")


def frames(axis):
    """Both frames; the turning one about `axis`."""
    return {"at rest": Frame(), "moving and spinning": Frame((30, -20, 10), axis, 1.2)}


def pair(check, frame, n, shift, turn1, turn2, bonds, more=""):
    """Sphere 2 moves by `shift` against sphere 1, both turn by the angle vectors, in the frame, within STEPS steps."""
    script = head("-0.03 0.03 -0.03 0.03 -0.03 0.03") + MODEL + spheres([ZERO, scaled(n, L)]) + f"timestep {DT}\n" + bonds
    script += "group one id 1\ngroup two id 2\n" + frame.clock()
    script += frame.path("a", "one", ZERO, ZERO, scaled(turn1, 1 / TIME))
    script += frame.path("b", "two", scaled(n, L), shift, scaled(turn2, 1 / TIME))
    script += dump("d", STEPS, "fx fy fz tqx tqy tqz") + "thermo_style custom step f_bonds[1] f_bonds[3] f_bonds[4]\n"
    return check.run(script + more + f"run {STEPS}\n")


def vector_near(check, what, measured, reference, tolerance, scale):
    error = norm(add(measured, reference, -1)) / scale
    check.true(what, error <= tolerance, f"|{norm(measured):.9g}| reference |{norm(reference):.9g}| error {error:.2e} <= {tolerance:g}")


def modes(n, t, axial, slip, bend, twist):
    """The four modes driven to these amounts [m], [rad]: (shift, turn of 1, turn of 2, axis that a frame may turn about)."""
    return {"pull": (scaled(n, axial), ZERO, ZERO, OBLIQUE), "push": (scaled(n, -axial), ZERO, ZERO, OBLIQUE),
            "shear": (scaled(t, slip), ZERO, ZERO, OBLIQUE),
            "bend": (ZERO, scaled(t, -0.5 * bend), scaled(t, 0.5 * bend), t), "twist": (ZERO, ZERO, scaled(n, twist), n)}


def loads(check, name, n):
    t = across(n)
    delta = angle = 1e-4
    delta *= L
    # At a finite angle phi = atan(delta/L) the slip is the path along the turning tangent; the spring stretches.
    phi, slipped = math.atan(delta / L), KS * L * math.asinh(delta / L)
    along = add(scaled(n, math.cos(phi)), t, math.sin(phi))
    tangent = add(scaled(t, math.cos(phi)), n, -math.sin(phi))
    sheared = add(scaled(tangent, slipped), along, KN * (math.hypot(L, delta) - L))
    lever = scaled(cross(n, t), 0.5 * math.hypot(L, delta) * slipped)
    expected = {"pull": (scaled(n, KN * delta), ZERO, ZERO), "push": (scaled(n, -KN * delta), ZERO, ZERO),
                "shear": (sheared, lever, lever), "bend": (ZERO, scaled(t, KB * angle), scaled(t, -KB * angle)),
                "twist": (ZERO, scaled(n, KT * angle), scaled(n, -KT * angle))}
    scale = {"shear": (KS * delta, 0.5 * L * KS * delta)}
    for case, (shift, turn1, turn2, axis) in modes(n, t, delta, delta, angle, angle).items():
        force, *torques = expected[case]
        of_force, of_torque = scale.get(case, (KN * delta, KB * angle))
        for frame_name, frame in frames(axis).items():
            rows = pair(check, frame, n, shift, turn1, turn2, bond()).rows("d", STEPS)
            for i, sign in ((1, 1), (2, -1)):
                what = f"{case} along {name}, {frame_name}, {{}} on {i}"
                vector_near(check, what.format("force"), rows[i][:3], scaled(frame.turned(force), sign), 1e-6, of_force)
                vector_near(check, what.format("torque"), rows[i][3:], frame.turned(torques[i - 1]), 1e-6, of_torque)


def breaking(check, name, n):
    """Each mode is driven to 1.5 times its strength; sigma and tau include the moments with factor 1."""
    t = across(n)
    driven = modes(n, t, 1.5 * SIGMA_C * A / KN, 1.5 * L * math.sinh(TAU_C * A / (KS * L)), 1.5 * SIGMA_C * I / (R * KB),
                   1.5 * TAU_C * J / (R * KT))
    for case, mode in (("pull", "tension"), ("shear", "shear"), ("bend", "tension"), ("twist", "shear")):
        shift, turn1, turn2, axis = driven[case]
        for frame_name, frame in frames(axis).items():
            run = pair(check, frame, n, shift, turn1, turn2, bond(tensile=SIGMA_C, shear=TAU_C, more="events events.csv"))
            what, event = f"{case} along {name}, {frame_name}", run.events()[0]
            check.near(f"{what}, breaks at step", float(event["time"]) / DT, STEPS / 1.5, 1, scale=1)
            check.true(f"{what}, mode", event["mode"] == mode, f"{event['mode']}, expected {mode}")
            check.true(f"{what}, counts", run.thermo()[-1][1:] == [0, mode == "tension", mode == "shear"], str(run.thermo()[-1]))
            check.true(f"{what}, no load is left", norm(run.rows("d", STEPS)[1]) == 0)
    shift = scaled(n, -3 * SIGMA_C * A / KN)
    for frame_name, frame in frames(OBLIQUE).items():
        run = pair(check, frame, n, shift, ZERO, ZERO, bond(tensile=SIGMA_C, shear=TAU_C))
        check.true(f"compression along {name}, {frame_name}, to 3 sigma_c breaks nothing", run.thermo()[-1][1:] == [1, 0, 0])


def with_option(check, n, option, shift, turn1, turn2, factor, what):
    """A mode driven to 1.5 times its strength with an option that changes the strength: the step of breaking."""
    run = pair(check, Frame(), n, scaled(shift, factor), scaled(turn1, factor), scaled(turn2, factor),
               bond(tensile=SIGMA_C, shear=TAU_C, more=f"{option} events events.csv"))
    check.near(f"{option}: {what} breaks at step", float(run.events()[0]["time"]) / DT, STEPS / 1.5, 1, scale=1)


def options(check, n):
    """radius_factor scales the disc: same strength in stress, k I/R and k J/R in moment follow; moment_factor divides the
    moments' part: half of it, twice the angle."""
    t = across(n)
    axial, bend, twist = 1.5 * SIGMA_C * A / KN, 1.5 * SIGMA_C * I / (R * KB), 1.5 * TAU_C * J / (R * KT)
    with_option(check, n, "radius_factor 0.5", scaled(n, axial), ZERO, ZERO, 1, "pull")
    with_option(check, n, "radius_factor 0.5", ZERO, scaled(t, -0.5 * bend), scaled(t, 0.5 * bend), 2, "bend")
    with_option(check, n, "radius_factor 0.5", ZERO, ZERO, scaled(n, twist), 2, "twist")
    with_option(check, n, "moment_factor 0.5", ZERO, scaled(t, -0.5 * bend), scaled(t, 0.5 * bend), 2, "bend")
    with_option(check, n, "moment_factor 0.5", ZERO, ZERO, scaled(n, twist), 2, "twist")
    run = pair(check, Frame(), n, ZERO, ZERO, scaled(n, 2 * twist), bond(tensile=SIGMA_C, shear=TAU_C, more="moment_factor 0"))
    check.true("moment_factor 0: twist breaks nothing", run.thermo()[-1][1:] == [1, 0, 0])
    rows = pair(check, Frame(), n, ZERO, ZERO, scaled(n, 1e-4), bond(more="radius_factor 0.5")).rows("d", STEPS)
    vector_near(check, "radius_factor 0.5: torque of a twist", rows[1][3:], scaled(n, KT * 1e-4 / 16), 1e-6, KT * 1e-4 / 16)


def friction(check, n):
    """Mohr-Coulomb: under a compression of 0.5 sigma_c tau_c has grown by tan(30 deg) times that."""
    squeeze, grown = 0.5 * SIGMA_C * A / KN, TAU_C + 0.5 * SIGMA_C * math.tan(math.radians(30))
    with_option(check, n, "friction_angle 30", scaled(n, -1.5 * squeeze), ZERO, scaled(n, 1.5 * grown * J / (R * KT)), 1,
                "twist under compression")


def main():
    check = Check()
    for name, n in DIRECTIONS.items():
        loads(check, name, n)
        breaking(check, name, n)
    options(check, DIRECTIONS["random"])
    friction(check, DIRECTIONS["random"])
    check.finish()


main()
