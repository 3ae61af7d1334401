#!/usr/bin/env python3
"""frazilFoam without couplingProperties equals interFoam: damBreak, laminar, serial and on 4 ranks, to 1e-10 relative.

Usage: stock_foam.py FRAZILFOAM WORK_FOLDER [TUTORIAL [END_TIME]]
TUTORIAL is a folder below tutorials/multiphase/interFoam (default laminar/damBreak/damBreak).
"""

import pathlib
import sys

import foam_case as fc

TOLERANCE = 1e-10
FIELDS = {"U", "p", "p_rgh", "phi", "alpha.water"}


def prepare(tutorial, folder, end_time):
    """The tutorial with its mesh and start fields, written in full precision."""
    case = fc.copy_case(fc.openfoam_root() / "tutorials/multiphase/interFoam" / tutorial, folder)
    control = case / "system/controlDict"
    for key, value in {"writePrecision": "16", "writeFormat": "ascii"}.items():
        fc.set_entry(control, key, value)
    if end_time:
        for key, value in {"endTime": end_time, "writeInterval": end_time}.items():
            fc.set_entry(control, key, value)
    if (case / "0.orig").is_dir():
        fc.copy_case(case / "0.orig", case / "0")
    fc.run(["blockMesh"], case, "log.blockMesh")
    if (case / "system/setFieldsDict").exists():
        fc.run(["setFields"], case, "log.setFields")
    return case


def compare(case, frazil_foam, ranks):
    """Run both programs on copies of a case; greatest relative difference of the fields at the end."""
    launch, flags = [], []
    if ranks > 1:
        fc.set_entry(case / "system/decomposeParDict", "method", "hierarchical")
        fc.run(["decomposePar", "-force"], case, "log.decomposePar")
        launch, flags = fc.MPIRUN + ["-np", ranks], ["-parallel"]
    folders = {}
    for name, program in {"interFoam": "interFoam", "frazilFoam": frazil_foam}.items():
        folders[name] = fc.copy_case(case, case.parent / f"{case.name}_{name}_{ranks}")
        fc.run(launch + [program] + flags, folders[name], "log." + name)

    worst = {}
    for part in ["."] if ranks == 1 else [f"processor{i}" for i in range(ranks)]:
        here = folders["interFoam"] / part
        time = fc.last_time(here)
        found = fc.difference(here / time, folders["frazilFoam"] / part / time)
        if not FIELDS <= set(found):
            raise SystemExit(f"{here / time}: missing fields {FIELDS - set(found)}")
        worst = {key: max(value, worst.get(key, 0)) for key, value in found.items()}
    return time, worst


def main():
    frazil_foam, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    tutorial = sys.argv[3] if len(sys.argv) > 3 else "laminar/damBreak/damBreak"
    end_time = sys.argv[4] if len(sys.argv) > 4 else None
    work.mkdir(parents=True, exist_ok=True)
    case = prepare(tutorial, work / "case", end_time)
    failed = False
    for ranks in (1, 4):
        time, worst = compare(case, frazil_foam, ranks)
        greatest = max(worst.values())
        failed |= greatest > TOLERANCE
        print(f"{tutorial}, {ranks} rank(s), t = {time} s: greatest relative difference {greatest:.3g}"
              f" of {len(worst)} fields, allowed {TOLERANCE:g}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
