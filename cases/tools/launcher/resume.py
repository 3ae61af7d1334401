"""`frazil run --resume`: sets an interrupted run folder back to the newest state that both programs have written."""
from __future__ import annotations

import argparse
import json
import re
from pathlib import Path

from . import places
from .case import find_case
from .run import free_folder, Run
from .say import Failure
from .table import read_columns


def interrupted_run(arguments: argparse.Namespace) -> Run:
    """The run to continue: that of --out, or else the newest of the case."""
    case = find_case(arguments.case)
    runs = [path.parent for path in (places.TOP / "runs").glob("*/run.json")
            if json.loads(path.read_text())["case"] == str(case)]
    newest = max(runs, key=lambda path: path.stat().st_mtime, default=places.TOP / "runs")
    folder = Path(arguments.out).resolve() if arguments.out else newest
    if not (folder / "run.json").is_file():
        raise Failure(f"--resume: no run of {case.name} in {folder}.")
    old = json.loads((folder / "run.json").read_text())
    params = json.loads((folder / "params.json").read_text())
    if arguments.set or arguments.level or arguments.np_dem or arguments.np_foam:
        raise Failure("--resume continues a run as it was: without --set, --level, --np-dem and --np-foam.")
    return Run(case, old["level"], params, old["np_dem"], old["np_foam"], folder)


def fluid_times(run: Run) -> list[str]:
    """Names of the times that every fluid rank has written."""
    places = [run.folder / "foam" / (f"processor{n}" if run.np_foam > 1 else "") for n in range(run.np_foam)]
    names = [{path.parent.name for path in place.glob("[0-9]*/U*")} for place in places]
    return sorted(set.intersection(*names), key=float)


def restart_point(run: Run, history: dict[str, list[float]]) -> tuple[str, str, float]:
    """(restart file, fluid's time folder, time) of the newest state that both programs have written.

    A restart file is named by its DEM step; the history counts them: each row orders the steps of one fluid step."""
    files, names = {path.name for path in (run.folder / "dem").glob("restart.*")}, fluid_times(run)
    step, found = 0, None
    for moment, substeps in zip(history.get("time", []), history.get("substeps", [])):
        same = [name for name in names if abs(float(name) - moment) < 1e-6 * moment]
        if same and f"restart.{step}" in files:
            found = f"dem/restart.{step}", same[0], moment
        step += int(substeps)
    if not found:
        raise Failure(f"--resume: {run.folder} holds no state that both programs have written; start the case anew.")
    return found


def forget_after(path: Path, moment: float, inclusive: bool = False) -> None:
    """Drops the rows of a CSV file after that time, or from that time on: the continued run writes them again."""
    limit = moment * (1 - 1e-9 if inclusive else 1 + 1e-9)
    rows = path.read_text().splitlines(keepends=True)
    path.write_text("".join(rows[:1] + [row for row in rows[1:] if float(row.split(",")[0]) <= limit]))


def resume(arguments: argparse.Namespace) -> Run:
    """Sets an interrupted run folder back to its last common state."""
    run = interrupted_run(arguments)
    start = run.folder / "dem/start"
    if not start.is_file():
        raise Failure(f"--resume: {run.case.name} cannot be continued: it has no dem/start to create particles.")
    file, name, moment = restart_point(run, read_columns(run.folder / "history.csv"))
    start.write_text(f"read_restart {file}\n")
    for table in ("history.csv", "ledger.csv"):  # the exchange at that time is repeated, the DEM step before it is not
        forget_after(run.folder / table, moment, inclusive=True)
    for table in (run.folder / "dem").glob("*.csv"):
        forget_after(table, moment)
    control = run.folder / "foam/system/controlDict"
    text = re.sub(r"^startFrom\s.*$", "startFrom startTime;", control.read_text(), flags=re.MULTILINE)
    control.write_text(re.sub(r"^startTime\s.*$", f"startTime {name};", text, flags=re.MULTILINE))
    for log in ("log.dem", "log.foam", "log.mpirun"):
        if (run.folder / log).is_file():
            (run.folder / log).rename(free_folder(run.folder / log))
    print(f"{run.title}: goes on from {name} s")
    return run
