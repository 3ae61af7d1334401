"""How long a sweep will take, from points that have been run."""
from __future__ import annotations

import argparse
import json
import os

from launcher import places
from launcher.say import clock

from .study import Study
from .study_folder import DONE, FAILED, StudyFolder


def side_by_side(ranks: int, arguments: argparse.Namespace) -> int:
    """Points at the same time: as many as the cores hold, or as --jobs says on a cluster."""
    if arguments.slurm or arguments.profile:
        return arguments.jobs
    return max(1, (arguments.cores or os.cpu_count() or 1) // ranks)


def measured_seconds(study: Study, folder: StudyFolder, points: dict[str, dict]) -> tuple[float, str] | None:
    """(wall time of a point [s], where it is from): the mean of the study's own, or else the newest run of case and level."""
    own = [state["wall_seconds"] for state in map(folder.state, points) if state["status"] == DONE]
    if own:
        return sum(own) / len(own), f"mean of {len(own)} done"
    for path in sorted((places.TOP / "runs").glob("*/metrics.json"), key=lambda path: -path.stat().st_mtime):
        seconds = seconds_of(study, json.loads(path.read_text()))
        if seconds:
            return seconds, f"{path.parent.name}, in proportion of end_time"
    return None


def seconds_of(study: Study, metrics: dict) -> float | None:
    """What a point takes by a run of the same case and level."""
    if (metrics["case"], metrics["level"]) != (study.case.name, study.level):
        return None
    ends = [params.get("end_time", 1.0) for params in (study.defaults, metrics["params"])]
    return metrics["wall_seconds"] * ends[0] / ends[1]


def remaining(study: Study, folder: StudyFolder, points: dict[str, dict], lanes: int) -> str:
    """The estimate in words."""
    left = sum(folder.state(name)["status"] not in (DONE, FAILED) for name in points)
    if not left:
        return "nothing is left to run"
    measured = measured_seconds(study, folder, points)
    if not measured:
        return f"{left} points to run, {lanes} at the same time; no time is known before the first one has ended"
    seconds, source = measured
    total = clock(seconds * -(-left // lanes))
    return f"{left} points to run, {lanes} at the same time, {clock(seconds)} each ({source}): about {total}"
