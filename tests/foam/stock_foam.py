#!/usr/bin/env python3
"""frazilFoam without couplingProperties equals interFoam on stock tutorials, serial and on 2 ranks, to 1e-10 relative.

Usage: stock_foam.py FRAZILFOAM INTERFOAM_HERE WORK_FOLDER NAME...    names of stock_foam_cases.py, or "all"

Every field and mesh file that the programs leave is compared with those of
- interFoamHere, OpenFOAM's interFoam.C built as frazilFoam is, at the end time. Measured: 0, bit for bit;
- interFoam as installed, serial, after the first steps of cases whose cells are aligned with the axes. On others
  Debian's binary is wrong (FindOpenFOAM.cmake), and later or on more ranks the compilers' different rounding changes a
  number of iterations, hence the fields by the solvers' tolerance. Measured: at most 4e-11.
A step that fails stops the test with the end of its log.
"""

import concurrent.futures
import os
import pathlib
import sys
import time

import foam_case as fc
from stock_foam_cases import CASES

TOLERANCE = 1e-10
NEEDED = ("U", "p", "p_rgh", "phi")


def replace(path, old, new):
    """Replace a text that must be there."""
    text = path.read_text()
    if old not in text:
        raise SystemExit(f"{path}: does not contain '{old}'")
    path.write_text(text.replace(old, new))


def override(path, entries):
    """Entries at the end of a dictionary replace those above."""
    with open(path, "a") as out:
        out.writelines(f"\n{key} {value};" for key, value in entries.items())
        out.write("\n")


def stop_at(case, end, interval):
    """Write at multiples of the interval, the last of which is the end time."""
    override(case / "system/controlDict", {"endTime": end, "writeControl": "adjustable", "writeInterval": interval})


def start_fields(case):
    """What restore0Dir and `cp alpha.water.orig alpha.water` do in a tutorial's Allrun."""
    if (case / "0.orig").is_dir():
        fc.copy_case(case / "0.orig", case / "0")
    for path in (case / "0").glob("*.orig"):
        path.with_suffix("").write_bytes(path.read_bytes())


def prepare(stock, folder):
    """The tutorial with its mesh and start fields, ready to run on one rank or to be decomposed."""
    case = fc.copy_case(fc.openfoam_root() / "tutorials/multiphase/interFoam" / stock.tutorial, folder)
    override(case / "system/controlDict", {"startFrom": "latestTime", "writeFormat": "binary", "timePrecision": 10,
                                           **stock.control})
    for path, old, new in stock.edits:
        replace(case / path, old, new)
    start_fields(case)
    for number, command in enumerate(stock.prepare):
        fc.run(["sh", "-c", command], case, f"log.prepare{number}")
    return case


def decompose(case, split):
    """Processor folders, by a method that every OpenFOAM has."""
    header = "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
    text = f"numberOfSubdomains 2; method hierarchical; coeffs {{ n ({split}); order xyz; }}\n"
    (case / "system/decomposeParDict").write_text(header + text)
    fc.run(["decomposePar"], case, "log.decomposePar")


def run_to(ends, interval, stock, source, program, ranks):
    """One program through the given end times, in a folder of its own."""
    name = pathlib.Path(program).name
    case = fc.copy_case(source, source.parent / f"{name}_{ranks}")
    launch, flags = ([], []) if ranks == 1 else (fc.MPIRUN + ["-np", ranks], ["-parallel"])
    for number, end in enumerate(ends):
        stop_at(case, end, interval)
        fc.run(launch + [program, *flags, *stock.flags], case, f"log.{name}{number}")
    return case


def run_all(stock, case, programs, ranks):
    """Folders of the programs' runs, serial ones side by side; the third program, the installed one, stops early."""
    ends = [stock.end, stock.end]
    if stock.early and ranks == 1:
        ends.append((stock.early,))
    interval = stock.early or stock.end[0]
    with concurrent.futures.ThreadPoolExecutor(2 if ranks == 1 else 1) as pool:
        jobs = [pool.submit(run_to, end, interval, stock, case, program, ranks) for end, program in zip(ends, programs)]
        return [job.result() for job in jobs]


def compare(frazil, other, ranks):
    """End time of the other program's run, and the greatest relative difference of each file there."""
    import foam_fields
    parts = ["."] if ranks == 1 else [f"processor{i}" for i in range(ranks)]
    end = fc.last_time(other / parts[0])
    if float(end) == 0 or not all((folder / part / end).is_dir() for folder in (frazil, other) for part in parts):
        raise SystemExit(f"{frazil} has not the end time {end} of {other}")
    worst = foam_fields.differences([other / part / end for part in parts], [frazil / part / end for part in parts])
    missing = set(NEEDED) - set(worst)
    if missing or not any(name.startswith("alpha.") for name in worst):
        raise SystemExit(f"{other}: alpha or one of {NEEDED} is missing")
    return end, worst


def check(name, programs, work):
    """True if frazilFoam, the first of the programs, agrees with the others, serial and on 2 ranks."""
    stock = CASES[name]
    work.mkdir(parents=True, exist_ok=True)
    case = prepare(stock, work / "case")
    agree = True
    for ranks in (1, 2):
        begin = time.time()
        if ranks > 1:
            decompose(case, stock.split)
        frazil, *others = run_all(stock, case, programs, ranks)
        for other in others:
            end, worst = compare(frazil, other, ranks)
            field = max(worst, key=worst.get)
            agree = agree and worst[field] <= TOLERANCE
            print(f"{name}, {ranks} rank(s), t = {end} s, {other.name[:-2]}: greatest relative difference"
                  f" {worst[field]:.3g} ({field}) of {len(worst)} files, allowed {TOLERANCE:g}")
        print(f"{name}, {ranks} rank(s): {time.time() - begin:.1f} s", flush=True)
    return agree


def main():
    try:
        import numpy  # noqa: F401
    except ImportError:
        print("skipped: Python's numpy is missing")
        sys.exit(77)
    programs = [str(pathlib.Path(path).resolve()) for path in sys.argv[1:3]] + ["interFoam"]
    work, names = pathlib.Path(sys.argv[3]).resolve(), sys.argv[4:]
    names = list(CASES) if names == ["all"] else names
    unknown = set(names) - set(CASES)
    if unknown or not names:
        raise SystemExit(f"unknown case {sorted(unknown)}; known: {', '.join(CASES)}")

    # Debian's libraries read a value past the end of some lists (valgrind shows it in sqr); what lies there must not end
    # a run. One that diverges shows as values that are no numbers
    os.environ["FOAM_SIGFPE"] = "false"
    results = [check(name, programs, work / name) for name in names]
    sys.exit(not all(results))


if __name__ == "__main__":
    main()
