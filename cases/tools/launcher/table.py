"""CSV files: history.csv while it grows, and any as columns."""
from __future__ import annotations

import csv
from pathlib import Path


class History:
    """history.csv while it grows: reads only what is new."""

    def __init__(self, path: Path) -> None:
        self.path, self.offset, self.names, self.row, self.rows = path, 0, [], {}, 0

    def read(self) -> dict[str, float]:
        """The newest complete row by column name, without those that have no value; empty before the first one."""
        if not self.path.is_file():
            return {}
        with self.path.open("rb") as stream:
            stream.seek(self.offset)
            text = stream.read()
        complete = text[: text.rfind(b"\n") + 1]
        self.offset += len(complete)
        for words in csv.reader(complete.decode().splitlines()):
            if not self.names:
                self.names = [word.strip(" #") for word in words]
            elif len(words) == len(self.names):
                self.row = {name: float(word) for name, word in zip(self.names, words) if word != "nan"}
                self.rows += 1
        return self.row


def speed(row: dict[str, float]) -> float | None:
    """Speed of the body [m/s]; None in a case without one."""
    parts = [row.get(name) for name in ("vx", "vy", "vz")]
    return sum(part * part for part in parts) ** 0.5 if None not in parts else None


def read_rows(path: Path) -> tuple[list[str], list[list[str]]]:
    """(column names, rows of words) of a CSV file that may still grow: a last line without its end does not count."""
    if not path.is_file():
        return [], []
    text = path.read_bytes()
    rows = list(csv.reader(text[: text.rfind(b"\n") + 1].decode().splitlines()))
    names = [word.strip(" #") for word in rows[0]] if rows else []
    return names, [row for row in rows[1:] if len(row) == len(names)]


def read_columns(path: Path) -> dict[str, list[float]]:
    """A CSV file of numbers as columns."""
    names, rows = read_rows(path)
    return {name: [float(row[index]) for row in rows] for index, name in enumerate(names)}
