"""Chains of bonded spheres against beam and lattice theory: oscillation, wave, cantilever, torsion, energy."""

import math

from bond_dem import *

S = 1.004 * D  # spacing [m]; the gap keeps contacts out
KN = E * A / S
BOX = "-0.01 0.11 -0.02 0.02 -0.02 0.02"


def chain(count):
    return [[i * S, 0, 0] for i in range(count)]


def crossings(times, values):
    """Times of the rising zero crossings, interpolated."""
    pairs = zip(zip(times, values), zip(times[1:], values[1:]))
    return [t0 - v0 * (t1 - t0) / (v1 - v0) for (t0, v0), (t1, v1) in pairs if v0 < 0 <= v1]


def frequency(run, dt, column=1):
    rows = run.thermo()
    at = crossings([row[0] * dt for row in rows], [row[column] for row in rows])
    return (len(at) - 1) / (at[-1] - at[0])


def oscillation(check):
    dt = 1e-8
    for name, n in DIRECTIONS.items():
        script = head() + MODEL + spheres([[0, 0, 0], scaled(n, S)]) + f"timestep {dt}\n" + bond()
        for i, sign in ((1, 1), (2, -1)):
            script += f"group g{i} id {i}\nvelocity g{i} set {vec(scaled(n, sign * 1e-3))} units box\n"
        k = max(range(3), key=lambda axis: abs(n[axis]))
        script += f"variable v equal v{'xyz'[k]}[1]\nfix nve all nve/sphere\n"
        script += "thermo_style custom step v_v\nthermo 5\nthermo_modify format float %.15g\nrun 20000\n"
        check.near(f"axial oscillation along {name} [Hz]", frequency(check.run(script), dt),
                   math.sqrt(2 * KN / MASS) / (2 * math.pi), 5e-3)


def wave(check):
    """Periodic chain: each mode at its lattice frequency; the longest travels at sqrt(kn A/m) spacing."""
    count, dt = 40, 1e-7
    for waves, ranks in ((1, 1), (1, 2), (5, 1), (13, 1)):
        k = 2 * math.pi * waves / (count * S)
        box = f"0 {count * S:.17g} -0.02 0.02 -0.02 0.02"
        script = head(box, "* 1 1").replace("boundary f f f", "boundary p f f") + MODEL
        script += spheres([[(i + 0.5) * S, 0, 0] for i in range(count)]) + f"timestep {dt}\n" + bond()
        script += f"variable vx atom 1e-3*cos({k:.17g}*x)\nvelocity all set v_vx 0 0 units box\n"
        script += "variable v equal vx[1]\nfix nve all nve/sphere\nthermo_style custom step v_v f_bonds[1]\nthermo 1\n"
        script += "thermo_modify format float %.15g\n"
        omega = 2 * math.sqrt(KN / MASS) * math.sin(0.5 * k * S)
        steps = int(4.2 * 2 * math.pi / omega / dt)
        run = check.run(script + f"run {steps}\n", ranks=ranks)
        check.true(f"periodic chain on {ranks} ranks: bonds", run.thermo()[0][2] == count, f"{run.thermo()[0][2]:g} of {count}")
        measured = 2 * math.pi * frequency(run, dt)
        check.near(f"chain wave {waves} on {ranks} ranks, omega [rad/s]", measured, omega, 1e-2)
        if waves == 1:
            check.near(f"wave speed on {ranks} ranks [m/s]", measured / k, math.sqrt(KN / MASS) * S, 1e-2)


def beam(count, dt, more=""):
    script = head(BOX) + MODEL + spheres(chain(count + 1)) + f"timestep {dt}\n" + bond(more=more)
    return script + f"group root id 1\ngroup tip id {count + 1}\ngroup rest subtract all root\n"


