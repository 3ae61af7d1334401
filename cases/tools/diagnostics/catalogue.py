"""What a run can be asked: each diagnostic is one function of a Run, listed here with its unit.

    @series("loss of the ice, 1 - η", "")          a Series over time, in SERIES under the function's name
    def loss(run): ...

    @value("largest contact force", "N")           one number, in VALUES
    def peak_contact_force(run): ...

A function whose input the run does not have raises Missing, in words; it never returns a made-up number.
"""
from __future__ import annotations

import inspect
from dataclasses import dataclass
from typing import Callable

import numpy

from launcher.say import Failure


class Missing(Failure):
    """The run does not have what a diagnostic needs: file, problem, cure. The launcher prints it as any other failure."""


@dataclass(frozen=True)
class Series:
    """Values over the run's time [s]."""

    time: numpy.ndarray
    values: numpy.ndarray

    def last(self) -> float:
        """The newest value."""
        return float(self.values[-1])

    def peak(self) -> float:
        """The largest value."""
        return float(numpy.max(self.values))

    def time_of_peak(self) -> float:
        """When the largest value is reached first [s]."""
        return float(self.time[numpy.argmax(self.values)])

    def integral(self) -> float:
        """∫ values dt by the trapezoidal rule [unit s]."""
        return float(numpy.sum(0.5 * (self.values[1:] + self.values[:-1]) * numpy.diff(self.time)))

    def first_above(self, limit: float = 0.0) -> float | None:
        """First time with a value above the limit [s]; None if there is none."""
        above = numpy.flatnonzero(self.values > limit)
        return float(self.time[above[0]]) if above.size else None


@dataclass(frozen=True)
class Diagnostic:
    """A function with what tables and axes say of it. The unit is empty for plain numbers."""

    name: str
    label: str
    unit: str
    function: Callable

    @property
    def title(self) -> str:
        """Label and unit, for axes and tables."""
        return f"{self.label} [{self.unit}]" if self.unit else self.label

    @property
    def definition(self) -> str:
        """Formula and source, as the function says them, in one line."""
        return " ".join(inspect.getdoc(self.function).split())

    def __call__(self, run):
        return self.function(run)


SERIES: dict[str, Diagnostic] = {}
VALUES: dict[str, Diagnostic] = {}


def series(label: str, unit: str) -> Callable:
    """Lists a function that returns a Series."""
    return lister(SERIES, label, unit)


def value(label: str, unit: str) -> Callable:
    """Lists a function that returns one number."""
    return lister(VALUES, label, unit)


def lister(catalogue: dict[str, Diagnostic], label: str, unit: str) -> Callable:
    """The decorator that enters a function, unchanged, under its own name."""
    def enter(function: Callable) -> Callable:
        catalogue[function.__name__] = Diagnostic(function.__name__, label, unit, function)
        return function
    return enter
