"""The waves of ice_wave: front, profile and d'Alembert's solution; as a program a figure: wave.py RUNFOLDER OUT.png

The plate's velocity at x is the mean over all layers and over the spheres within 0.6 D of x and D of the axis z = 0.
d'Alembert, string with initial velocity ψ(x) = v0 exp(-x²/2λ²): v(x,t) = ½[ψ(x - ct) + ψ(x + ct)]; v0 and λ are fitted, as
in the study. SI units.
"""
import json
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy
from matplotlib import colors, pyplot

import checks
import entry
import lattice

MOMENT = 0.11e-3        # after the first contact [s]: that of the study's figure 16
PAPER_SPEED = 745.0     # √(E_b/ρ) [m/s]
OUTWARD = 5e-7          # share of the projectile's velocity that counts as outward motion, above round-off
REACH = (0.016, 0.078)  # stations along x [m]: beyond the projectile, short of the reflections from the edge


@dataclass
class Wave:
    """Time after the first contact [s]; stations [m]; velocity along x and upwards [m/s], times x stations."""
    time: numpy.ndarray
    x: numpy.ndarray
    along: numpy.ndarray
    up: numpy.ndarray


def frames(path):
    """(step, rows) of each frame of a LIGGGHTS dump."""
    with open(path) as dump:
        for line in dump:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(next(dump))
            elif line.startswith("ITEM: NUMBER"):
                count = int(next(dump))
            elif line.startswith("ITEM: ATOMS"):
                yield step, numpy.array([next(dump).split() for _ in range(count)], dtype=float)


def first_contact(run):
    """Time of the first force on the projectile [s]."""
    contact = checks.table(run / "dem/contact.csv")
    return next(time for time, force in zip(contact["time"], contact["contact_fy"]) if force > 0)


def read(run, parameters):
    """The Wave of a run."""
    diameter, step = parameters["sphere_diameter"], time_step(run)
    stations = numpy.arange(0, 0.5 * parameters["columns"] * diameter, diameter)
    steps, tables = zip(*frames(run / "dem/axis.txt"))
    near = [numpy.abs(tables[0][:, 1] - x) < 0.6 * diameter for x in stations]
    mean = lambda column: numpy.array([[table[at, column].mean() for at in near] for table in tables])
    return Wave(step * numpy.array(steps) - first_contact(run), stations, mean(4), mean(5))


def time_step(run):
    """Of the DEM [s], from the run's own parameters."""
    lines = (run / "dem/parameters").read_text().splitlines()
    return next(float(line.split()[-1]) for line in lines if line.split()[1] == "time_step")


def arrivals(wave, threshold):
    """(x, time) at which the motion first turns outwards, over the threshold [m/s], at the stations in reach. The first
    pulse moves the plate inwards, then outwards; the change of sign is a phase of the wave that does not depend on how
    its strength falls with the distance, as the first motion of a given strength would."""
    chosen = [n for n, x in enumerate(wave.x) if REACH[0] <= x <= REACH[1]]
    times = []
    for n in chosen:
        v = wave.along[:, n]
        k = int(numpy.argmax(v > threshold))
        share = (threshold - v[k - 1]) / (v[k] - v[k - 1]) if k else 0.0
        times.append(wave.time[k - 1] + share * (wave.time[k] - wave.time[k - 1]) if k else numpy.nan)
    return wave.x[chosen], numpy.array(times)


def front_speed(wave, impact_speed):
    """(speed of the first pulse [m/s], scatter of its arrivals about the straight line [m])."""
    x, times = arrivals(wave, OUTWARD * impact_speed)
    speed, start = numpy.polyfit(times, x, 1)
    return speed, float(numpy.std(x - speed * times - start))


def profile(wave):
    """(stations, velocity along x) at MOMENT, outside the crushed ice under the projectile."""
    outside = wave.x >= 0.5 * entry.D0
    return wave.x[outside], wave.along[int(numpy.argmin(numpy.abs(wave.time - MOMENT))), outside]


