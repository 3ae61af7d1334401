"""The files of a study folder.

    points.json              the points by name, and how each is run
    points/NAME/             run folder of a point, as of `frazil run`, and point.json: how it ended
    ended/NAME               Snakemake's output file, empty: it deletes that of a point which it sees interrupted
    log/NAME.txt             what the launcher said, one attempt after the other
    snakemake.log            what Snakemake said
    results.csv, results.h5, plots/, index.html
"""
from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

DONE, FAILED, UNFINISHED, WAITING = "done", "failed", "unfinished", "waiting"


class StudyFolder:
    """Paths of a study folder, and the states of its points."""

    def __init__(self, path: Path) -> None:
        self.path, self.ended = path, {}

    def run(self, name: str) -> Path:
        """Run folder of a point."""
        return self.path / "points" / name

    def status(self, name: str) -> Path:
        """How a point ended."""
        return self.run(name) / "point.json"

    def mark(self, name: str) -> Path:
        """Snakemake's output file."""
        return self.path / "ended" / name

    def log(self, name: str) -> Path:
        """What was said while a point ran."""
        return self.path / "log" / f"{name}.txt"

    def forget(self, name: str) -> None:
        """Makes a point one that is still to be run; its log stays."""
        shutil.rmtree(self.run(name), ignore_errors=True)
        self.mark(name).unlink(missing_ok=True)
        self.ended.pop(name, None)

    def state(self, name: str) -> dict:
        """status (done, failed, unfinished, waiting); of an ended point also why, check, wall_seconds."""
        if name not in self.ended and self.status(name).is_file():
            self.ended[name] = json.loads(self.status(name).read_text())
        if name in self.ended:
            return self.ended[name]
        return {"status": UNFINISHED if (self.run(name) / "run.json").is_file() else WAITING}


def write_whole(path: Path, text: str) -> None:
    """A file that appears at once or not at all, whenever this process is killed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    partial.write_text(text)
    partial.replace(path)
