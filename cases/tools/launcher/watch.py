"""Starts the programs of a run, shows how far they are, and ends them in order on Ctrl-C."""
from __future__ import annotations

import os
import re
import signal
import subprocess
import time
from pathlib import Path

from .environment import environment
from .failure import failure_text
from .run import EXITS, mpirun_command, Run
from .say import clock, Failure, last_line, Line
from .table import History, speed


def end_time(run: Run) -> float:
    """endTime of the fluid [s]; 0 if there is none."""
    if not run.np_foam:
        return 0.0
    control = (run.folder / "foam/system/controlDict").read_text()
    found = re.search(r"^\s*endTime\s+([\d.eE+-]+);", control, re.MULTILINE)
    return float(found.group(1)) if found else 0.0


def progress_text(row: dict[str, float], end: float, seconds: float) -> str:
    """The line a user looks at while the pair runs."""
    if not row:
        return f"running {clock(seconds)}"
    share = min(1.0, row["time"] / end) if end else 0.0
    words = [f"t {row['time']:.4f} of {end:g} s", f"{100 * share:3.0f} %"]
    if share > 0.01:
        words.append(f"ETA {clock(seconds * (1 - share) / share)}")
    if speed(row) is not None:
        words.append(f"body {speed(row):.2f} m/s")
    if "broken_tension" in row:
        words.append(f"bonds broken {row['broken_tension'] + row['broken_shear']:.0f}")
    if "dem_waited" in row and row.get("wall"):
        shares = [100 * row[key] / row["wall"] for key in ("dem_waited", "foam_waited")]
        words.append(f"waited: dem {shares[0]:.0f} % foam {shares[1]:.0f} %")
    return "  ".join(words)


def pids_of(name: str, session: int) -> list[int]:
    """Processes of that name in the session that mpirun leads (its ranks on this machine)."""
    result = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            head, _, rest = stat.read_text().rpartition(")")
        except OSError:
            continue
        if head.partition("(")[2] == name and int(rest.split()[3]) == session:
            result.append(int(stat.parent.name))
    return result


def stop(process: subprocess.Popen) -> None:
    """Ends both programs: frazilDem quits at the end of its step and tells its partner; mpirun is the last resort."""
    print("\nstopping: both programs write their output and end (Ctrl-C again: at once)", flush=True)
    try:
        for pid in pids_of("frazilDem", process.pid):
            os.kill(pid, signal.SIGTERM)
        process.wait(timeout=30)
    except (KeyboardInterrupt, subprocess.TimeoutExpired):
        process.terminate()
        process.wait()


def start_programs(run: Run) -> subprocess.Popen:
    """Starts the pair, or frazilDem alone, in a session of its own, so that Ctrl-C reaches only the launcher, which ends it in order."""
    (run.folder / EXITS).unlink(missing_ok=True)
    with (run.folder / "log.mpirun").open("ab") as errors, \
            (run.folder / ("log.foam" if run.np_foam else "log.mpirun")).open("ab") as out:
        return subprocess.Popen(mpirun_command(run), cwd=run.folder, env=environment(), stdin=subprocess.DEVNULL,
                                stdout=out, stderr=errors, start_new_session=True)


def watch(run: Run, process: subprocess.Popen) -> float:
    """Shows how far the pair is, to its end. Returns the wall time [s]."""
    history, end, line, start = History(run.folder / "history.csv"), end_time(run), Line(10.0), time.monotonic()
    try:
        while process.poll() is None:
            said = "" if run.np_foam else f"  {last_line(run.folder / 'log.dem')}"
            line.show(progress_text(history.read(), end, time.monotonic() - start) + said)
            time.sleep(0.5)
    except KeyboardInterrupt:
        stop(process)
        raise
    seconds = time.monotonic() - start
    line.end(progress_text(history.read(), end, seconds))
    if process.returncode:
        raise Failure(failure_text(run))
    return seconds
