"""What a study file says: which case, what is fixed, what varies."""
from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NoReturn

from launcher.case import fits
from launcher.say import did_you_mean, Failure

SAMPLES = ("latin_hypercube", "sobol")
COMBINATIONS = ("product", "zip", *SAMPLES)
SEED = "weibull_seed"
RANGE_KEYS = ("from", "to", "count", "step", "scale")


@dataclass
class Study:
    """What the file says. `defaults` are the level's parameters with those of `set`."""

    path: Path
    case: Path
    level: str
    title: str
    defaults: dict[str, Any]
    units: dict[str, str]
    np: dict[str, int] = field(default_factory=dict)
    set: dict[str, Any] = field(default_factory=dict)
    vary: dict[str, Any] = field(default_factory=dict)
    combine: str = "product"
    count: int = 0
    seed: int = 1
    points: list[dict] = field(default_factory=list)
    repeats: int = 1
    metrics: list[str] = field(default_factory=list)
    depths: list[float] = field(default_factory=lambda: [0.02, 0.05, 0.1])  # [m]

    def refuse(self, key: str, value: Any, problem: str, cure: str = "") -> NoReturn:
        """An error about a value of the file."""
        raise Failure(f"{self.path}: {key} {json.dumps(value)}: {problem}.{' ' + cure.strip() if cure else ''}")

    def check_value(self, key: str, name: str, value: Any) -> None:
        """A parameter of the case with a value of its kind; a whole number stays one."""
        if name not in self.defaults:
            self.refuse(key, value, f"{self.case.name} has no such parameter", did_you_mean(name, list(self.defaults)))
        if not fits(value, self.defaults[name]):
            self.refuse(key, value, f"{name} is like {json.dumps(self.defaults[name])}", "Give a value of that kind.")
        if self.is_whole(name) and value != int(value):
            self.refuse(key, value, f"{name} is a whole number", "Give one, or a range whose step is one.")

    def is_whole(self, name: str) -> bool:
        """True for a parameter that counts something."""
        return type(self.defaults[name]) is int