def cantilever(check):
    count, dt, force = 8, 2e-7, 1e-3
    length = count * S
    deflection = force * S / (E * I) * sum((length - (i - 0.5) * S)**2 for i in range(1, count + 1))
    deflection += count * force * KAPPA * S / (E * A)
    slowest = 3.516 * math.sqrt(E * I * S / MASS) / length**2
    script = beam(count, dt, "damping 0.3") + f"fix load tip addforce 0 0 {force}\n"
    script += f"fix air all viscous {2 * slowest * MASS:.10g}\nfix nve rest nve/sphere\n"
    script += dump("d", 30000, "x y z") + "run 30000\n"
    rows = check.run(script).rows("d", 30000)
    check.near(f"cantilever of {count} bonds, deflection [m]", rows[count + 1][2], deflection, 1e-3)


def cantilever_frequency(check):
    count, dt = 30, 2e-7
    length = count * S
    reference = 1.8751**2 / (2 * math.pi) * math.sqrt(E * I / (MASS * length**4 / S))
    script = beam(count, dt) + f"variable vz atom 1e-3*(x/{length})^2\nvelocity rest set 0 0 v_vz units box\n"
    script += f"variable z equal z[{count + 1}]\nfix nve rest nve/sphere\n"
    script += "thermo_style custom step v_z\nthermo 100\nthermo_modify format float %.15g\n"
    steps = int(4.5 / reference / dt)
    check.near("cantilever, first frequency [Hz]", frequency(check.run(script + f"run {steps}\n"), dt), reference, 5e-2)


def torsion(check):
    """The tip is turned by phi, then held; the torque that it takes follows from phi = T N s kappa/(E J)."""
    count, dt, phi = 8, 2e-7, 1e-3
    script = beam(count, dt, "damping 0.3") + "group inner subtract rest tip\nfix nve inner nve/sphere\n"
    script += f"fix turn tip move rotate {count * S:.17g} 0 0 1 0 0 {2 * math.pi / phi * 1000 * dt:.17g}\nrun 1000\n"
    script += "unfix turn\nset group tip omegax 0 omegay 0 omegaz 0\n"
    script += dump("d", 21000, "tqx") + "run 20000\n"
    torque = check.run(script).rows("d", 21000)[count + 1][0]
    check.near(f"torsion of {count} bonds, torque [N m]", -torque, phi * E * J / (count * S * KAPPA), 1e-3)


def energy(check):
    """A tumbling, vibrating lump, undamped: kinetic plus elastic energy stays, at 0.1 of the critical step."""
    dt = 1.2e-7
    cells = [[i * S, j * S, k * S] for i in range(3) for j in range(2) for k in range(2)]
    script = head() + MODEL + spheres(cells) + f"timestep {dt}\n" + bond()
    script += "variable vx atom 0.02*sin(7.0*id)\nvariable vy atom 0.02*cos(3.0*id)\nvariable vz atom 0.02*sin(5.0*id+1)\n"
    script += "velocity all set v_vx v_vy v_vz units box\nset group all omegax 8 omegay -5 omegaz 3\n"
    script += "compute rot all erotate/sphere\nvariable total equal ke+c_rot+f_bonds[5]\nfix nve all nve/sphere\n"
    script += "thermo_style custom step v_total ke f_bonds[5] f_bonds[1]\nthermo 100\nthermo_modify norm no format float %.15g\n"
    rows = check.run(script + "run 100000\n").thermo()
    totals = [row[1] for row in rows[1:]]
    # Verlet's energy fluctuates by (omega dt)^2/8 without drifting: means over tenths of the run are compared.
    tenth = len(totals) // 10
    means = [sum(totals[i * tenth:(i + 1) * tenth]) / tenth for i in range(10)]
    drift = max(abs(m / means[0] - 1) for m in means)
    share = max(row[3] for row in rows) / totals[0]
    check.true("energy over 1e5 steps", drift <= 1e-4 and share > 0.1, f"drift {drift:.2e} <= 1e-4, up to {share:.2f} of it elastic")


