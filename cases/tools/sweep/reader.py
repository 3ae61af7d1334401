"""Reads a study file strictly. An error names file, key, value, problem and cure."""
from __future__ import annotations

import json
from pathlib import Path

from launcher.case import find_case, read
from launcher.say import did_you_mean, Failure

from .loader import load
from .metrics import known
from .study import Study
from .vary import check_repeats, check_varied

TOP_KEYS = {"case": str, "level": str, "title": str, "np": dict, "set": dict, "vary": dict, "combine": str, "count": int,
            "seed": int, "points": list, "repeats": int, "metrics": list, "depths": list}


def read_study(path: Path) -> Study:
    """Reads and checks a study file; its case may be a path relative to it."""
    text = load(path)
    for key, value in text.items():
        if key not in TOP_KEYS:
            raise Failure(f"{path}: {key} {json.dumps(value)}: no such key.{did_you_mean(str(key), list(TOP_KEYS))}")
        if not isinstance(value, TOP_KEYS[key]) or isinstance(value, bool):
            raise Failure(f"{path}: {key} {json.dumps(value)}: is no {TOP_KEYS[key].__name__}. README.md has an example.")
    study = with_case(path, text)
    for key in ("np", "set", "vary", "combine", "count", "seed", "points", "repeats", "metrics", "depths"):
        setattr(study, key, text.get(key, getattr(study, key)))
    check_fixed(study)
    check_varied(study)
    check_repeats(study)
    check_metrics(study)
    return study


def with_case(path: Path, text: dict) -> Study:
    """The study's case and level, with the level's parameters."""
    if "case" not in text:
        raise Failure(f"{path}: case: is missing. Name a case of cases/, or the path of one.")
    name = text["case"]
    case = find_case(str(path.parent / name) if "/" in name else name)
    about = read(case)
    level = text.get("level", about.get("default_level", "demo"))
    if level not in about["levels"]:
        raise Failure(f"{path}: level {json.dumps(level)}: {case.name} has none.{did_you_mean(level, list(about['levels']))}")
    return Study(path, case, level, text.get("title", path.stem), dict(about["levels"][level]), about.get("units", {}))


def check_fixed(study: Study) -> None:
    """`set` and `np`."""
    for name, value in study.set.items():
        study.check_value(f"set.{name}", name, value)
        study.defaults[name] = value
    for side, ranks in study.np.items():
        if side not in ("dem", "foam") or type(ranks) is not int or ranks < 1:
            study.refuse(f"np.{side}", ranks, "ranks are whole numbers of `dem` and `foam`", "As in np: {dem: 1, foam: 1}.")


def check_metrics(study: Study) -> None:
    """`metrics` and `depths`."""
    for name in study.metrics:
        if name not in known():
            study.refuse("metrics", name, "no such metric", did_you_mean(str(name), list(known())))
    for level in study.depths:
        if isinstance(level, (bool, str)) or not isinstance(level, (int, float)):
            study.refuse("depths", level, "is no depth in m", "As in depths: [0.02, 0.05].")
