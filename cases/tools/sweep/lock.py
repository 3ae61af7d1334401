"""Only one sweep of a study at a time."""
from __future__ import annotations

import contextlib
import fcntl
import socket
from pathlib import Path
from typing import Iterator, TextIO

from launcher.say import Failure


@contextlib.contextmanager
def held(folder: Path) -> Iterator[TextIO]:
    """The study's lock file. Snakemake inherits and so holds it, too: it is free as soon as both are gone, however they
    ended, and no stale lock is ever left."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("a+") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            file.seek(0)
            raise Failure(f"{folder}: a sweep of this study is going on. Let it end, or end it with Ctrl-C where it was "
                          f"started, or {file.read().strip() or 'by its processes'}.") from None
        file.truncate(0)
        yield file


def say_how_to_end(lock: TextIO, pid: int) -> None:
    """What a second sweep is told: how to end Snakemake, should it have outlived the first one."""
    lock.write(f"on {socket.gethostname()} with `kill -INT -- -{pid}`\n")
    lock.flush()
