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
import sys
import tempfile
from pathlib import Path

import two_bodies
from two_bodies import body_case

DIAMETER, CELLS = 0.003, 6  # [m], lattice cells along each edge
STEPS = 60  # of the fluid

LATTICE = """
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region box block 0 {edge} 0 {edge} 0 {edge} units box
create_box 1 box
neighbor 0.001 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep {dem}
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
    every = max(4, round(delta_t / 2e-5))
    dem = delta_t / every
    n = 2 * CELLS
    case = folder / "foam"
    body_case.write_case(case, body_case.box_mesh((0, 0, 0), (edge,) * 3, (n, n, n)), None,
                         body_case.control(STEPS * delta_t, delta_t, adjust="no"), "", gravity=0)
    h = 3 * DIAMETER
    body_case.write(case / "constant/couplingProperties",
                    f"coarseGrid {{ min (0 0 0); max ({edge} {edge} {edge}); cellSize {h}; }}\n")
    bonds = ("fix bonds all bond/parallel young 1e6 stiffness_ratio 2 tensile_strength 1e9 shear_strength 1e9 "
             f"create_gap {cell * math.sqrt(0.75) / DIAMETER - 1 + 0.05}" if bonded else "")
    (folder / "in.two").write_text(LATTICE.format(
        edge=edge, cell=cell, diameter=DIAMETER, density=density, dem=dem, every=every, bonds=bonds,
        run=STEPS * every + 1))


def speeds(folder):
    rows = [[float(word) for word in line.split()] for line in (folder / "speeds.txt").read_text().splitlines()[1:]]
    return rows


def swim(folder, alpha, density, delta_t, bonded):
    """Greatest speed and mean at the end, over the start; inf if the run failed."""
    folder.mkdir()
    lattice_case(folder, alpha, density, delta_t, bonded)
    try:
        two_bodies.mesh(folder, ["blockMesh"])
        two_bodies.launch(folder, 1)
    except SystemExit:
        return math.inf, math.inf
    rows = speeds(folder)
    return max(max(abs(a), abs(b)) for _, a, b in rows) / 1e-3, rows[-1][0] / 1e-3


QUICK = [(0.62, 900, 1e-3, False), (0.5, 500, 1e-3, False), (0.62, 2500, 4e-3, False), (0.62, 10, 1e-3, False)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--map")
    options = parser.parse_args()
    passed = True
    points = QUICK if not options.map else list(itertools.product(
        (0.1, 0.3, 0.5, 0.64), (10, 100, 500, 900, 2500, 10000), (2e-4, 1e-3, 4e-3), (False, True)))
    with tempfile.TemporaryDirectory(prefix="frazil-stability-") as scratch:
        for n, (alpha, density, delta_t, bonded) in enumerate(points):
            greatest, end = swim(Path(scratch) / str(n), alpha, density, delta_t, bonded)
            good = greatest < 1.5 and abs(end) < 1
            passed &= good
            print(f"{'PASS' if good else 'FAIL'} αs {alpha}, ρp {density}, Δt {1e3 * delta_t:g} ms, "
                  f"{'bonded' if bonded else 'loose'}: greatest speed {greatest:.3g}, mean at the end {end:.3g} of the "
                  "start", flush=True)
    sys.exit(not passed)


if __name__ == "__main__":
    main()
