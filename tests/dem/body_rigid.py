#!/usr/bin/env python3
"""Verification of fix body/rigid in frazilDem alone.

usage: body_rigid.py CASE FRAZILDEM

free_fall   a body in a domain without any particle against v0 t + g t²/2                     1e-12 of the distance
free_top    a cuboid spinning near its unstable axis against Euler's equations (Runge-Kutta)
            angular momentum 1e-12, energy 1e-6, orientation 1e-4 rad after 1.4 turns
impact      a spinning cuboid into loose spheres: momentum of body + spheres                   1e-10
            and the same end state on 1 and 2 ranks                                           1e-10
hertz       a heavy body onto a sphere at rest, elastic: relative velocity reverses           0.2 %
locks       a hinged and guided body turns about its free axis only: α = T/I                  1e-6
restart     a run cut in two by a restart file, contacts included                             1e-9
errors      what the fix says to bad input
"""
import math
import os
import subprocess
import sys
import tempfile

import dem_script
import mpirun
import surfaces

BOX = dem_script.box((-0.5,) * 3, (0.5,) * 3)
BODY = """
fix hull all mesh/surface/stress file {stl} type 1
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes hull
"""
SPHERES = """
create_atoms 1 single 0.00 0.071 0.00 units box
create_atoms 1 single 0.03 0.072 0.02 units box
create_atoms 1 single -0.035 0.073 -0.01 units box
create_atoms 1 single 0.03 0.094 -0.02 units box
set type 1 diameter 0.02 density 900
fix integrate all nve/sphere
"""
OUTPUT = """
variable px equal mass(all)*vcm(all,x)
variable py equal mass(all)*vcm(all,y)
variable pz equal mass(all)*vcm(all,z)
thermo_style custom step atoms {body} {extra}
thermo_modify lost error norm no format float %.17g
thermo {every}
"""
VECTOR = " ".join(f"f_body[{i}]" for i in range(1, 27))


def head(dt, restitution, create=BOX):
    return dem_script.head(create, processors="* 1 1", sort=" sort 0 0", young="1e7", poisson=0.33,
                           restitution=restitution, friction=0.2) + f"timestep {dt}\n"


def cuboid(path, size, centre=(0, 0, 0), skip=0):
    """STL of a box; `skip` leaves triangles out."""
    surfaces.write_stl(path, surfaces.cuboid(size, centre)[skip:])


class Run:
    """One run of frazilDem: script text in, thermo table out."""

    def __init__(self, program, script, ranks=1, expect_failure=False):
        self.folder = os.getcwd()
        with open("in.test", "w") as file:
            file.write(script)
        launcher = [*mpirun.COMMAND, "-np", str(ranks)] if ranks > 1 else []
        done = subprocess.run([*launcher, program, "-in", "in.test"], env=mpirun.environment(), capture_output=True,
                              text=True, errors="replace", timeout=300)
        self.output = done.stdout + done.stderr
        if (done.returncode != 0) != expect_failure:
            sys.exit("frazilDem ended with %d:\n%s" % (done.returncode, self.output[-3000:]))
        self.rows = [] if expect_failure else self.table()

    def table(self):
        rows, reading = [], False
        for line in open("log.liggghts"):
            words = line.split()
            if words[:1] == ["Step"]:
                reading = True
            elif words[:1] == ["Loop"]:
                reading = False
            elif reading and words and words[0].isdigit():
                rows.append([float(word) for word in words])
        return rows


def body(row):
    """Named parts of a row 'step atoms f_body[1..26] ...'."""
    v = row[2:28]
    return dict(x=v[0:3], v=v[3:6], w=v[6:9], q=v[9:13], contact=v[13:16], torque=v[16:19], rest=row[28:])


def check(name, error, tolerance):
    print("%s %s: %.3g (tolerance %.3g)" % ("PASS" if error <= tolerance else "FAIL", name, error, tolerance))
    return error <= tolerance


def rotate(q, v):
    w, x, y, z = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def distance(a, b):
    return math.sqrt(sum((p - q) ** 2 for p, q in zip(a, b)))


def script(fix, steps, dt=1e-5, every=100, spheres="", restitution=1.0, gravity="", stl="body.stl", extra=""):
    return (head(dt, restitution) + BODY.format(stl=stl) + gravity + spheres +
            "fix body all body/rigid mesh hull " + fix + "\n" +
            OUTPUT.format(body=VECTOR, every=every, extra=extra) + "run %d\n" % steps)


