"""A periodic cell of densely packed spheres, made by LIGGGHTS. See the package."""
import math
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy

import folder

START = 0.3      # share of the box that the spheres fill before it shrinks [-]
STIFFNESS = 5e6  # of the spheres while they are packed [Pa]
PRESSURE = 500.0  # that they carry at the end [Pa]; overlaps are then (p/E)^(2/3), 2 in 1000
DENSITY = 900.0
SCRIPT = Path(__file__).resolve().parent / "in.packing"


@dataclass
class Cell:
    """Centres [m] in 0 to side, diameters [m], side of the cube [m]."""
    points: numpy.ndarray
    diameters: numpy.ndarray
    side: float

    def solid_fraction(self):
        """Share of the cell inside spheres [-]."""
        return math.pi / 6 * (self.diameters**3).sum() / self.side**3

    def write(self, path):
        """A line per sphere: x, y, z, diameter [m]."""
        numpy.savetxt(path, numpy.column_stack((self.points, self.diameters)), fmt="%.17g", delimiter=",",
                      header=f"side {self.side:.17g}\nx,y,z,diameter")


def read(path):
    """A cell as `write` leaves it. OSError or ValueError on another file."""
    with open(path) as lines:
        first = lines.readline().split()
    if first[:2] != ["#", "side"]:
        raise ValueError("no cell of packed spheres: its first line is not '# side LENGTH'")
    side, rows = float(first[2]), numpy.loadtxt(path, delimiter=",")
    return Cell(rows[:, :3], rows[:, 3], side)


def scattered(diameters, generator):
    """Side and centres of spheres that do not touch: each put at random until it is free, the largest first."""
    side = (math.pi / 6 * (diameters**3).sum() / START)**(1 / 3)
    points = numpy.empty((len(diameters), 3))
    for n, diameter in enumerate(diameters):
        while True:
            point = generator.random(3) * side
            away = numpy.abs(points[:n] - point)
            away = numpy.minimum(away, side - away)
            if ((away**2).sum(axis=1) > (0.5 * (diameters[:n] + diameter))**2).all():
                break
        points[n] = point
    return side, points


def write_start(path, side, points, diameters):
    """LIGGGHTS data file of the scattered spheres."""
    with open(path, "w") as data:
        data.write(f"Scattered spheres\n\n{len(points)} atoms\n1 atom types\n\n")
        data.writelines(f"0 {side:.17g} {axis}lo {axis}hi\n" for axis in "xyz")
        data.write("\nAtoms\n\n")
        data.writelines("%d 1 %.17g %g %.17g %.17g %.17g\n" % (n, diameter, DENSITY, *point)
                        for n, (diameter, point) in enumerate(zip(diameters, points), 1))


def parameters(diameters):
    """Of in.packing: a twentieth of the contact's period as time step; so much drag that motion dies in a few hundred steps."""
    mass = DENSITY * math.pi / 6 * diameters.min()**3
    # stiffness of a Hertzian contact at an overlap of a hundredth, E* = E/(2(1 - ν²)), R* = R/2
    stiffness = 2 * STIFFNESS / 1.82 * math.sqrt(diameters.min() / 4 * 0.01 * diameters.min())
    period = 2 * math.pi * math.sqrt(mass / 2 / stiffness)
    step = period / 40
    return {"skin": 0.15 * float(diameters.min()), "young": STIFFNESS, "time_step": step, "pressure": PRESSURE,
            "drag": mass / (100 * step), "rest": 4000}


def make(diameters, seed, run):
    """The cell of these spheres; run: a folder for frazilDem's files. RuntimeError with the end of its log if it fails."""
    diameters = numpy.sort(numpy.asarray(diameters, float))[::-1]
    side, points = scattered(diameters, numpy.random.default_rng(seed))
    run = Path(run)
    folder.copy_dem(SCRIPT, run, parameters(diameters))
    write_start(run / "dem/cell.data", side, points, diameters)
    ended = subprocess.run(["frazilDem", "-in", "dem/in.packing", "-log", "log.dem", "-screen", "/dev/null"], cwd=run,
                           capture_output=True, text=True)
    log = (run / "log.dem").read_text() if (run / "log.dem").is_file() else ended.stderr
    found = re.findall(r"^side ([\d.e+-]+)$", log, re.MULTILINE)
    if ended.returncode or not found:
        raise RuntimeError(f"frazilDem ended with {ended.returncode} while it packed spheres in {run}:\n{log[-800:]}")
    rows = numpy.loadtxt(run / "dem/cell.dump", skiprows=9)
    return relieved(Cell(rows[:, 1:4] % float(found[-1]), 2 * rows[:, 4], float(found[-1])))


def gaps(cell, reach):
    """(first, second, gap over mean radius) of all pairs up to a gap `reach`, through the cell's sides."""
    from scipy.spatial import cKDTree
    tree = cKDTree(cell.points, boxsize=cell.side)
    first, second = tree.query_pairs(cell.diameters.max() * (1 + reach / 2), output_type="ndarray").T
    away = numpy.abs(cell.points[first] - cell.points[second])
    distance = numpy.linalg.norm(numpy.minimum(away, cell.side - away), axis=1)
    radius = 0.25 * (cell.diameters[first] + cell.diameters[second])
    gap = distance / radius - 2
    return first[gap <= reach], second[gap <= reach], gap[gap <= reach]


def relieved(cell):
    """With diameters reduced so that the most compressed pair just touches."""
    _, _, gap = gaps(cell, 0.0)
    shrink = 1 + min(gap.min(), 0.0) / 2 if gap.size else 1.0
    return Cell(cell.points, cell.diameters * shrink * (1 - 1e-12), cell.side)
