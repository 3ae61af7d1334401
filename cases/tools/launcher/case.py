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
    raise Failure(f"there is no case {name}.{did_you_mean(name, shipped())}")


def read(case: Path) -> dict:
    """case.json: title, question, levels with their parameters, default_level, np (ranks), pair (false: no fluid),
    picture (a script of cases/tools), test (parameters with which the case is tested), units of parameters, choices (of a
    parameter that stands for others: its values, each with the parameters that differ from the level's)."""
    try:
        return json.loads((case / "case.json").read_text())
    except json.JSONDecodeError as error:
        raise Failure(f"{case / 'case.json'}: {error}") from None


def shipped() -> list[str]:
    """Names of the cases under cases/: every folder with a case.json."""
    return sorted(path.parent.name for path in (places.TOP / "cases").glob("*/case.json"))


def fits(value: object, old: object) -> bool:
    """Whether a parameter's new value is of the kind of the old one."""
    kinds = [float if isinstance(item, (int, float)) and not isinstance(item, bool) else type(item) for item in (value, old)]
    return kinds[0] is kinds[1]


def split(setting: str, params: dict) -> tuple[str, object]:
    """Name and value of KEY=VALUE; the value must be of the kind of the parameter's."""
    key, equals, text = setting.partition("=")
    if key not in params or not equals:
        raise Failure(f"--set {setting}: the case has no such parameter.{did_you_mean(key, list(params))}")
    try:
        value = json.loads(text)
    except json.JSONDecodeError:
        value = text
    if not fits(value, params[key]):
        raise Failure(f"--set {setting}: {key} is like {json.dumps(params[key])}, {text!r} is not.")
    return key, value


def parameters(text: dict, level: str, settings: list[str]) -> dict:
    """The level's parameters with --set KEY=VALUE applied. A choice stands for several of them, which can still be set one by
    one, whatever the order."""
    params, choices = dict(text["levels"][level]), text.get("choices", {})
    given = dict(split(setting, params) for setting in settings)
    for name in choices.keys() & given.keys():
        if given[name] not in choices[name]:
            raise Failure(f"--set {name}={given[name]}: no such {name}.{did_you_mean(given[name], list(choices[name]))}")
        params.update(choices[name][given[name]])
    return {**params, **given}
