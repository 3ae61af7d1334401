"""The page: sections and definitions put into page.html, without anything that is not in the file itself."""
from __future__ import annotations

from datetime import datetime
from pathlib import Path

import jinja2

from diagnostics import Run, SERIES, VALUES

from . import figure
from .sections import sections


def definitions() -> list[tuple[str, str]]:
    """(label and unit, formula and source) of every diagnostic, as its function says it."""
    every = {**{each.title: each for each in VALUES.values()}, **{each.title: each for each in SERIES.values()}}
    return [(title, each.definition) for title, each in sorted(every.items(), key=lambda item: item[0].lower())]


def named(runs: list[Run]) -> list[Run]:
    """The runs, told apart by their folders' names, or by the whole paths where two have the same name."""
    if len({run.name for run in runs}) < len(runs):
        for run in runs:
            run.name = str(run.folder)
    return runs


def page(folders: list[str]) -> str:
    """The HTML of a report about these run folders."""
    figure.style()
    runs = named([Run(folder) for folder in folders])
    loader = jinja2.FileSystemLoader(Path(__file__).parent)
    environment = jinja2.Environment(loader=loader, autoescape=True, trim_blocks=True, lstrip_blocks=True,
                                     undefined=jinja2.StrictUndefined)
    return environment.get_template("page.html").render(
        title=" and ".join(run.name for run in runs), runs=[(run.name, figure.colour(n)) for n, run in enumerate(runs)],
        sections=sections(runs), definitions=definitions(), date=datetime.now().strftime("%Y-%m-%d %H:%M"))
