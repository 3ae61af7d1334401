"""A run folder, opened lazily: each file is read when a diagnostic asks for it, and a missing one is said in words."""
from __future__ import annotations

import json
import re
from functools import cached_property
from pathlib import Path

import numpy

from launcher.table import read_columns, read_rows

from .catalogue import Missing, Series
from .snapshots import Snapshots

KNOWN = ("run.json", "params.json", "history.csv")


class Run:
    """The folder of a run that has ended, was interrupted or is going on."""

    def __init__(self, folder: Path | str) -> None:
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise Missing(f"{folder}: there is no such folder; name one that ./frazil run has made.")
        if not any((self.folder / name).is_file() for name in KNOWN):
            raise Missing(f"{folder}: is no run folder, it has none of {', '.join(KNOWN)}; "
                          "name one that ./frazil run has made.")
        self.name = self.folder.resolve().name

    @cached_property
    def plan(self) -> dict:
        """run.json: case, level, ranks; empty for a pair that was started by hand."""
        return self.json("run.json")

    @cached_property
    def params(self) -> dict:
        """params.json: the level's parameters with those of --set; empty for a pair that was started by hand."""
        return self.json("params.json")

    def json(self, name: str) -> dict:
        """A JSON file; empty without it."""
        path = self.folder / name
        try:
            return json.loads(path.read_text()) if path.is_file() else {}
        except json.JSONDecodeError as error:
            raise Missing(f"{path}: {error}; the run was cut off while it wrote it.") from None

    def parameter(self, name: str) -> float:
        """A parameter of the run."""
        if name not in self.params:
            raise Missing(f"{self.folder / 'params.json'}: has no parameter {name}.")
        return self.params[name]

    @cached_property
    def history(self) -> dict[str, numpy.ndarray]:
        """history.csv as columns."""
        return self.table("history.csv")

    @cached_property
    def ledger(self) -> dict[str, numpy.ndarray]:
        """ledger.csv as columns."""
        return self.table("ledger.csv")

    def table(self, name: str) -> dict[str, numpy.ndarray]:
        """A CSV file of numbers as columns, without a line that is not whole yet."""
        columns = read_columns(self.folder / name)
        if not columns or not len(next(iter(columns.values()))):
            raise Missing(f"{self.folder / name}: does not exist or has no row yet; the programs write it once per fluid step.")
        return {key: numpy.array(values) for key, values in columns.items()}

    def column(self, name: str, table: str = "history") -> Series:
        """A column of history.csv or ledger.csv over time, without the rows in which it has no value."""
        columns = getattr(self, table)
        if name not in columns or numpy.all(numpy.isnan(columns[name])):
            raise Missing(f"{self.folder / table}.csv: has no values of {name}.")
        there = ~numpy.isnan(columns[name])
        return Series(columns["time"][there], columns[name][there])

    @cached_property
    def events(self) -> dict[str, numpy.ndarray]:
        """dem/bonds.csv, every broken bond: time [s], id1, id2, mode, x y z [m], sigma, tau [Pa]; mode is a word."""
        path = self.folder / "dem/bonds.csv"
        names, rows = read_rows(path)
        if not names:
            raise Missing(f"{path}: does not exist; the script's fix bond/parallel writes it with the keyword events.")
        columns = {name: [row[n] for row in rows] for n, name in enumerate(names)}
        return {name: numpy.array(words, dtype=str if name == "mode" else float) for name, words in columns.items()}

    @cached_property
    def particles(self) -> Snapshots:
        """Spheres over time, particles.h5."""
        return Snapshots(self.folder / "particles.h5", "particles", "the script's fix results")

    @cached_property
    def coarse(self) -> Snapshots:
        """Coarse fields over time, coarse.h5."""
        return Snapshots(self.folder / "coarse.h5", "coarse", "frazilFoam")

    def text(self, name: str) -> str:
        """A text file, as one of OpenFOAM's dictionaries."""
        path = self.folder / name
        if not path.is_file():
            raise Missing(f"{path}: does not exist.")
        return path.read_text(errors="replace")

    def log(self, name: str) -> str:
        """The whole lines of a log that may be growing."""
        text = self.text(name)
        return text[: text.rfind("\n") + 1]

    def entry(self, name: str, key: str) -> float:
        """A number in one of OpenFOAM's dictionaries: the first `key number;`."""
        found = re.search(rf"\b{key}\s+([-+\d.eE]+)\s*;", self.text(name))
        if not found:
            raise Missing(f"{self.folder / name}: has no number {key}.")
        return float(found.group(1))
