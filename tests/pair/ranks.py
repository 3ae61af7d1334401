#!/usr/bin/env python3
"""The real pair on several numbers of ranks breaks the same ice: ranks.py [scale]

A small plate of ice_entry is struck and breaks. Against the run on 1:1 ranks (frazilDem:frazilFoam)

    2:1                  same broken bonds, positions within 1e-9 of the sphere's diameter D
    1:2, 2:2, 2:4, 4:3   same broken bonds, positions within 1e-6 D (the fluid's linear solvers end at 1e-14 there)

over at least 200 fluid steps, which must include the first cracks.
"""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import pair
from pair import ROOT, replace

DIAMETER = 0.00465
STEPS = 200
CASE = {  # ice_entry's demo level with a plate and a fluid that run in seconds; the projectile starts almost in touch
    "columns": 11, "rows": 13, "cells_per_diameter": 3, "core_radius": 0.016, "core_depth": 0.032,
    "core_height": 0.016, "growth": 1.6, "coarse_cells": 16, "reach_below": 0.08, "gap": 0.0002,
    "end_time": 4.2e-4, "max_courant": 0.2, "tensile_strength": 0.6e6, "shear_strength": 0.4e6,
}
LONGEST_STEP = 2e-6


def prepare(folder, foam_ranks):
    """Run folder with tight solvers, a fixed short step and positions of all spheres at the end."""
    level = json.loads((ROOT / "cases/ice_entry/case.json").read_text())["levels"]["demo"]
    (folder / "params.json").write_text(json.dumps({**level, **CASE}))
    subprocess.run([sys.executable, ROOT / "cases/ice_entry/prepare", folder, folder / "params.json"], check=True,
                   stdout=subprocess.DEVNULL)
    replace(folder / "foam/system/fvSolution", ("tolerance       1e-08", "tolerance 1e-14"),
            ("tolerance       1e-09", "tolerance 1e-14"), ("tolerance       1e-10", "tolerance 1e-14"),
            ("relTol          0.01", "relTol 0"))
    replace(folder / "foam/system/controlDict", ("adjustTimeStep  yes", "adjustTimeStep no"))
    text = (folder / "foam/system/controlDict").read_text().splitlines()
    text = [f"deltaT {LONGEST_STEP};" if line.startswith("deltaT") else line for line in text]
    (folder / "foam/system/controlDict").write_text("\n".join(text))
    script = folder / "dem/in.ice_entry"
    replace(script, ("run ${steps}", "dump all ice custom 20 dem/positions id x y z\n"
                     "dump_modify all format \"%d %.17g %.17g %.17g\"\nrun ${steps}"))
    (folder / "foam/system/decomposeParDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
        f"numberOfSubdomains {foam_ranks};\nmethod hierarchical;\n"
        f"hierarchicalCoeffs {{ n ({foam_ranks} 1 1); delta 0.001; order xyz; }}\n")


def run(folder, dem_ranks, foam_ranks, edit=None):
    """Outcome of one run of the pair; edit(folder) may change its inputs."""
    prepare(folder, foam_ranks)
    if edit:
        edit(folder)
    pair.mesh(folder, ["blockMesh", "setFields"] + (["decomposePar"] if foam_ranks > 1 else []))
    pair.launch(folder, dem_ranks, foam_ranks, "dem/in.ice_entry")
    return outcome(folder)


def outcome(folder):
    """(broken bonds, positions by id, number of fluid steps) of a run."""
    with open(folder / "dem/bonds.csv") as file:
        broken = sorted((row["id1"], row["id2"], row["mode"]) for row in csv.DictReader(file))
    last = (folder / "dem/positions").read_text().split("ITEM: ATOMS")[-1].splitlines()[1:]
    positions = {row.split()[0]: [float(word) for word in row.split()[1:4]] for row in last}
    return broken, positions, len((folder / "ledger.csv").read_text().splitlines()) - 1


def compare(name, result, reference, limit):
    """Prints how a run differs from the reference; whether it passes."""
    (others, moved, _), (broken, positions, _) = result, reference
    same = moved.keys() == positions.keys()
    shift = max(abs(a - b) for i in positions for a, b in zip(positions[i], moved[i])) / DIAMETER if same else float("inf")
    passed = others == broken and shift <= limit
    print(f"{'PASS' if passed else 'FAIL'} {name}  {len(others)} bonds broken, "
          f"{'the same' if others == broken else 'others'}, positions within {shift:.2g} D (limit {limit:g} D)", flush=True)
    return passed


def main():
    with tempfile.TemporaryDirectory(prefix="frazil-ranks-") as scratch:
        results = {}
        for dem, foam in ((1, 1), (2, 1), (1, 2), (2, 2), (2, 4), (4, 3)):
            folder = Path(scratch) / f"{dem}-{foam}"
            folder.mkdir()
            results[dem, foam] = run(folder, dem, foam)
    broken, positions, steps = reference = results.pop((1, 1))
    print(f"1:1  {steps} fluid steps, {len(broken)} bonds broken, {len(positions)} spheres")
    passed = [compare(f"{dem}:{foam}", result, reference, 1e-9 if foam == 1 else 1e-6)
              for (dem, foam), result in results.items()]
    sys.exit(not (all(passed) and steps >= STEPS and broken))


if __name__ == "__main__":
    main()
