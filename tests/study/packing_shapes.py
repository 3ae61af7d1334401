"""Random packings: LIGGGHTS packs a cell, shapes are filled with it, and nothing moves when the bonds are made.

Shapes against distances worked out by hand; the cell: no overlap, as dense as a random close packing of frictionless spheres
(0.64 at jamming, less what the diameters are reduced by), every sphere inside its shape, and in frazilDem with its bonds no
energy but round-off. Equal and graded spheres.
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

import checks
import ice
from packing import cell, shapes

SCRIPT = """atom_style granular
boundary f f f
newton off
communicate single vel yes
units si
read_data spheres.data
neighbor 0.3e-3 bin
neigh_modify delay 0
fix young all property/global youngsModulus peratomtype 0.5e9
fix poisson all property/global poissonsRatio peratomtype 0.33
fix restitution all property/global coefficientRestitution peratomtypepair 1 0.3
fix friction all property/global coefficientFriction peratomtypepair 1 0.2
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-7
fix bonds all bond/parallel young 0.5e9 stiffness_ratio 2.66 tensile_strength 1e6 shear_strength 1e6 list bonds.txt
fix motion all nve/sphere
thermo_style custom step ke f_bonds[1] f_bonds[5]
thermo 100
run 100
variable moving equal $(ke)
variable stored equal $(f_bonds[5])
variable bonds equal $(f_bonds[1])
print "after ${bonds} ${moving} ${stored}"
"""


def prism(result):
    """An L of 2 x 2 less 1 x 1, from 0 to 1: depths of points by hand, outside at the notch."""
    body = shapes.Prism([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], 0.0, 1.0)
    points = numpy.array([(0.5, 0.5, 0.5), (0.5, 0.1, 1.8), (0.8, 0.5, 0.8), (1.5, 0.5, 1.5), (0.5, 1.2, 0.5), (-0.1, 0.5, 0.5)])
    expected = (0.5, 0.1, math.hypot(0.2, 0.2), -0.5, -0.2, -0.1)
    worst = numpy.abs(body.depth(points) - expected).max()
    result.below("depths in an L, worst error", worst, 1e-12)


def unit_cube():
    """Its twelve triangles."""
    corner = lambda n: numpy.array([n >> 2 & 1, n >> 1 & 1, n & 1], float)
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return numpy.array([[corner(q[0]), corner(q[i]), corner(q[i + 1])] for q in quads for i in (1, 2)])


def cube(result):
    """Depth is the distance from the nearest face, negative outside, also beside an edge."""
    body = shapes.Surface(unit_cube())
    points = numpy.array([(0.5, 0.5, 0.5), (0.1, 0.6, 0.7), (0.5, 0.95, 0.5), (1.3, 1.4, 0.5), (0.5, 0.5, -2.0)])
    expected = (0.5, 0.1, 0.05, -0.5, -2.0)
    result.below("depths in a cube, worst error", numpy.abs(body.depth(points) - expected).max(), 1e-12)


def stl(result):
    """Ascii and binary files have the same triangles; one that is cut off is refused with its name."""
    triangles = unit_cube()
    with tempfile.TemporaryDirectory() as scratch:
        text, binary, cut = (Path(scratch, name) for name in ("text.stl", "binary.stl", "cut.stl"))
        lines = [f"vertex {x:g} {y:g} {z:g}" for triangle in triangles for x, y, z in triangle]
        text.write_text("solid cube\n" + "\n".join(lines) + "\nendsolid cube\n")
        rows = numpy.zeros(len(triangles), numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")]))
        rows["corners"] = triangles
        binary.write_bytes(bytes(80) + len(triangles).to_bytes(4, "little") + rows.tobytes())
        cut.write_bytes(binary.read_bytes()[:-20])
        for path in (text, binary):
            result.say(numpy.array_equal(shapes.read_stl(path), triangles), path.name, "12 triangles", "those written")
        try:
            shapes.read_stl(cut)
            said = "accepted"
        except ValueError as error:
            said = str(error)
        result.say("cut.stl: no STL file, or cut off" in said, "half a file", said[-60:], "refused")


def filled_by_command(result):
    """`python3 -m packing` fills a cube of 20 mm from its file; LIGGGHTS's data file and the list hold as much as it says."""
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch, "cube.stl")
        path.write_text("solid cube\n" + "\n".join(f"vertex {x} {y} {z}" for t in 0.02 * unit_cube() for x, y, z in t) + "\n")
        words = [sys.executable, "-m", "packing", str(Path(scratch, "out")), "--stl", str(path), "--diameter", "0.0024", "--spheres", "300"]
        said = subprocess.run(words, capture_output=True, text=True)
        data = Path(scratch, "out/spheres.data").read_text() if said.returncode == 0 else said.stderr
        spheres = int(said.stdout.split()[0]) if said.returncode == 0 else 0
        pairs = Path(scratch, "out/bonds.txt").read_text().splitlines() if spheres else []
        result.say(f"\n{spheres} atoms\n" in data, "spheres of the data file", spheres, "as said")
        # 62 % of the 20 mm cube, less the layer in which no whole sphere fits
        result.say(350 < spheres < 0.64 * 0.02**3 / (math.pi / 6 * 0.0024**3), "spheres in the cube", spheres, "350 to 707")
        result.above("bonds per sphere", 2 * len(pairs) / max(spheres, 1), 4.5)