def damping(check):
    """Axial vibration at 5 % of critical: logarithmic decrement; what is lost is what the fix says was dissipated."""
    dt, fraction = 1e-8, 0.05
    script = head() + MODEL + spheres([[0, 0, 0], [S, 0, 0]]) + f"timestep {dt}\n" + bond(more=f"damping {fraction}")
    for i, sign in ((1, 1), (2, -1)):
        script += f"group g{i} id {i}\nvelocity g{i} set {sign * 1e-3} 0 0 units box\n"
    script += "variable v equal vx[1]\nvariable total equal ke+f_bonds[5]+f_bonds[6]\nfix nve all nve/sphere\n"
    script += "thermo_style custom step v_v v_total f_bonds[6] ke\nthermo 1\n"
    rows = check.run(script + "thermo_modify norm no format float %.15g\nrun 6000\n").thermo()
    peaks = [b[1] for a, b, c in zip(rows, rows[1:], rows[2:]) if b[1] > a[1] and b[1] > c[1]]
    decrement = math.log(peaks[0] / peaks[3]) / 3
    check.near("damping, fraction of critical", decrement / math.hypot(2 * math.pi, decrement), fraction, 1e-3)
    check.near("damping, energy balance", rows[-1][2], rows[0][2], 1e-3)
    check.true("damping takes nearly all", rows[-1][3] > 0.9 * rows[0][2], f"{rows[-1][3] / rows[0][2]:.3f} of the energy")


def damping_of_modes(check):
    """Each mode of a symmetric pair vibrates alone and decays at its own fraction: frequency and logarithmic decrement."""
    fractions = (0.02, 0.04, 0.06, 0.08)  # normal, shear, torsion, bending
    ks, inertia = KN / KAPPA, 0.4 * MASS * R**2
    # Opposite spins twist or bend. Spheres that slip past each other roll the same way, so that the pair does not turn; the
    # spins add to the slip, so the mode is faster, and its fraction larger, by the root of 1 + 5/2 (S/D)^2.
    roll = math.sqrt(1 + 2.5 * (S / D)**2)
    modes = {"normal": ("vx", [1e-3, 0, 0], [0, 0, 0], 1, math.sqrt(2 * KN / MASS), fractions[0]),
             "shear": ("vz", [0, 0, 1e-3], [0, -1e-3 * S / (0.8 * R**2), 0], 1, math.sqrt(2 * ks / MASS) * roll, fractions[1] * roll),
             "torsion": ("omegax", [0, 0, 0], [1, 0, 0], -1, math.sqrt(ks * R**2 / inertia), fractions[2]),
             "bending": ("omegaz", [0, 0, 0], [0, 0, 1], -1, math.sqrt(KN * R**2 / 2 / inertia), fractions[3])}
    dt = 1e-8
    for mode, (column, v, omega, same, rate, fraction) in modes.items():
        script = head() + MODEL + spheres([[0, 0, 0], [S, 0, 0]]) + f"timestep {dt}\n"
        script += bond(more="damping " + " ".join(map(str, fractions)))
        for i, direction in ((1, 1), (2, -1)):
            w = omega if i == 1 else scaled(omega, same)
            script += f"group g{i} id {i}\nvelocity g{i} set {vec(scaled(v, direction))} units box\n"
            script += f"set group g{i} omegax {w[0]} omegay {w[1]} omegaz {w[2]}\n"
        steps = int(4.5 * 2 * math.pi / rate / dt)
        script += f"fix nve all nve/sphere\n{dump('d', 10, column, 'g1')}run {steps}\n"
        run = check.run(script)
        values = [run.rows("d", step)[1][0] for step in run.steps("d")]
        peaks = [b for a, b, c in zip(values, values[1:], values[2:]) if b > a and b > c]
        times = crossings([10 * dt * n for n in range(len(values))], values)
        decrement = math.log(peaks[0] / peaks[2]) / 2
        check.near(f"damping of {mode}, fraction of critical", decrement / math.hypot(2 * math.pi, decrement), fraction, 1e-2)
        damped = rate * math.sqrt(1 - fraction**2)
        check.near(f"frequency of {mode} [rad/s]", 2 * math.pi * (len(times) - 1) / (times[-1] - times[0]), damped, 5e-3)


def main():
    check = Check()
    for case in (oscillation, wave, cantilever, cantilever_frequency, torsion, energy, damping, damping_of_modes):
        case(check)
    check.finish()


main()
