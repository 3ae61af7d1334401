#!/usr/bin/env python3
"""Dense particles and the fluid between them are stable at any fluid step, and a bed at rest is at rest.

    stability.py                 the quick rows (ctest)
    stability.py --map FILE      the whole map, a row for each point, appended to FILE; goes on where it was stopped

Loose or bonded spheres fill a channel whose floor is closed, on a lattice without contacts, without gravity; all start
upwards at 1 mm/s, so that the fluid must flow back between them. Drag lets them stop. Stable: no sphere is ever faster
than 1.5 times the start, and the mean ends below it.

A bed of glass, settled by the DEM alone, then under water: rms of the pressure on the floor about its mean, over the bed's
weight per area, at four fluid steps (1 %).

FRAZIL_BUILD names the build folder.
"""
import argparse
import itertools
import math
import statistics
import sys
import tempfile
from pathlib import Path

import dem_script
import pair
import tank_case
import foam_case as fc

DIAMETER, CELLS = 0.003, 6  # [m], lattice cells along each edge
STEPS = 60  # of the fluid

BOX = "region box block 0 {edge} 0 {top} 0 {edge} units box\ncreate_box 1 box\n"
HEAD = dem_script.head(BOX, restitution=0.5)
LATTICE = HEAD + """timestep {dem}
lattice custom {cell} a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0.25 0.25 0.25 basis 0.75 0.75 0.75
create_atoms 1 box
set group all diameter {diameter} density {density}
velocity all set 0 0.001 0 units box
{bonds}
fix motion all nve/sphere
fix fluid all couple/foam
compute speed all property/atom vy
compute mean all reduce ave c_speed
compute least all reduce min c_speed
compute most all reduce max c_speed
variable mean equal c_mean
variable least equal c_least
variable most equal c_most
fix out all print {every} "${{mean}} ${{least}} ${{most}}" file speeds.txt screen no title "mean least most"
run {run}
"""


def lattice_case(folder, alpha, density, delta_t, bonded):
    cell = DIAMETER * (2 * math.pi / 6 / alpha) ** (1 / 3)  # two spheres in each
    edge = CELLS * cell
    every = round(delta_t / (2e-6 if bonded else 2e-5))
    dem = delta_t / every
    n = 2 * CELLS
    case = folder / "foam"
    tank_case.write_case(case, tank_case.box_mesh((0, 0, 0), (edge,) * 3, (n, n, n)), None,
                         tank_case.control(STEPS * delta_t, delta_t, adjust="no"), "", gravity=0)
    h = 3 * DIAMETER
    tank_case.write(case / "constant/couplingProperties",
                    f"coarseGrid {{ min (0 0 0); max ({edge} {edge} {edge}); cellSize {h}; }}\n")
    # as stiff as the DEM step allows
    bonds = (f"fix bonds all bond/parallel young {7e6 * density / 900} stiffness_ratio 2 tensile_strength 1e9 shear_strength 1e9 "
             f"create_gap {2 * (cell * math.sqrt(0.75) / DIAMETER - 1) + 0.1}" if bonded else "")
    (folder / "in.two").write_text(LATTICE.format(
        edge=edge, top=edge, cell=cell, diameter=DIAMETER, density=density, dem=dem, every=every, bonds=bonds,
        run=STEPS * every + 1))


def speeds(folder):
    rows = [[float(word) for word in line.split()] for line in (folder / "speeds.txt").read_text().splitlines()[1:]]
    return rows


def swim(folder, alpha, density, delta_t, bonded):
    """Greatest speed and mean at the end, over the start; inf if the run failed."""
    folder.mkdir()
    lattice_case(folder, alpha, density, delta_t, bonded)
    try:
        pair.mesh(folder, ["blockMesh"])
        pair.launch(folder, 1)
    except SystemExit:
        return math.inf, math.inf
    rows = speeds(folder)
    return max(max(abs(a), abs(b)) for _, a, b in rows) / 1e-3, rows[-1][0] / 1e-3


BED = HEAD.replace("neighbor 0.002", "neighbor 0.001") + """timestep {dem}
region low block 0 {edge} 0 {edge} 0 {edge} units box
lattice custom {cell} a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0.25 0.25 0.25 basis 0.75 0.7 0.8
create_atoms 1 region low
set group all diameter {diameter} density 2500
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran model hertz tangential history primitive type 1 yplane 0.0
fix west all wall/gran model hertz tangential history primitive type 1 xplane 0.0
fix east all wall/gran model hertz tangential history primitive type 1 xplane {edge}
fix south all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix north all wall/gran model hertz tangential history primitive type 1 zplane {edge}
fix motion all nve/sphere
run {settle}
fix fluid all couple/foam
run {run}
"""
SETTLE, MEASURE = 0.1, 0.06  # [s]: until the bed has taken the buoyancy that comes with the coupling; after that


