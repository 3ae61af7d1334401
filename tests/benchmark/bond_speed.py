#!/usr/bin/env python3
"""How fast is fix bond/parallel? bond_speed.py [--dem PROGRAM] [--steps N] [--repeats N] [--damping Z] [--ranks N]

The paper's plate, 83 x 96 x 8 spheres of 2.4 mm in hexagonal close packing (63,744 spheres, about 354,000 bonds), at rest,
with and without bonds in turn. Prints for the median of the repeats

    step          wall time of a DEM step [ms], of LIGGGHTS's own loop timer, with and without bonds
    bonds         the difference of both: all that the fix costs, the cost of its callbacks included
    updates       bonds / that difference / ranks [1/s and core]
    share         of the step with bonds

A program, not a test: times depend on the machine, so only compare figures of one run.
"""
import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
import ice
from bond_dem import D, E, KAPPA, MODEL, RHO, bond, head

COLUMNS, ROWS, LAYERS = 83, 96, 8

SCRIPT = """
fix integrate all nve/sphere
timestep {step:.17g}
thermo {steps}
run 20
run {steps}
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--dem", default=str(ROOT / "build/bin/frazilDem"))
    parser.add_argument("--steps", type=int, default=200)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--damping", type=float, default=0.0, help="fraction of critical damping of the bonds")
    parser.add_argument("--skin", type=float, default=0.25, help="neighbour skin in diameters")
    parser.add_argument("--ranks", type=int, default=1)
    return parser.parse_args()


def step_time(options, folder, bonds):
    """(wall time of a step [s], number of bonds)"""
    step = 0.05*ice.critical_step(D, RHO, E, KAPPA)
    script = head(data_file="plate.data", skin=options.skin*D) + MODEL + (bond(more=f"damping {options.damping}") if bonds else "")
    (folder / "in.speed").write_text(script + SCRIPT.format(step=step, steps=options.steps))
    command = [os.path.abspath(options.dem), "-in", "in.speed", "-log", "log.speed"]
    if options.ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(options.ranks), *command]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout[-2000:]}")
    log = (folder / "log.speed").read_text()
    loops = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", log, re.M)
    created = re.search(r"(\d+) bonds created", log)
    return float(loops[-1][0])/int(loops[-1][1]), int(created.group(1)) if created else 0


def main():
    options = arguments()
    with tempfile.TemporaryDirectory(prefix="frazil-speed-") as scratch:
        folder = Path(scratch)
        points = ice.plate(D, COLUMNS, ROWS, LAYERS)
        box = [(min(axis) - D, max(axis) + D) for axis in zip(*points)]
        ice.write_data(folder / "plate.data", points, D, RHO, box, types=1)
        without, with_bonds = [], []
        for _ in range(options.repeats):
            without.append(step_time(options, folder, False)[0])
            seconds, bonds = step_time(options, folder, True)
            with_bonds.append(seconds)
    bare, full = statistics.median(without), statistics.median(with_bonds)
    print(f"{len(points)} spheres, {bonds} bonds, {options.ranks} ranks, median of {options.repeats} runs of "
          f"{options.steps} steps")
    print(f"step without bonds {1e3*bare:.1f} ms, with bonds {1e3*full:.1f} ms, bonds {1e3*(full - bare):.1f} ms")
    print(f"{bonds/(full - bare)/options.ranks/1e6:.1f} million bond updates per second and core, "
          f"{(full - bare)/full:.0%} of the step")


main()
