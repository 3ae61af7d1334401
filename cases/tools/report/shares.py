"""Where the wall time went: a bar for each program of each run."""
from __future__ import annotations

from matplotlib import pyplot

from diagnostics import Missing, Run
from diagnostics.wall_time import dem_phases, foam_phases

from .figure import embed, PALETTE, Picture

WAITING = "#d7dbdf"  # of time in which a program does nothing


def draw(run: Run) -> Picture:
    """Phases of both programs in seconds of wall time, as they say at the end of their logs."""
    bars = {}
    for program, phases in (("frazilDem", dem_phases), ("frazilFoam", foam_phases)):
        try:
            bars[program] = phases(run)
        except Missing as missing:
            reason = missing
    if not bars:
        raise reason
    figure, axes = pyplot.subplots(len(bars), 1, figsize=(5.0, 1.55 * len(bars)), sharex=True, squeeze=False)
    for axis, (program, phases) in zip(axes[:, 0], bars.items()):
        bar(axis, program, phases)
    axes[-1, 0].set_xlabel("wall time [s]")
    return embed(figure, f"{run.name}: what the wall time was spent on")


def bar(axis, program: str, phases: dict[str, float]) -> None:
    """One program: its phases one after the other, named where they take a visible part."""
    left, whole = 0.0, sum(phases.values())
    working = (colour for colour in PALETTE)
    for name, seconds in phases.items():
        if seconds < 0.005 * whole:
            continue
        colour = WAITING if name.startswith("waiting") else next(working)
        axis.barh(0, seconds, left=left, color=colour, label=f"{name} {100 * seconds / whole:.0f} %")
        left += seconds
    axis.set(yticks=[], xlim=(0, None))
    axis.set_title(program, loc="left")
    axis.legend(loc="center left", bbox_to_anchor=(1, 0.5), fontsize=7.5, handlelength=1)