def bed_case(folder, delta_t):
    """Writes the case; returns the cells of the fluid mesh along each axis and the bed's weight per area [Pa]."""
    cell = DIAMETER * (2 * math.pi / 6 / 0.5) ** (1 / 3)
    edge, cells = CELLS * cell, (CELLS, 2 * CELLS, CELLS)
    case = folder / "foam"
    tank_case.write_case(case, tank_case.box_mesh((0, 0, 0), (edge, 2 * edge, edge), cells), None,
                         tank_case.control(SETTLE + MEASURE, delta_t, adjust="no", write_interval=delta_t), "")
    tank_case.write(case / "constant/couplingProperties",
                    f"coarseGrid {{ min (0 0 0); max ({edge} {2 * edge} {edge}); cellSize {3 * DIAMETER}; }}\n")
    (folder / "in.two").write_text(BED.format(edge=edge, top=2 * edge, cell=cell, diameter=DIAMETER, dem=1e-5,
                                              settle=60000, run=round((SETTLE + MEASURE) / 1e-5) + 1))
    spheres = 2 * CELLS**3
    return cells, spheres * math.pi / 6 * DIAMETER**3 * 1500 * 9.81 / edge**2


def floor_pressures(folder, cells, delta_t):
    """Mean p_rgh over the lowest layer less that of the highest, per written time [Pa]."""
    nx, ny, nz = cells
    pressures = []
    for step in range(round(SETTLE / delta_t), round((SETTLE + MEASURE) / delta_t) + 1):
        p = fc.lists(folder / "foam" / f"{step * delta_t:.10g}" / "p_rgh")[0]
        layer = [sum(p[i + nx * (j + ny * k)] for i in range(nx) for k in range(nz)) / nx / nz for j in (0, ny - 1)]
        pressures.append(layer[0] - layer[1])
    return pressures


def rest(folder, delta_t):
    """rms of the pressure drop over the bed's weight per area; inf if the run failed."""
    folder.mkdir()
    cells, weight = bed_case(folder, delta_t)
    try:
        pair.mesh(folder, ["blockMesh"])
        pair.launch(folder, 1)
    except SystemExit:
        return math.inf
    return statistics.pstdev(floor_pressures(folder, cells, delta_t)) / weight


QUICK = [(0.62, 900, 1e-3, False), (0.5, 500, 1e-3, False), (0.62, 2500, 4e-3, False), (0.62, 10, 1e-3, False)]


MAP = list(itertools.product((0.1, 0.3, 0.5, 0.64), (10, 100, 900, 2500, 10000), (2e-4, 2e-3), (False,)))
MAP += itertools.product((0.3, 0.5, 0.64), (100, 900, 2500), (2e-4, 2e-3), (True,))  # thinner lattices have no bonds


def row(point, greatest, end):
    alpha, density, delta_t, bonded = point
    good = greatest < 1.5 and abs(end) < 1
    return good, (f"αs {alpha}, ρp {density}, Δt {1e3 * delta_t:g} ms, {'bonded' if bonded else 'loose'}: "
                  f"greatest speed {greatest:.3g}, mean at the end {end:.3g} of the start")


def swim_rows(scratch):
    passed = True
    for n, point in enumerate(QUICK):
        good, text = row(point, *swim(scratch / str(n), *point))
        passed &= good
        print("PASS" if good else "FAIL", text, flush=True)
    return passed


def rest_rows(scratch):
    passed = True
    for delta_t in (5e-4, 1e-3, 2e-3, 4e-3):
        rms = rest(scratch / f"bed{delta_t}", delta_t)
        passed &= rms < 0.01
        print(f"{'PASS' if rms < 0.01 else 'FAIL'} bed at rest, Δt {1e3 * delta_t:g} ms: rms of the pressure drop "
              f"{rms:.2%} of the bed's weight per area (1 %)", flush=True)
    return passed


def draw_map(path, scratch):
    """Appends the points that the file does not have yet."""
    known = path.read_text() if path.exists() else ""
    for n, point in enumerate(MAP):
        key = row(point, 0, 0)[1].split(":")[0]
        if key in known:
            continue
        good, text = row(point, *swim(scratch / str(n), *point))
        with open(path, "a") as out:
            print("stable" if good else "UNSTABLE", text, file=out)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--map", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="frazil-stability-") as folder:
        if options.map:
            sys.exit(draw_map(options.map, Path(folder)))
        passed = [swim_rows(Path(folder)), rest_rows(Path(folder))]
    sys.exit(not all(passed))


if __name__ == "__main__":
    main()
