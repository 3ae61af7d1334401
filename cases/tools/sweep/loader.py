"""YAML as people mean it: 4e-3 is a number, on and off are words (as in YAML 1.2), and no key stands twice."""
from __future__ import annotations

import re
from pathlib import Path

import yaml

from launcher.say import Failure

NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?$")
WHOLE = re.compile(r"[-+]?\d+$")
KINDS = (("bool", re.compile(r"(true|false)$"), "tf"), ("int", WHOLE, "-+0123456789"),
         ("float", NUMBER, "-+.0123456789"), ("null", re.compile(r"(~|null|)$"), ["~", "n", ""]))


class Loader(yaml.SafeLoader):
    """SafeLoader with these kinds of words and no others."""

    yaml_implicit_resolvers: dict = {}


for kind, pattern, first in KINDS:
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{kind}", pattern, list(first))


def mapping(loader: Loader, node: yaml.MappingNode) -> dict:
    """A mapping in which a key that stands twice is an error."""
    names = [loader.construct_object(key, deep=True) for key, _ in node.value]
    for n, (key, _) in enumerate(node.value):
        if names[n] in names[:n]:
            raise yaml.MarkedYAMLError(problem=f"{names[n]} stands twice", problem_mark=key.start_mark)
    return {name: loader.construct_object(value, deep=True) for name, (_, value) in zip(names, node.value)}


Loader.add_constructor("tag:yaml.org,2002:map", mapping)
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))


def load(path: Path) -> dict:
    """The file's mapping."""
    if not path.is_file():
        raise Failure(f"{path}: there is no such study file. README.md has an example.")
    try:
        text = yaml.load(path.read_text(), Loader)
    except yaml.YAMLError as error:
        raise Failure(f"{path}: {error}") from None
    if not isinstance(text, dict):
        raise Failure(f"{path}: is no list of `key: value` lines. README.md has an example.")
    return text