def free_fall(program):
    cuboid("body.stl", (0.1, 0.06, 0.03), (0.02, 0.3, 0))
    run = Run(program, script("density 2700 velocity 0.5 -1 0.25", 20000,
                              gravity="fix g all gravity 9.81 vector 0 -1 0\n", every=1000), ranks=2)
    t = 0.2
    end = body(run.rows[-1])
    fallen = [0.02 + 0.5 * t, 0.3 - t - 0.5 * 9.81 * t * t, 0.25 * t]
    ok = check("position after 0.2 s [m]", distance(end["x"], fallen), 1e-12)
    ok &= check("velocity [m/s]", distance(end["v"], [0.5, -1 - 9.81 * t, 0.25]), 1e-11)
    return ok & check("atoms in the domain", run.rows[-1][1], 0)


def euler_top(inertia, omega, time, steps):
    """Orientation of a free top, classical Runge-Kutta on Euler's equations and the quaternion, body axes."""
    def rate(s):
        w, q = s[:3], s[3:]
        turn = [(inertia[1] - inertia[2]) * w[1] * w[2] / inertia[0],
                (inertia[2] - inertia[0]) * w[2] * w[0] / inertia[1],
                (inertia[0] - inertia[1]) * w[0] * w[1] / inertia[2]]
        return turn + [-0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2]),
                       0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
                       0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
                       0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0])]

    state, h = list(omega) + [1.0, 0, 0, 0], time / steps
    for _ in range(steps):
        k1 = rate(state)
        k2 = rate([s + h / 2 * k for s, k in zip(state, k1)])
        k3 = rate([s + h / 2 * k for s, k in zip(state, k2)])
        k4 = rate([s + h * k for s, k in zip(state, k3)])
        state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state[3:]


def free_top(program):
    size, density, omega, dt, steps = (0.1, 0.06, 0.03), 2700.0, (0.5, 30.0, 0.3), 1e-5, 30000
    cuboid("body.stl", size, (0.01, 0.02, -0.03))
    text = " ".join(map(str, omega))
    run = Run(program, script("density 2700 velocity 0 0 0 omega " + text, steps, dt=dt, every=1000))
    mass = density * size[0] * size[1] * size[2]
    inertia = [mass / 12 * (size[(i + 1) % 3] ** 2 + size[(i + 2) % 3] ** 2) for i in range(3)]
    momentum0 = [i * w for i, w in zip(inertia, omega)]
    energy0 = 0.5 * sum(i * w * w for i, w in zip(inertia, omega))
    worst_momentum = worst_energy = 0
    for row in run.rows:
        state = body(row)
        q = state["q"]
        in_body = rotate([q[0], -q[1], -q[2], -q[3]], state["w"])
        momentum = rotate(q, [i * w for i, w in zip(inertia, in_body)])
        energy = 0.5 * sum(i * w * w for i, w in zip(inertia, in_body))
        worst_momentum = max(worst_momentum, distance(momentum, momentum0) / math.hypot(*momentum0))
        worst_energy = max(worst_energy, abs(energy / energy0 - 1))
    exact, q = euler_top(inertia, omega, steps * dt, 30000), body(run.rows[-1])["q"]
    angle = 2 * math.acos(min(1, abs(sum(a * b for a, b in zip(exact, q)))))
    ok = check("angular momentum, relative", worst_momentum, 1e-12)
    ok &= check("energy, relative", worst_energy, 1e-6)
    return ok & check("orientation [rad]", angle, 1e-4)


def impact_script():
    momentum = "v_px v_py v_pz"
    return script("density 2700 velocity 0.1 2 -0.05 omega 3 -2 5", 6000, restitution=0.9, every=200,
                  spheres=SPHERES, extra=momentum)


def impact(program):
    size = (0.1, 0.1, 0.1)
    cuboid("body.stl", size)
    mass, ok, ends = 2700 * 0.001, True, []
    for ranks in (1, 2):
        rows = Run(program, impact_script(), ranks=ranks).rows
        total = [[mass * v + p for v, p in zip(body(row)["v"], body(row)["rest"])] for row in rows]
        drift = max(distance(p, total[0]) for p in total) / math.hypot(*total[0])
        pushed = math.hypot(*body(rows[-1])["rest"]) / math.hypot(*total[0])
        ok &= check("momentum of body and spheres, %d ranks" % ranks, drift, 1e-10)
        ok &= check("share of it that the spheres took is above 1 %", 0.01 / pushed, 1)
        ends.append(rows[-1][2:15] + body(rows[-1])["rest"])
    return ok & check("end state, 1 against 2 ranks", max(abs(a - b) for a, b in zip(*ends)), 1e-10)


def hertz(program):
    cuboid("body.stl", (0.1, 0.1, 0.1))
    sphere = "create_atoms 1 single 0 0.061 0 units box\nset type 1 diameter 0.02 density 900\nfix i all nve/sphere\n"
    rows = Run(program, script("density 2700 velocity 0 1 0", 4000, dt=5e-6, spheres=sphere,
                               extra="v_px v_py v_pz")).rows
    ball = 900 * math.pi / 6 * 0.02 ** 3
    apart = body(rows[-1])["rest"][1] / ball - body(rows[-1])["v"][1]
    return check("relative velocity after an elastic impact, against 1 m/s", abs(apart - 1), 2e-3)


