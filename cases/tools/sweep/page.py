"""index.html of a study folder: one self-contained page with state, table, failures and figures; also while it runs."""
from __future__ import annotations

import base64
import time
from pathlib import Path

import jinja2

from .plots import draw
from .study import Study
from .study_folder import DONE, FAILED, StudyFolder, write_whole
from .table import Column, columns, Measured, write_csv, write_hdf5

HERE = Path(__file__).resolve().parent
TEMPLATES = [HERE, HERE.parent / "report"]  # the page of a study looks like that of a run: page.css
REFRESH = 30  # while the sweep goes on the browser loads the page anew [s]


def embedded(path: Path) -> str:
    """A PNG as the source of an <img>."""
    return "data:image/png;base64," + base64.b64encode(path.read_bytes()).decode()


def cell(value: object) -> str:
    """A value in the page's table."""
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def write_page(study: Study, folder: StudyFolder, table: list[Column], figures: dict[str, list[Path]], going_on: bool) -> None:
    """Fills study.html."""
    names = table[0].values
    states = {name: folder.state(name) for name in names}
    count = lambda status: sum(state["status"] == status for state in states.values())
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True)
    template = environment.get_template("study.html")
    write_whole(folder.path / "index.html", template.render(
        study=study, total=len(names), done=count(DONE), failed=count(FAILED), refresh=REFRESH if going_on else None,
        headers=[column.header for column in table], rows=[list(map(cell, row)) for row in zip(*(c.values for c in table))],
        failures={name: state["why"] for name, state in states.items() if state["status"] == FAILED},
        figures={label: [(path.stem, embedded(path)) for path in paths] for label, paths in figures.items() if paths},
        now=time.strftime("%Y-%m-%d %H:%M:%S")))


def write_results(study: Study, points: dict[str, dict], measured: Measured, going_on: bool) -> None:
    """Table, figures and page of what has ended so far."""
    folder, table = measured.folder, columns(study, points, measured)
    write_csv(folder, table)
    write_hdf5(folder, table)
    write_page(study, folder, table, draw(folder.path / "plots", table), going_on)
