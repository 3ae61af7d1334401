"""What a sweep asks of each run: the diagnostics' numbers, and a few that only a study needs.

To add one: a function of a run under `@metric(label, unit)`, here, or under `@value(label, unit)` in cases/tools/diagnostics,
which the report shows, too. Where a run has no such thing the function raises Missing and the table stays blank.
"""
from __future__ import annotations

import sys
from pathlib import Path
from typing import Callable

import numpy

from diagnostics import Missing, Run, VALUES
from diagnostics.body import depth, speed
from diagnostics.catalogue import Diagnostic, lister

OWN: dict[str, Diagnostic] = {}
DEFAULT = ("peak_contact_force", "peak_contact_delay", "peak_fluid_force", "end_speed", "end_depth", "end_loss",
           "end_broken_tension", "end_broken_shear", "end_pieces", "young", "first_failure", "strength")


def metric(label: str, unit: str) -> Callable:
    """Lists a function of a run that returns one number."""
    return lister(OWN, label, unit)


def specimen(run: Run, column: str) -> float:
    """A number of strength.csv, which the cases with a specimen of ice leave, where it holds one stiffness ratio."""
    values = run.table("strength.csv")[column]
    if len(values) != 1:
        raise Missing(f"{run.folder / 'strength.csv'}: has {len(values)} stiffness ratios; give the point one.")
    return float(values[0])


@metric("modulus of the ice", "Pa")
def young(run: Run) -> float:
    """Slope of the stress-strain curve [Pa]."""
    return specimen(run, "E")


@metric("stress at the first failure", "Pa")
def first_failure(run: Run) -> float:
    """Of the specimen, before the first bond breaks [Pa]."""
    return specimen(run, "first_failure")


@metric("strength of the ice", "Pa")
def strength(run: Run) -> float:
    """Largest stress of the specimen [Pa]."""
    return specimen(run, "strength")


def speed_at(level: float) -> Diagnostic:
    """Speed of the body when its lowest point first reaches a depth [m]: |v| between the two rows, in proportion."""
    def function(run: Run) -> float:
        depths, speeds = depth(run).values, speed(run).values
        below = numpy.flatnonzero(depths >= level)
        if not below.size or below[0] == 0:
            raise Missing(f"{run.folder / 'history.csv'}: the body does not pass the depth of {level:g} m.")
        n = below[0]
        share = (level - depths[n - 1]) / (depths[n] - depths[n - 1])
        return float(speeds[n - 1] + share * (speeds[n] - speeds[n - 1]))
    return Diagnostic(f"speed_at_{level:g}_m", f"speed at {1e3 * level:g} mm depth", "m/s", function)


def known() -> dict[str, Diagnostic]:
    """All metrics by name, without the speeds at depths."""
    return {**VALUES, **OWN}


def chosen(names: list[str], depths: list[float]) -> list[Diagnostic]:
    """The metrics of a study: those it names, or else the usual ones; then the speeds at its depths."""
    every = known()
    return [every[name] for name in names or DEFAULT] + [speed_at(level) for level in depths]


def measure(folder: Path, metrics: list[Diagnostic]) -> dict[str, float]:
    """Metrics of a run, without those that it does not have. A metric that fails costs its own value only: the run may have
    taken hours."""
    if not folder.is_dir():  # removed for the space it took
        return {}
    run, found = Run(folder), {}
    for one in metrics:
        try:
            found[one.name] = one(run)
        except Missing:
            continue
        except (ArithmeticError, LookupError, TypeError, ValueError) as error:
            print(f"frazil: metric {one.name} of {folder.name}: {type(error).__name__}: {error}", file=sys.stderr)
    return found
