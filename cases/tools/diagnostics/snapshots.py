"""Snapshots over time in particles.h5 and coarse.h5 (dualgrid/record/SnapshotFile), also while they are being written."""
from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Callable

import numpy

from .catalogue import Missing

ATTEMPTS, PAUSE = 5, 0.2  # of reading a file [-], [s]: the writer holds it for as long as one snapshot takes

# A reader's lock would make the writer fail and end a run that is going on.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")


class Snapshots:
    """One series of a file: `particles` and `bonds` of particles.h5, `coarse` of coarse.h5."""

    def __init__(self, path: Path, series: str, writer: str) -> None:
        self.path, self.series, self.writer = path, series, writer
        whole = self.look(self.whole_groups)
        if not whole:
            raise Missing(f"{path}: holds no whole snapshot of {series}; wait for the first one of a run that has just begun.")
        self.steps = sorted(whole)
        self.times = numpy.array([whole[step] for step in self.steps])

    def look(self, read: Callable):
        """What `read` makes of the file; again where the writer is at work."""
        if not self.path.is_file():
            raise Missing(f"{self.path}: does not exist; {self.writer} writes it, from its first snapshot on.")
        try:
            import h5py
        except ImportError:
            raise Missing(f"{self.path}: cannot be read without h5py; install python3-h5py.") from None
        for attempt in range(ATTEMPTS):
            try:
                with h5py.File(self.path, "r") as file:
                    return read(file)
            except (OSError, RuntimeError) as error:
                problem = error
                time.sleep(PAUSE)
        raise Missing(f"{self.path}: cannot be read ({problem}); it was cut off when the run was killed, or is being written: "
                      "try again.")

    def whole_groups(self, file) -> dict[str, float]:
        """Time [s] of each snapshot. The writer adds the attribute xdmf last: a group without it was cut off."""
        groups = file[self.series] if self.series in file else {}
        return {step: float(group.attrs["time"]) for step, group in groups.items() if "xdmf" in group.attrs}

    def nearest(self, moment: float, within: float = numpy.inf) -> int:
        """Number of the snapshot nearest to a time [s], at most `within` [s] away."""
        n = int(numpy.argmin(numpy.abs(self.times - moment)))
        if abs(self.times[n] - moment) > within:
            raise Missing(f"{self.path}: has no snapshot within {within:.2g} s of {moment:g} s.")
        return n

    def read(self, n: int, *names: str) -> tuple[numpy.ndarray, ...]:
        """Arrays of snapshot n in SI units; those of particles in the order of their ids, whatever the number of ranks."""
        def arrays(file) -> tuple[numpy.ndarray, ...]:
            group = file[self.series][self.steps[n]]
            for name in names:
                if name not in group:
                    raise Missing(f"{self.path}: has no `{name}`; see the keywords of fix results.")
            order = numpy.argsort(group["id"][:]) if "id" in group else slice(None)
            return tuple(group[name][:][order] for name in names)
        return self.look(arrays)

    def xdmf(self, n: int) -> str:
        """What ParaView is told of snapshot n; it has the coarse grid's place."""
        text = self.look(lambda file: file[self.series][self.steps[n]].attrs["xdmf"])
        return text.decode() if isinstance(text, bytes) else str(text)
