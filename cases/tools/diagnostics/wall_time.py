"""Where the wall time went: from history.csv, and from what both programs say at the end of their logs."""
from __future__ import annotations

import re

from .catalogue import Missing, series, Series, value
from .run import Run


@series("wall time", "s")
def wall_time(run: Run) -> Series:
    """Since the handshake [s]."""
    return run.column("wall")


@value("wall time", "s")
def end_wall_time(run: Run) -> float:
    """Since the handshake, at the last exchange [s]."""
    return wall_time(run).last()


@value("share of the wall time that frazilDem waited", "")
def dem_waiting_share(run: Run) -> float:
    """dem_waited/wall at the last exchange [-]."""
    return run.column("dem_waited").last() / end_wall_time(run)


@value("share of the wall time that frazilFoam waited", "")
def foam_waiting_share(run: Run) -> float:
    """foam_waited/wall at the last exchange [-]."""
    return run.column("foam_waited").last() / end_wall_time(run)


@value("fluid steps", "")
def fluid_steps(run: Run) -> float:
    """Rows of history.csv but the last, which begins a step [-]."""
    return float(len(run.history["time"]) - 1)


@value("mean fluid step", "s")
def mean_fluid_step(run: Run) -> float:
    """Simulated time over fluid steps [s]."""
    time = run.history["time"]
    if len(time) < 2:
        raise Missing(f"{run.folder / 'history.csv'}: has no whole fluid step yet.")
    return float(time[-1] - time[0]) / fluid_steps(run)


def dem_phases(run: Run) -> dict[str, float]:
    """frazilDem's own account [s], longest of all its ranks: the line FRAZIL_TIMERS of log.dem; the rest is LIGGGHTS."""
    found = re.search(r"^FRAZIL_TIMERS side=dem (.*)$", run.log("log.dem"), re.MULTILINE)
    if not found:
        raise Missing(f"{run.folder / 'log.dem'}: has no FRAZIL_TIMERS yet; frazilDem writes it at its end.")
    seconds = {name: float(word) for name, word in (pair.split("=") for pair in found.group(1).split())}
    named = {"waiting for frazilFoam": seconds["waiting"], "exchange": seconds["exchange"], "fluid force": seconds["force"]}
    return {"particles, contacts, bonds": seconds["wall"] - sum(named.values()), **named}


def foam_phases(run: Run) -> dict[str, float]:
    """frazilFoam's own account [s], of its first rank: the table at the end of log.foam; the rest is the fluid's equations."""
    _, _, table = run.log("log.foam").rpartition("Coupling, wall time on the first fluid rank")
    rows = re.findall(r"^    (\S.*?) ([\d.e+-]+) ([\d.e+-]+)$", table, re.MULTILINE)
    if not rows:
        raise Missing(f"{run.folder / 'log.foam'}: has no table of wall time yet; frazilFoam writes it at its end.")
    named = {name: float(seconds) for name, seconds, _ in rows}
    share = sum(float(percent) for _, _, percent in rows) / 100
    whole = sum(named.values()) / share if share > 0 else 0.0
    return {"flow equations": whole - sum(named.values()), **named}
