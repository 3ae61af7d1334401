#!/usr/bin/env python3
"""A sphere towed through still water at constant velocity feels its buoyancy and its drag, and no added mass.

On 1 and 2 ranks of frazilDem (of which the second takes over half-way), by `fix move linear` and by `fix nve/noforce`:

    upwards     ρ g V, less what the path's own flow does to it                                0.1 %
    along       the drag law at the towing speed (Di Felice, one sphere)                       1 %

FRAZIL_BUILD names the build folder.
"""
import math
import sys
import tempfile
from pathlib import Path

import dem_script
import pair
import tank_case

DIAMETER, SPEED, NU = 0.002, 0.1, 1.79e-6  # [m] [m/s] [m2/s] of tank_case's water
STEP, END = 2e-5, 0.2
HALF = 0.06

BOX = dem_script.box((-HALF,) * 3, (HALF,) * 3)
SCRIPT = dem_script.head(BOX, processors="* 1 1", sort=" sort 0 0") + "timestep {step}\n" + dem_script.GRAVITY + f"""
create_atoms 1 single -0.01 0 0 units box
set group all diameter {DIAMETER} density 7800
velocity all set {SPEED} 0 0 units box
{{motion}}
fix fluid all couple/foam
variable fx equal f_fluid[3]
variable fy equal f_fluid[4]
fix out all print 50 "${{{{fx}}}} ${{{{fy}}}}" file forces.txt screen no title "fx fy"
run {round(END / STEP) + 1}
"""


def write_fluid(folder):
    case = folder / "foam"
    tank_case.write_case(case, tank_case.box_mesh((-HALF,) * 3, (HALF,) * 3, (12,) * 3), None,
                         tank_case.control(END, 1e-3, adjust="no"), "")
    tank_case.write(case / "constant/couplingProperties",
                    f"coarseGrid {{ min (-{HALF} -{HALF} -{HALF}); max ({HALF} {HALF} {HALF}); cellSize 0.02; }}\n")


def forces(folder):
    """Means of fx and fy [N] over the second half."""
    rows = [[float(word) for word in line.split()] for line in (folder / "forces.txt").read_text().splitlines()[1:]]
    late = rows[len(rows) // 2:]
    return [sum(column) / len(late) for column in zip(*late)]


def expected():
    reynolds = SPEED * DIAMETER / NU
    drag = 0.5 * 1000 * SPEED**2 * (0.63 + 4.8 / math.sqrt(reynolds))**2 * math.pi / 4 * DIAMETER**2
    return -drag, 1000 * 9.81 * math.pi / 6 * DIAMETER**3


def tow(folder, motion, ranks):
    """Whether both forces are right."""
    folder.mkdir()
    write_fluid(folder)
    pair.mesh(folder, ["blockMesh"])
    (folder / "in.two").write_text(SCRIPT.format(step=STEP, motion=motion))
    pair.launch(folder, ranks)
    passed = True
    for name, force, right, limit in zip(("along", "upwards"), forces(folder), expected(), (1e-2, 1e-3)):
        good = abs(force / right - 1) <= limit
        print(f"{'PASS' if good else 'FAIL'} {motion}, {ranks} ranks, {name}: {force:.6g} N, expected {right:.6g} N, "
              f"off by {force / right - 1:.2g} (limit {limit:g})", flush=True)
        passed &= good
    return passed


def main():
    with tempfile.TemporaryDirectory(prefix="frazil-towed-") as scratch:
        motions = f"fix tow all move linear {SPEED} 0 0", "fix tow all nve/noforce"
        passed = [tow(Path(scratch) / f"{index}-{ranks}", motion, ranks)
                  for index, motion in enumerate(motions) for ranks in (1, 2)]
    sys.exit(not all(passed))


if __name__ == "__main__":
    main()
