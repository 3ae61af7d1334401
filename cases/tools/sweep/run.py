"""`frazil sweep`: the points of a study file, from what is left of them to table, figures and page."""
from __future__ import annotations

import argparse
import json
import re
import subprocess
import time
from pathlib import Path

from launcher import places
from launcher.build import setup
from launcher.case import read
from launcher.packages import need
from launcher.say import clock, Failure, Line, tail

from . import jobs
from .estimate import remaining, side_by_side
from .lock import held
from .needs import need_snakemake
from .page import write_results
from .points import points as points_of
from .reader import read_study
from .study import SAMPLES, Study
from .study_folder import DONE, FAILED, StudyFolder, write_whole
from .table import Measured

DRAWING_SHARE = 0.05  # at most of the time that goes into figures while points run


def sweep(arguments: argparse.Namespace) -> int:
    """Runs what is left of a study; 1 where a point is not done at the end."""
    study = read_study(Path(arguments.study))
    if study.combine in SAMPLES:
        need("scipy")
    points = points_of(study)
    folder = StudyFolder(Path(arguments.out or places.TOP / "runs" / f"{study.case.name}-{study.path.stem}").resolve())
    ranks = ranks_of(study)
    lanes = side_by_side(ranks, arguments)
    if arguments.dry_run:
        say_points(study, folder, points, lanes)
        return 0
    need_snakemake()
    setup()
    with held(folder.path) as lock:
        check_same(study, folder, points)
        if arguments.retry_failed:
            forget_failed(folder, points)
        write_points(study, folder, points, ranks)
        print(f"{study.title}: {remaining(study, folder, points, lanes)}, in {folder.path}", flush=True)
        follow(study, folder, points, jobs.start(folder, arguments, lock))
    return summary(folder, points)


def ranks_of(study: Study) -> int:
    """Ranks of a point, both programs together."""
    case = read(study.case)
    np = {"dem": 1, "foam": 1, **case.get("np", {}), **study.np}
    return np["dem"] + (np["foam"] if case.get("pair", True) else 0)


def say_points(study: Study, folder: StudyFolder, points: dict[str, dict], lanes: int) -> None:
    """--dry-run: what would be run."""
    width = max(map(len, points))
    for name in points:
        print(f"  {name:<{width}}  {folder.state(name)['status']}")
    print(f"{len(points)} points in {folder.path}; {remaining(study, folder, points, lanes)}")


def check_same(study: Study, folder: StudyFolder, points: dict[str, dict]) -> None:
    """Refuses to mix points that were run with other fixed parameters: names hold only those that vary."""
    for name, settings in points.items():
        params = folder.run(name) / "params.json"
        if not params.is_file():
            continue
        old, new = json.loads(params.read_text()), {**study.defaults, **settings}
        differences = [f"{key} {json.dumps(old.get(key))} then, {json.dumps(new.get(key))} now"
                       for key in sorted(old.keys() | new.keys()) if old.get(key) != new.get(key)]
        if differences:
            raise Failure(f"{study.path}: {name} was run with other parameters: {'; '.join(differences)}. Name another folder "
                          f"with --out, or remove {folder.path}.")


def forget_failed(folder: StudyFolder, points: dict[str, dict]) -> None:
    """--retry-failed: failed points are to be run again, from their start."""
    for name in points:
        if folder.state(name)["status"] == FAILED:
            folder.forget(name)


def write_points(study: Study, folder: StudyFolder, points: dict[str, dict], ranks: int) -> None:
    """points.json, for the Snakefile and for the points; the study file as it was."""
    about = {"case": str(study.case), "level": study.level, "np": study.np, "ranks": ranks,
             "points": {name: {**study.set, **settings} for name, settings in points.items()}}
    write_whole(folder.path / "points.json", json.dumps(about, indent=2) + "\n")
    write_whole(folder.path / "study.yaml", study.path.read_text())
    (folder.path / "log").mkdir(exist_ok=True)  # Slurm opens a job's log before Snakemake can make its folder


def follow(study: Study, folder: StudyFolder, points: dict[str, dict], process: subprocess.Popen) -> None:
    """Shows how far Snakemake is and keeps table and page up to date. Ctrl-C ends the points in order; they go on next time."""
    line, start, measured, shown, pause = Line(), time.monotonic(), Measured(study, folder), None, 0.0
    try:
        while process.poll() is None:
            states = [folder.state(name)["status"] for name in points]
            done, failed = states.count(DONE), states.count(FAILED)
            line.show(f"{done} of {len(points)} points done, {failed} failed  {clock(time.monotonic() - start)}")
            if (done, failed) != shown and time.monotonic() > pause:
                shown, begin = (done, failed), time.monotonic()
                write_results(study, points, measured, going_on=True)
                pause = time.monotonic() + (time.monotonic() - begin) / DRAWING_SHARE
            time.sleep(0.5)
    except BaseException:
        print("\nstopping: points under way are ended in order and go on when the sweep is started again", flush=True)
        jobs.stop(process)
        raise
    finally:
        line.end()
        write_results(study, points, measured, going_on=False)


def summary(folder: StudyFolder, points: dict[str, dict]) -> int:
    """What became of the points; the exit status."""
    states = {name: folder.state(name) for name in points}
    for name, state in states.items():
        if state["status"] == FAILED:
            print("\n  ".join([f"failed: {name}", *state["why"].splitlines()[-3:], f"log: {folder.log(name)}"]))
    ends = [state["status"] for state in states.values()]
    done, failed = ends.count(DONE), ends.count(FAILED)
    print(f"{done} of {len(points)} points done" + (f", {failed} failed (--retry-failed runs them again)" if failed else ""))
    if done + failed < len(points):
        say_unfinished(folder, [name for name, state in states.items() if state["status"] not in (DONE, FAILED)])
    print(f"results: {folder.path / 'index.html'}, results.csv, results.h5")
    return 0 if done == len(points) else 1


def say_unfinished(folder: StudyFolder, names: list[str]) -> None:
    """Points that neither ended nor failed: killed, cancelled, or not started; Snakemake may know why."""
    noise = re.compile(r"Error (in|executing) rule|check log file")
    said = [line for line in tail(folder.path / "snakemake.log", 60) if re.search("[Ee]rror", line) and not noise.search(line)]
    print("\n".join(["not ended:", *(f"  {name}" for name in names), *said[-3:]]))
    print(f"Start the same command again to go on. Logs: {folder.path / 'log'}, {folder.path / 'snakemake.log'}")
