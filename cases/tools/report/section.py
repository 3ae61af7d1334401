"""A section of the page: tables and pictures, and why some are not there."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Callable

from diagnostics import Missing

from .figure import Picture
from .tables import Row


@dataclass
class Section:
    """A heading with its text, tables [(caption, rows)] and pictures."""

    title: str
    text: str = ""
    tables: list[tuple[str, list[Row]]] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)

    def add_table(self, caption: str, make: Callable, *arguments) -> None:
        """A table, if it has rows, and the reasons for its empty cells."""
        rows = self.attempt(make, *arguments) or []
        if rows:
            self.tables.append((caption, rows))
        for row in rows:
            self.lacks(*row.reasons)

    def add(self, make: Callable, *arguments) -> None:
        """A picture or several, if the runs have what they show."""
        made = self.attempt(make, *arguments)
        if made is not None:
            self.pictures += made if isinstance(made, list) else [made]

    def attempt(self, make: Callable, *arguments):
        """What the function makes; None, and the reason is kept, where it cannot."""
        try:
            return make(*arguments)
        except Missing as missing:
            self.lacks(str(missing))
            return None

    def lacks(self, *reasons: str) -> None:
        """Keeps reasons, each once."""
        self.missing = list(dict.fromkeys([*self.missing, *reasons]))

    @property
    def shown(self) -> bool:
        """Whether there is anything to see."""
        return bool(self.tables or self.pictures)
