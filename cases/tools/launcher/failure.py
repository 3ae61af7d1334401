"""Which program failed, and what it said."""
from __future__ import annotations

import re
from pathlib import Path

from .run import EXITS, Run
from .say import tail


def fault(text: str, exits: str, np_dem: int) -> tuple[str, str]:
    """(program, what happened), from the programs' own last words, Open MPI's of an abort, or how the first one ended."""
    own = re.search(r"^(frazilDem|frazilFoam) failed", text, re.MULTILINE)
    if own:
        return own.group(1), "failed"
    abort = re.search(r"MPI_ABORT was invoked on rank (\d+).*?errorcode (-?\d+)", text, re.DOTALL)
    if abort:
        program = "frazilDem" if int(abort.group(1)) < np_dem else "frazilFoam"
        return program, f"stopped with an error (code {abort.group(2)})"
    if not exits:
        return "mpirun", "failed"
    program, code = exits.split()[:2]
    return program, f"was killed (signal {int(code) - 128})" if int(code) > 128 else f"ended with exit code {code}"


def error_lines(path: Path) -> list[str]:
    """The last error in a log with what follows it; LIGGGHTS appends a line of stray bytes to some."""
    lines = [line for line in tail(path, 200) if "\ufffd" not in line]
    marks = [index for index, line in enumerate(lines) if re.search(r"ERROR|FATAL|[Ee]rror:", line)]
    return lines[marks[-1]:][:15] if marks else []


def failure_text(run: Run) -> str:
    """Names the side that failed, and shows what it said."""
    noise = re.compile(r"^-{20,}$|^mpirun |mpirun (detected|noticed)|Primary job|Per user-direction|MPI_ABORT|^NOTE:|"
                       r"You may or may not|exactly when|^with errorcode|^ +(Process name|Exit code):|"
                       r"to be terminated\. The first|^\[[^]]*\] .*(help mess|MCA par|ORTE_)|"
                       r"^frazil(Dem|Foam) ends .* because|^(Killed|Terminated|Aborted)$")
    errors = (run.folder / "log.mpirun").read_text(errors="replace")
    exits = run.folder / EXITS
    side, what = fault(errors, exits.read_text() if exits.exists() else "", run.np_dem)
    log = run.folder / ("log.dem" if side == "frazilDem" else "log.foam")
    said = [line for line in errors.splitlines() if line.strip() and not noise.search(line)][:25] + error_lines(log)
    lines = list(dict.fromkeys(said))
    logs = "log.dem, log.foam and log.mpirun" if run.np_foam else "log.dem and log.mpirun"
    return "\n".join([*lines, f"{run.title}: {side} {what}. Logs: {logs} in {run.folder}"])
