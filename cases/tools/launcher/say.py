"""What the launcher says: one line that tells how far a command is, the ends of logs, errors with a cure."""
from __future__ import annotations

import difflib
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Callable


class Failure(Exception):
    """Something the user must know; main prints it and exits with status 1."""


def clock(seconds: float) -> str:
    """Seconds as m:ss."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


class Line:
    """One line that is rewritten on a terminal, and printed every `period` seconds elsewhere (in a CI's log)."""

    def __init__(self, period: float = 15.0) -> None:
        self.tty, self.period, self.last = sys.stdout.isatty(), period, time.monotonic()

    def show(self, text: str) -> None:
        """Shows a state that the next one replaces."""
        if self.tty:
            print("\r\033[K" + text[: shutil.get_terminal_size().columns - 1], end="", flush=True)
        elif time.monotonic() - self.last >= self.period:
            self.last = time.monotonic()
            print(text, flush=True)

    def end(self, text: str = "") -> None:
        """Ends the line, with a last text that stays."""
        print(("\r\033[K" if self.tty else "") + text, end="\n" if text else "", flush=True)


def tail(path: Path, count: int) -> list[str]:
    """Last non-empty lines of a text file (of its last 64 kB)."""
    if not path.is_file():
        return []
    with path.open("rb") as stream:
        stream.seek(max(0, path.stat().st_size - 65536))
        text = stream.read().decode(errors="replace")
    return [line.rstrip() for line in text.splitlines() if line.strip()][-count:]


def last_line(path: Path) -> str:
    """Last non-empty line of a log that is being written."""
    lines = tail(path, 1)
    return lines[0][:70] if lines else ""


def logged(label: str, command: list[str], log: Path, progress: Callable[[], str] | None = None,
           check: bool = True, **options) -> int:
    """Runs a command into a log while one line shows how far it is. A failure shows the log's end."""
    log.parent.mkdir(parents=True, exist_ok=True)
    start, line = time.monotonic(), Line()
    with log.open("ab") as stream:
        stream.write(f"\n$ {shlex.join(map(str, command))}\n".encode())
        stream.flush()
        process = subprocess.Popen(command, stdout=stream, stderr=stream, stdin=subprocess.DEVNULL, **options)
        while True:
            try:
                status = process.wait(timeout=0.5)
                break
            except subprocess.TimeoutExpired:
                line.show(f"{label} {clock(time.monotonic() - start)}  {progress() if progress else last_line(log)}")
    seconds = time.monotonic() - start
    if status and check:
        line.end(f"{label} failed after {clock(seconds)}")
        raise Failure("\n".join(tail(log, 25)) + f"\n{label} failed (status {status}); the whole output is in {log}")
    line.end(f"{label} done in {clock(seconds)}" if seconds > 2 else "")
    return status


def output_of(command: list[str]) -> str:
    """What a quick command prints; empty if it fails or is not there."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return ""


def did_you_mean(word: str, known: list[str]) -> str:
    """Ends an error about an unknown word."""
    close = difflib.get_close_matches(word, known, 1)
    return (f" Did you mean {close[0]}?" if close else "") + f" Known: {', '.join(sorted(known))}."
