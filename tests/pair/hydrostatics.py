"""The forces on fixed spheres across a still surface must not know where the origin of the vertical axis lies: the case
hydrostatics twice, the second time 1 m (ten depths of its tank) higher. A shift by h adds ρ g h to p_rgh, and with it
round-off to its gradient: about 1e-10 of the buoyancy per metre. FRAZIL_BUILD names the build folder."""

import math
import sys
import tempfile
from pathlib import Path

import shipped_case

TOLERANCE = 1e-9  # of the buoyancy in water


def forces(path):
    """{id: force [N]} of the last snapshot of dem/forces.dump."""
    last = (path / "dem/forces.dump").read_text().split("ITEM: ATOMS")[-1].splitlines()[1:]
    rows = [[float(word) for word in line.split()] for line in last]
    return {int(row[0]): row[4:] for row in rows}


def main():
    with tempfile.TemporaryDirectory() as folder:
        runs = [shipped_case.run("hydrostatics", Path(folder) / name, [f"origin={origin}"])
                for name, origin in (("here", 0.0), ("there", 1.0))]
        here, there = (forces(run.folder) for run in runs)
    scale = 1000 * 9.81 * math.pi / 6 * 0.002**3
    worst = max(abs(a - b) for i in here for a, b in zip(here[i], there[i])) / scale
    print(f"forces with the origin 1 m away: largest difference {worst:.3g} of the buoyancy in water ({TOLERANCE:g})")
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