def dalembert(x, width, speed):
    """½[ψ(x - ct) + ψ(x + ct)] at MOMENT for v0 = 1."""
    pulse = lambda s: numpy.exp(-s * s / (2 * width * width))
    return 0.5 * (pulse(x - speed * MOMENT) + pulse(x + speed * MOMENT))


def fit_dalembert(wave, speed):
    """(v0 [m/s], λ [m], rest): least squares over the stations; rest: root mean square of what is left over that of the
    velocity itself."""
    x, v = profile(wave)
    best = None
    for width in numpy.geomspace(5e-3, 0.2, 200):
        shape = dalembert(x, width, speed)
        height = (shape @ v) / (shape @ shape)
        rest = numpy.sqrt(((v - height * shape)**2).sum() / (v**2).sum())
        if best is None or rest < best[2]:
            best = height, width, rest
    return best


def draw_spread(axis, wave, speed):
    """(a) Velocity along x over place and time, with the speeds of the lattice and of the study."""
    image = axis.pcolormesh(1e3 * wave.x, 1e6 * wave.time, wave.along, cmap="RdBu_r", shading="nearest",
                            norm=colors.SymLogNorm(1e-4, vmin=-1, vmax=1))
    axis.figure.colorbar(image, label="velocity along x [m/s]")
    for c, style, label in ((speed, "k-", "lattice"), (PAPER_SPEED, "k--", "√(E_b/ρ)")):
        axis.plot(1e3 * wave.x, 1e6 * wave.x / c, style, linewidth=0.9, label=f"{label}, {c:.0f} m/s")
    axis.set(xlabel="x [mm]", ylabel="time after contact [µs]", ylim=(0, 1e6 * wave.time[-1]))
    axis.legend(loc="lower right")


def draw_profile(axis, wave, speed):
    """(b) Velocity along x at MOMENT, with d'Alembert's."""
    x, v = profile(wave)
    axis.plot(1e3 * x, v, "ko", markersize=3, label="measured")
    for c, style in ((PAPER_SPEED, "--"), (speed, "-")):
        height, width, _ = fit_dalembert(wave, c)
        axis.plot(1e3 * x, height * dalembert(x, width, c), style, linewidth=1, label=f"d'Alembert, c = {c:.0f} m/s")
    axis.set(xlabel="x [mm]", ylabel="velocity along x [m/s]", title=f"{1e3 * MOMENT:g} ms after contact")
    axis.set_yscale("symlog", linthresh=0.01)
    axis.legend(frameon=False)


def draw_stress(axis, run, diameter):
    """(c) Stress xx of the uppermost layer in the last dump of the plate."""
    last = max(run.glob("dem/plate.*.txt"), key=lambda path: int(path.name.split(".")[1]))
    _, rows = next(frames(last))
    top = rows[rows[:, 2] > rows[:, 2].max() - 0.5 * diameter]
    image = axis.scatter(1e3 * top[:, 1], 1e3 * top[:, 3], c=top[:, 8] / 1e6, s=3, cmap="RdBu_r",
                         norm=colors.SymLogNorm(0.01, vmin=-1, vmax=1))
    axis.figure.colorbar(image, label="stress xx of the top layer [MPa]")
    axis.set(xlabel="x [mm]", ylabel="z [mm]", aspect="equal")


def draw(run, out):
    """The figure."""
    parameters = json.loads((run / "params.json").read_text())
    wave, speed = read(run, parameters), lattice_plate(parameters).wave_speed()
    figure, axes = pyplot.subplots(1, 3, figsize=(13, 3.9), layout="constrained")
    draw_spread(axes[0], wave, speed)
    draw_profile(axes[1], wave, speed)
    draw_stress(axes[2], run, parameters["sphere_diameter"])
    figure.savefig(out, dpi=120)


def lattice_plate(parameters):
    """The endless plate of the run's ice."""
    return lattice.Plate(lattice.Ice(parameters["sphere_diameter"], parameters["ice_density"], parameters["bond_young"],
                                     parameters["stiffness_ratio"]), parameters["layers"])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: wave.py RUNFOLDER OUT.png")
    draw(Path(sys.argv[1]), sys.argv[2])
