"""One point of a study, as Snakemake starts it: runs it as `frazil run` does, and writes how it ended. A failure is a result,
too, so it ends with exit status 0; only an interrupted point leaves no point.json, and goes on when the sweep does."""
from __future__ import annotations

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from launcher.cli import carry_out
from launcher.resume import resume
from launcher.run import plan, Run
from launcher.say import Failure

from .study_folder import DONE, FAILED, StudyFolder, write_whole

EARLIER = "earlier_seconds"  # in the run folder: wall time of the attempts before this one [s]


def others_in(folder: Path) -> list[int]:
    """Other processes of this machine that work in a folder."""
    found = []
    for link in Path("/proc").glob("[0-9]*/cwd"):
        try:
            if Path(os.readlink(link)) == folder and link.parent.name != str(os.getpid()):
                found.append(int(link.parent.name))
        except OSError:
            continue
    return found


def end_others(folder: Path, patience: float = 60.0) -> None:
    """Ends what a killed sweep has left running in the point's folder: two pairs must not write the same files."""
    for number in (signal.SIGTERM, signal.SIGKILL):
        start = time.monotonic()
        for pid in others_in(folder):
            print(f"ending process {pid}, which an interrupted sweep left in {folder}", flush=True)
            os.kill(pid, number)
        while others_in(folder) and time.monotonic() - start < patience:
            time.sleep(0.2)


def planned(about: dict, folder: Path, settings: dict) -> Run:
    """The point as a new run."""
    words = [f"{name}={json.dumps(value)}" for name, value in settings.items()]
    return plan(argparse.Namespace(case=about["case"], level=about["level"], out=str(folder), set=words,
                                   np_dem=about["np"].get("dem"), np_foam=about["np"].get("foam")))


def resumed(about: dict, folder: Path) -> Run:
    """The point as a run that goes on from its last state; its time so far is kept."""
    history, begin = folder / "history.csv", folder / (EARLIER if (folder / EARLIER).is_file() else "run.json")
    spent = history.stat().st_mtime - begin.stat().st_mtime if history.is_file() else 0.0
    run = resume(argparse.Namespace(case=about["case"], level=None, out=str(folder), set=[], np_dem=None, np_foam=None))
    (folder / EARLIER).write_text(f"{earlier_seconds(folder) + spent:.1f}")
    return run


def earlier_seconds(folder: Path) -> float:
    """Wall time of the attempts before this one [s]."""
    path = folder / EARLIER
    return float(path.read_text()) if path.is_file() else 0.0


def run_of(about: dict, folder: Path, settings: dict) -> tuple[Run, bool]:
    """(the point, whether it is new): goes on with an interrupted one, or begins anew where that cannot be continued."""
    if (folder / "run.json").is_file():
        try:
            return resumed(about, folder), False
        except Failure as why:
            print(f"{why}\nbegun anew", flush=True)
    for path in folder.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    return planned(about, folder, settings), True


def attempt(about: dict, folder: Path, settings: dict) -> dict:
    """Runs the point; how it ended."""
    start = time.monotonic()
    try:
        run, fresh = run_of(about, folder, settings)
        check = "passed" if carry_out(run, fresh) == 0 else "not passed"
        state = {"status": DONE, "check": check}
    except (Failure, OSError, subprocess.CalledProcessError) as failure:
        print(failure, flush=True)
        state = {"status": FAILED, "why": str(failure)}
    return {**state, "wall_seconds": round(time.monotonic() - start + earlier_seconds(folder), 1)}


def main() -> int:
    """The words of the command line: study folder and point."""
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)
    study, name = StudyFolder(Path(sys.argv[1]).resolve()), sys.argv[2]
    about = json.loads((study.path / "points.json").read_text())
    folder = study.run(name)
    if study.status(name).is_file():  # it ended, but Snakemake was stopped before it knew
        return 0
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(folder)  # others_in finds this process by it
    # Open MPI binds the ranks of every small run to the first cores, which runs side by side would then share.
    os.environ.setdefault("OMPI_MCA_hwloc_base_binding_policy", "none")
    print(f"{time.strftime('%Y-%m-%d %H:%M:%S')} {name}", flush=True)
    try:
        end_others(folder)
        state = attempt(about, folder, about["points"][name])
    except KeyboardInterrupt:
        print("interrupted", flush=True)
        return 130
    write_whole(study.status(name), json.dumps(state, indent=2) + "\n")
    return 0
