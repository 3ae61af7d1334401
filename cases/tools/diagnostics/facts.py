"""What was run, in words: from run.json, the logs and the files' own dates."""
from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path

from .catalogue import Missing
from .run import Run


def case(run: Run) -> str:
    """Case and level."""
    if not run.plan:
        raise Missing(f"{run.folder / 'run.json'}: does not exist; the pair was started by hand.")
    return f"{Path(run.plan['case']).name}, {run.plan['level']}"


def ranks(run: Run) -> str:
    """Of both programs."""
    case(run)
    dem, foam = run.plan["np_dem"], run.plan["np_foam"]
    return f"frazilDem {dem}" + (f", frazilFoam {foam}" if foam else ", no fluid")


def begun(run: Run) -> str:
    """Date of the inputs, which the launcher wrote before the programs began."""
    path = next((run.folder / name for name in ("params.json", "history.csv") if (run.folder / name).is_file()), None)
    if path is None:
        raise Missing(f"{run.folder / 'params.json'}: does not exist.")
    return date(path)


def date(path: Path) -> str:
    """When a file was last written, in local time."""
    return datetime.fromtimestamp(path.stat().st_mtime).strftime("%Y-%m-%d %H:%M")


def state(run: Run) -> str:
    """Whether the fluid's endTime was reached, or a program failed; else how far it is and when it wrote last."""
    history, end = run.history, run.entry("foam/system/controlDict", "endTime")
    time = float(history["time"][-1])
    if history["substeps"][-1] == 0 and time + history["fluid_dt"].max() >= end:  # the next step would have passed it
        return f"complete: {1e3 * end:.4g} ms"
    reached, failed = f"{1e3 * time:.4g} of {1e3 * end:.4g} ms", run.folder / "log.exit"
    if failed.is_file() and failed.read_text().split():
        program, code = failed.read_text().split()[:2]
        return f"{program} failed (exit code {code}) after {reached}"
    return f"not complete: {reached}, last row written {date(run.folder / 'history.csv')}"


def said(run: Run, log: str, pattern: str) -> str:
    """What a pattern catches in a log."""
    found = re.search(pattern, run.log(log), re.MULTILINE)
    if not found:
        raise Missing(f"{run.folder / log}: does not say it (yet).")
    return found.group(1)


def frazil(run: Run) -> str:
    """Version of this checkout when the run was prepared."""
    if "version" not in run.plan:
        raise Missing(f"{run.folder / 'run.json'}: has no version.")
    return run.plan["version"]


def liggghts(run: Run) -> str:
    """Version of LIGGGHTS."""
    return said(run, "log.dem", r"^LIGGGHTS \(Version ([^,)]*)")


def openfoam(run: Run) -> str:
    """Version of OpenFOAM."""
    return said(run, "log.foam", r"^Build  : (.*)$")


def spheres(run: Run) -> str:
    """Coupled spheres and DEM step, as the handshake had them."""
    return said(run, "log.foam", r"^frazilDem: (.*?); coarse grid")


def coarse_grid(run: Run) -> str:
    """Cells of the coarse grid."""
    return said(run, "log.foam", r"coarse grid (.*?) m$") + " m"


def fluid_cells(run: Run) -> str:
    """Cells of the fluid's mesh."""
    return said(run, "log.prepare", r"^\s*nCells: (\d+)")


FACTS = {"case, level": case, "state": state, "prepared": begun, "ranks": ranks, "spheres": spheres,
         "fluid cells": fluid_cells, "coarse grid": coarse_grid, "Frazil": frazil, "LIGGGHTS": liggghts,
         "OpenFOAM": openfoam}
