"""Cases: found by their case.json, with a level's parameters and what --set makes of them."""
from __future__ import annotations

import json
from pathlib import Path

from . import places
from .say import did_you_mean, Failure


def find_case(name: str) -> Path:
    """Folder of a case: its name under cases/, or the path of one elsewhere."""
    folder = Path(name) if "/" in name else places.TOP / "cases" / name
    if (folder / "case.json").is_file():
        return folder.resolve()
    raise Failure(f"there is no case {name}.{did_you_mean(name, list(shipped()))}")


def read(case: Path) -> dict:
    """The case's own description: title, question, levels, ranks, picture, pair (false: no fluid), test (the parameters
    that its test runs with)."""
    return json.loads((case / "case.json").read_text())


def shipped() -> dict[str, str]:
    """The question of each case under cases/, by name."""
    return {path.parent.name: read(path.parent)["question"] for path in sorted((places.TOP / "cases").glob("*/case.json"))}


def override(params: dict, settings: list[str]) -> dict:
    """The level's parameters with --set KEY=VALUE applied; a new value must be of the kind of the old one."""
    result = dict(params)
    for setting in settings:
        key, equals, text = setting.partition("=")
        if key not in params or not equals:
            raise Failure(f"--set {setting}: the case has no such parameter.{did_you_mean(key, list(params))}")
        try:
            value = json.loads(text)
        except json.JSONDecodeError:
            value = text
        kinds = [float if isinstance(item, (int, float)) and not isinstance(item, bool) else type(item)
                 for item in (value, params[key])]
        if kinds[0] is not kinds[1]:
            raise Failure(f"--set {setting}: {key} is like {json.dumps(params[key])}, {text!r} is not.")
        result[key] = value
    return result
