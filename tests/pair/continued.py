#!/usr/bin/env python3
"""A coupled run that is split, or restarted in the middle of breaking, goes on as if nothing had happened.

The small plate of ranks.py, with contacts that depend on positions alone: LIGGGHTS evaluates damping and friction anew when
a run is set up, so that no continued run of them equals an unbroken one. Against one unbroken `run` on 1:1 ranks

    split      DEM runs that end inside fluid steps and at their ends: same broken bonds, positions within 1e-9 D
    restarted  by `./frazil run --resume` from files that both programs wrote while bonds broke, on 1:1 and 2:1 ranks: the same

and the same for a plate of loose spheres, whose forces carry the answer of the pressure from one fluid step to the next.
"""
import json
import shutil
import sys
import tempfile
from pathlib import Path

import pair
import ranks
from launcher.cli import parser
from launcher.resume import resume

PIECES = (331, 202, 5, 1, 17)  # DEM steps
MIDDLE = 2.8e-4  # fluid time of the restart [s]


def memoryless(folder):
    """Elastic contacts without friction, no dashpots in the bonds."""
    script = folder / "dem/in.ice_entry"
    pair.replace(script, ("peratomtypepair 2 0.3 0.3 0.3 0.3", "peratomtypepair 2 1 1 1 1"))
    script.write_text(script.read_text().replace("tangential history", "tangential off"))
    parameters = folder / "dem/parameters"
    lines = [line if "bond_damping" not in line else "variable bond_damping string 0" for line in
             parameters.read_text().splitlines()]
    parameters.write_text("\n".join(lines) + "\n")


def split(folder):
    """Five runs instead of one, none of a length that the fluid's steps divide."""
    memoryless(folder)
    pieces = "".join(f"run {length} stop ${{steps}}\n" for length in PIECES)
    rest = f"variable rest equal ${{steps}}-{sum(PIECES)}\nrun ${{rest}}"
    pair.replace(folder / "dem/in.ice_entry", ("\nrun ${steps}", f"\n{pieces}{rest}"))


def with_restart(folder):
    """As before, with restart files and the fluid's fields at MIDDLE."""
    memoryless(folder)
    control = folder / "foam/system/controlDict"
    lines = [f"writeInterval {MIDDLE};" if line.startswith("writeInterval") else line
             for line in control.read_text().splitlines()]
    control.write_text("\n".join(lines) + "\n")
    (folder / "run.json").write_text(json.dumps({"case": str(pair.ROOT / "cases/ice_entry"), "level": "demo", "np_dem": 1,
                                                 "np_foam": 1}))


def loose(folder):
    """With restart files, and one bond in the whole plate."""
    with_restart(folder)
    (folder / "dem/bond").write_text("1 2\n")
    pair.replace(folder / "dem/in.ice_entry", ("damping ${bond_damping}", "damping ${bond_damping} list dem/bond"))


def restarted(whole, folder, dem_ranks):
    """A copy of a finished run, set back to MIDDLE as `./frazil run --resume` does it, run to the end again."""
    shutil.copytree(whole, folder)
    words = ["run", "ice_entry", "--resume", "--out", str(folder)]
    resume(parser().parse_args(words))
    before = len((folder / "dem/bonds.csv").read_text().splitlines()) - 1
    pair.launch(folder, dem_ranks, script="dem/in.ice_entry")
    return before, ranks.outcome(folder)


def compare_restarts(scratch, name, reference):
    """Whether the finished run in the folder `name`, set back and run again on 1:1 and 2:1 ranks, ends as the reference."""
    passed = []
    for dem in (1, 2):
        before, result = restarted(scratch / name, scratch / f"{name}-{dem}", dem)
        passed += [ranks.compare(f"{name} restarted on {dem}:1 after {before} had broken", result, reference, 1e-9),
                   not reference[0] or 0 < before < len(reference[0])]
    return all(passed)


def main():
    with tempfile.TemporaryDirectory(prefix="frazil-continued-") as scratch:
        results = {}
        for name, edit in (("unbroken", memoryless), ("split", split), ("bonded", with_restart), ("loose", loose)):
            folder = Path(scratch) / name
            folder.mkdir()
            results[name] = ranks.run(folder, 1, 1, edit)
        reference = broken, positions, steps = results["unbroken"]
        print(f"unbroken  {steps} fluid steps, {len(broken)} bonds broken, {len(positions)} spheres")
        passed = [bool(broken), ranks.compare("split", results["split"], reference, 1e-9),
                  ranks.compare("with restart files", results["bonded"], reference, 1e-9),
                  compare_restarts(Path(scratch), "bonded", reference),
                  compare_restarts(Path(scratch), "loose", results["loose"])]
    sys.exit(not all(passed))


if __name__ == "__main__":
    main()