def at_rest(result, name, points, diameters, folder):
    """In frazilDem, with their bonds, the spheres stay where they are."""
    pairs = shapes.bonds(points, diameters)
    box = [(axis.min() - 0.01, axis.max() + 0.01) for axis in points.T]
    ice.write_data(folder / "spheres.data", points, diameters, 900.0, box, types=1)
    (folder / "bonds.txt").write_text("".join(f"{n + 1} {m + 1}\n" for n, m in pairs))
    (folder / "in.rest").write_text(SCRIPT)
    out = subprocess.run(["frazilDem", "-in", "in.rest", "-log", "none"], cwd=folder, capture_output=True, text=True).stdout
    said = [line.split()[1:] for line in out.splitlines() if line.startswith("after ")]
    bonds, moving, stored = map(float, said[-1]) if said else (0.0, math.inf, math.inf)
    result.near(f"{name}: bonds in frazilDem", bonds, len(pairs), 0)
    # of the energy of one bond at its strength: 1/2 σ²/E times its volume
    one = 0.5 * 1e12 / 0.5e9 * math.pi / 4 * diameters.min()**3
    result.below(f"{name}: energy after 100 steps over that of one bond at its strength", (moving + stored) / one, 1e-12)
    return 2 * len(pairs) / len(points)


def packed(result, name, diameters):
    """A cell and a disc cut from it."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        one = cell.make(diameters, 1, folder / "packing")
        one.write(folder / "cell.csv")
        again = cell.read(folder / "cell.csv")
        result.say((again.points == one.points).all() and again.side == one.side, f"{name}: written and read", "equal", "equal")
        _, _, gap = cell.gaps(one, 0.02)
        result.say(gap.min() >= 0, f"{name}: least gap over the mean radius", f"{gap.min():.1e}", "not below 0")
        result.say(0.60 < one.solid_fraction() < 0.66, f"{name}: solid fraction", f"{one.solid_fraction():.4f}", "0.60 to 0.66")
        result.below(f"{name}: diameters reduced by [%]", 100 * (1 - one.diameters.max() / diameters.max()), 1.5)
        angle = numpy.linspace(0, 2 * math.pi, 24, endpoint=False)
        body = shapes.Prism(0.9 * one.side * numpy.column_stack((numpy.cos(angle), numpy.sin(angle))), 0.0, 0.8 * one.side)
        points, kept = shapes.fill(body, one)
        result.say((body.depth(points) >= 0.5 * kept).all(), f"{name}: {len(points)} spheres inside as a whole", "all", "all")
        result.above(f"{name}: bonds per sphere", at_rest(result, name, points, kept, folder), 5.5)


result = checks.Checks()
prism(result)
cube(result)
stl(result)
filled_by_command(result)
packed(result, "equal", numpy.full(400, 0.0024))
packed(result, "graded", numpy.linspace(0.002, 0.003, 400))
result.end()
