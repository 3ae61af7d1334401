"""`dualGrid off` on two fluid ranks, of which one has no particle: settling_sphere runs and its ledger closes.

Cells are found by a search structure that all ranks must build together. FRAZIL_BUILD names the build folder.
"""

import csv
import sys
import tempfile
from pathlib import Path

import shipped_case
from launcher.run import prepare
from launcher.watch import start_programs, watch

LIMIT = 1e-8


def run(folder):
    """A short run of the case, both spheres in the first rank's half; rows of its ledger."""
    planned = shipped_case.planned("settling_sphere", folder, ["end_time=0.02"], np_foam=2)
    prepare(planned)
    with (planned.folder / "foam/constant/couplingProperties").open("a") as stream:
        stream.write("\ndualGrid off;\n")
    script = planned.folder / "dem/in.settling_sphere"
    script.write_text(script.read_text().replace("single ${offset} ${light_y} ${offset}",
                                                 "single -${offset} ${light_y} -${offset}"))
    watch(planned, start_programs(planned))
    with (planned.folder / "ledger.csv").open() as stream:
        return list(csv.DictReader(stream))


def main():
    with tempfile.TemporaryDirectory() as folder:
        rows = run(folder)
    errors = {name: max(float(row[name]) for row in rows) for name in rows[0] if "Error" in name}
    lost = sum(float(row["particlesLost"]) for row in rows)
    print(f"{len(rows)} exchanges, {lost:g} particles lost, largest errors {errors}")
    sys.exit(len(rows) < 10 or lost != 0 or max(errors.values()) > LIMIT)


main()