def locks(program):
    # gravity on a body whose centre of mass is guided; a spring of contact is not needed: the torque is the spheres'
    cuboid("body.stl", (0.1, 0.1, 0.1))
    rows = Run(program, script("density 2700 velocity 0 2 0 omega 0 0 1 lock x z rx ry", 6000, restitution=0.9,
                               spheres=SPHERES, every=1)).rows
    states = [body(row) for row in rows]
    sideways = max(abs(s["v"][0]) + abs(s["v"][2]) + abs(s["w"][0]) + abs(s["w"][1]) for s in states)
    ok = check("motion along locked directions", sideways, 1e-13)
    inertia, dt = 2700 * 0.001 * 0.01 / 6, 1e-5  # m a^2/6 of the cube [kg m2]
    torque = [s["torque"][2] for s in states]
    turn = sum(0.5 * dt * (a + b) for a, b in zip(torque, torque[1:])) / inertia  # velocity Verlet's own sum of T/I
    return ok & check("free rotation against the sum of T/I, relative", abs((states[-1]["w"][2] - 1) / turn - 1), 1e-6)


def restart(program):
    cuboid("body.stl", (0.1, 0.1, 0.1))
    whole = Run(program, impact_script().replace("run 6000", "run 570\nwrite_restart half.restart\nrun 2430"))
    second = head(1e-5, 0.9, "read_restart half.restart")
    second = "".join(line + "\n" for line in second.splitlines() if not line.startswith(("boundary", "atom_style")))
    second += (BODY.format(stl="body.stl") + "fix integrate all nve/sphere\n"
               "fix body all body/rigid mesh hull density 2700 velocity 0 0 0\n" +
               OUTPUT.format(body=VECTOR, every=200, extra="v_px v_py v_pz") + "run 2430\n")
    rows = Run(program, second).rows
    ok = check("a contact is open at the restart (1 N over its force)", 1 / math.hypot(*body(rows[0])["contact"]), 1)
    return ok & check("state after the restart", max(abs(a - b) for a, b in zip(rows[-1][2:15], whole.rows[-1][2:15])), 1e-9)


def errors(program):
    cuboid("body.stl", (0.1, 0.1, 0.1))
    cuboid("open.stl", (0.1, 0.1, 0.1), skip=1)
    plain = "fix plain all mesh/surface file body.stl type 1\n"
    cases = [("mesh missing density 900", "", "body.stl", "there is no fix 'missing', so the body has no mesh"),
             ("density 900", "", "body.stl", 'keyword "mesh" is missing'),
             ("mesh plain density 900", plain, "body.stl", "make it a mesh/surface/stress"),
             ("mesh hull density 900", "", "open.stl", "open"),
             ("mesh hull", "", "body.stl", "Add 'density RHO'"),
             ("mesh hull density -1", "", "body.stl", "density -1: must be greater than zero"),
             ("mesh hull density inf", "", "body.stl", "density inf: is not a number"),
             ("mesh hull density 900 velocity 1 nan 0", "", "body.stl", "velocity 1 nan 0: is not a vector"),
             ("mesh hull densty 900", "", "body.stl", 'densty: unknown keyword (did you mean "density"?)'),
             ("mesh hull density 900 speed 1 2 3", "", "body.stl", "speed: unknown keyword"),
             ("mesh hull density 900 velocity 1 2", "", "body.stl", "velocity 1 2: needs 3 values"),
             ("mesh hull density 900 mesh hull", "", "body.stl", "mesh: stands twice"),
             ("mesh hull density 900 lock all", "", "body.stl", "lock all: all is no direction"),
             ("mesh hull density 900 lock", "", "body.stl", "lock: needs 1 value"),
             ("mesh hull density 900 com 0 0 0.01", "", "body.stl", "Add 'inertia"),
             ("mesh hull density 900 inertia 1 1 -1 0 0 0", "", "body.stl", "positive definite")]
    ok = True
    for arguments, extra, stl, expected in cases:
        text = head(1e-5, 1) + BODY.format(stl=stl) + extra
        run = Run(program, text + "fix body all body/rigid %s\n" % arguments, expect_failure=True)
        message = next((line for line in run.output.splitlines() if line.startswith("ERROR")), "no ERROR line")
        found = expected in run.output
        print("%s %s -> %s" % ("PASS" if found else "FAIL", arguments, message))
        ok &= found
    return ok


if __name__ == "__main__":
    case, program = sys.argv[1], os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        passed = globals()[case](program)
        os.chdir("/")
    sys.exit(0 if passed else 1)
