"""One table of all points: parameters, metrics, wall time, status; as CSV and HDF5, with units in the header."""
from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from typing import Any

from .metrics import chosen, measure
from .points import varied
from .study import Study
from .study_folder import DONE, StudyFolder, write_whole

WALL_TIME = "wall_time"


@dataclass
class Column:
    """A column: parameter, metric or other, with what page and plots call it. No value: None."""

    name: str
    unit: str
    label: str
    kind: str
    values: list[Any]

    @property
    def header(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def title(self) -> str:
        """Label and unit, for axes."""
        return f"{self.label} [{self.unit}]" if self.unit else self.label

    def numbers(self) -> bool:
        """True where it holds numbers, at least one."""
        there = [value for value in self.values if value is not None]
        return bool(there) and all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in there)


class Measured:
    """The metrics of ended points, each measured once while a sweep goes on."""

    def __init__(self, study: Study, folder: StudyFolder) -> None:
        self.folder, self.metrics, self.found = folder, chosen(study.metrics, study.depths), {}

    def __call__(self, name: str) -> dict[str, float]:
        """Of a point that is done; empty for others, whose numbers would be those of half a run."""
        if name not in self.found and self.folder.state(name)["status"] == DONE:
            self.found[name] = measure(self.folder.run(name), self.metrics)
        return self.found.get(name, {})


def columns(study: Study, points: dict[str, dict], measured: Measured) -> list[Column]:
    """The table. A parameter that a point leaves alone has its value of the level; a metric that no point has is left out."""
    states = [measured.folder.state(name) for name in points]
    results = [measured(name) for name in points]
    table = [Column("point", "", "point", "other", list(points))]
    for name in varied(points):
        values = [bare(point.get(name, study.defaults[name])) for point in points.values()]
        table.append(Column(name, study.units.get(name, ""), name.replace("_", " "), "parameter", values))
    for one in measured.metrics:
        values = [result.get(one.name) for result in results]
        if any(value is not None for value in values):
            table.append(Column(one.name, one.unit, one.label, "metric", values))
    table.append(Column(WALL_TIME, "s", "wall time", "metric", [state.get("wall_seconds") for state in states]))
    for name in ("check", "status"):
        table.append(Column(name, "", name, "other", [state.get(name, "") for state in states]))
    return table


def bare(value: Any) -> Any:
    """A parameter's value for the table: a list of one is its only member, other lists are words."""
    if isinstance(value, list):
        return value[0] if len(value) == 1 else json.dumps(value)
    return value


def write_csv(folder: StudyFolder, table: list[Column]) -> None:
    """results.csv; what has no value is empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(column.header for column in table)
    for row in zip(*(column.values for column in table)):
        writer.writerow("" if value is None else f"{value:.10g}" if isinstance(value, float) else value for value in row)
    write_whole(folder.path / "results.csv", text.getvalue())


def write_hdf5(folder: StudyFolder, table: list[Column]) -> None:
    """results.h5: one dataset per column with its unit as attribute; what has no value is nan."""
    import h5py
    partial = folder.path / ".results.h5"
    with h5py.File(partial, "w") as file:
        for column in table:
            if column.numbers():
                values = [float("nan") if value is None else float(value) for value in column.values]
                data = file.create_dataset(column.name, data=values)
            else:
                data = file.create_dataset(column.name, data=[str(value) for value in column.values], dtype=h5py.string_dtype())
            data.attrs.update(unit=column.unit, label=column.label, kind=column.kind)
    partial.replace(folder.path / "results.h5")
