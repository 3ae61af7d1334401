"""Tables with one column per run: what was run, values of the diagnostics, parameters, the balance of momentum."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

from diagnostics import Missing, Run, VALUES
from diagnostics.catalogue import Diagnostic
from diagnostics.facts import FACTS
from diagnostics.momentum import balance
from folder import words

from .figure import labelled, readable

NONE = "–"  # where a run has no value


@dataclass(frozen=True)
class Row:
    """A line of a table; `marked` where the runs differ in what should be seen; `reasons`: why cells are empty."""

    label: str
    cells: list[str]
    marked: bool = False
    reasons: tuple[str, ...] = ()


def asked(runs: list[Run], function: Callable) -> tuple[list, tuple[str, ...]]:
    """(what each run answers, None where it cannot; the reasons)."""
    answers, reasons = [], []
    for run in runs:
        try:
            answers.append(function(run))
        except Missing as missing:
            answers.append(None)
            reasons.append(str(missing))
    return answers, tuple(reasons)


def facts(runs: list[Run]) -> list[Row]:
    """What was run, where any run says it."""
    rows = [Row("folder", [str(run.folder) for run in runs])]
    for label, function in FACTS.items():
        answers, reasons = asked(runs, function)
        if any(answers):
            rows.append(Row(label, [NONE if answer is None else answer for answer in answers], reasons=reasons))
    return rows


def parameters(runs: list[Run]) -> list[Row]:
    """The level's parameters with those of --set, as case.json names them; marked where the runs differ."""
    names = dict.fromkeys(name for run in runs for name in run.params)
    rows = []
    for name in names:
        cells = [words(run.params[name]) if name in run.params else NONE for run in runs]
        rows.append(Row(name, cells, marked=len(set(cells)) > 1))
    return rows


def values(runs: list[Run], *modules: str) -> list[Row]:
    """Every number of those modules of diagnostics that any run has."""
    chosen = [each for each in VALUES.values() if each.function.__module__.rpartition(".")[2] in modules]
    rows = [numbers(each, *asked(runs, each)) for each in chosen]
    if all(cell == NONE for row in rows for cell in row.cells):
        raise Missing(rows[0].reasons[0])
    return [row for row in rows if any(cell != NONE for cell in row.cells)]


def numbers(diagnostic: Diagnostic, answers: list, reasons: tuple[str, ...]) -> Row:
    """One diagnostic, all runs in the same unit, four digits."""
    factor, unit = readable(diagnostic.unit, max((abs(answer) for answer in answers if answer is not None), default=0))
    cells = [NONE if answer is None else number(factor * answer) for answer in answers]
    return Row(labelled(diagnostic.label, unit), cells, reasons=reasons)


def number(value: float) -> str:
    """Four digits; whole numbers in full."""
    value += 0.0  # no minus before a zero
    return f"{value:.0f}" if value == round(value) and abs(value) < 1e12 else f"{value:.4g}"


def momentum(runs: list[Run]) -> list[Row]:
    """The balance of vertical momentum, term by term [N s]."""
    answers, reasons = asked(runs, balance)
    names = dict.fromkeys(name for answer in answers if answer for name in answer)
    if not names:
        raise Missing(reasons[0])
    return [Row(name, [NONE if answer is None else number(answer[name]) for answer in answers]) for name in names]
