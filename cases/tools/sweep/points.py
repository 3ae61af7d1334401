"""The points of a study by name. A point's name is made of the parameters that vary, so points added later leave the names,
and with them the results, of the others alone."""
from __future__ import annotations

import hashlib
import itertools
import json
import math
import re

from .study import SEED, Study

DIGITS = 6          # significant digits of computed values: names stay short
LONGEST_NAME = 100  # of a point's name [characters], without the checksum that a longer one gets


def rounded(value: float) -> float:
    """A value with DIGITS significant digits."""
    return float(f"{value:.{DIGITS}g}")


def between(axis: dict, share: float) -> float:
    """The value at a share of the way from one end of a range to the other, on its scale."""
    low, high = axis["from"], axis["to"]
    if axis.get("scale") == "log":
        return low * (high / low) ** share
    return low + (high - low) * share


def axis_values(study: Study, name: str) -> list:
    """Values of a parameter of `vary`: its list, or `count` values with both ends, or steps that do not pass the end."""
    axis = study.vary[name]
    if isinstance(axis, list):
        return axis
    if "count" in axis:
        values = [rounded(between(axis, n / (axis["count"] - 1))) for n in range(axis["count"])]
    else:
        steps = math.floor((axis["to"] - axis["from"]) / axis["step"] + 1e-9)
        values = [rounded(axis["from"] + n * axis["step"]) for n in range(steps + 1)]
    for value in values:
        study.check_value(f"vary.{name}", name, value)
    return [int(value) for value in values] if study.is_whole(name) else values


def grid(study: Study) -> list[dict]:
    """Cartesian product, the last parameter fastest."""
    return [dict(zip(study.vary, row)) for row in itertools.product(*(axis_values(study, name) for name in study.vary))]


def zipped(study: Study) -> list[dict]:
    """First values together, second values together, ..."""
    columns = {name: axis_values(study, name) for name in study.vary}
    if len(set(map(len, columns.values()))) > 1:
        lengths = {name: len(values) for name, values in columns.items()}
        study.refuse("combine", "zip", f"the parameters have different numbers of values, {lengths}", "Give as many of each.")
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


def sampled(study: Study, shares) -> list[dict]:
    """Ranges at rows of shares in [0, 1); whole numbers are met equally often."""
    def value(name: str, share: float) -> float:
        axis = study.vary[name]
        if study.is_whole(name):
            wide = {**axis, "from": axis["from"] - 0.5, "to": axis["to"] + 0.5}
            return round(min(max(between(wide, share), axis["from"]), axis["to"]))
        return rounded(between(axis, share))
    return [{name: value(name, float(share)) for name, share in zip(study.vary, row)} for row in shares]


def latin_hypercube(study: Study) -> list[dict]:
    """One point in each of `count` equal slices of every parameter. Another count gives other points."""
    from scipy.stats import qmc
    return sampled(study, qmc.LatinHypercube(len(study.vary), seed=study.seed).random(study.count))


def sobol(study: Study) -> list[dict]:
    """Scrambled Sobol sequence. A larger count keeps the points of the smaller one."""
    from scipy.stats import qmc
    power = study.count.bit_length() - 1
    if 2**power != study.count:
        study.refuse("count", study.count, "Sobol points are even only in powers of two",
                     f"Give {2**power} or {2**(power + 1)}.")
    return sampled(study, qmc.Sobol(len(study.vary), seed=study.seed).random_base2(power))


COMBINE = {"product": grid, "zip": zipped, "latin_hypercube": latin_hypercube, "sobol": sobol}


def value_text(value: object) -> str:
    """A parameter's value in a name: 20, on, 1+2.66 for a list."""
    if isinstance(value, list):
        return "+".join(map(value_text, value))
    return f"{value:.10g}" if isinstance(value, float) else str(value)


def point_name(settings: dict) -> str:
    """`impact_speed-10_layers-4`: sorted, so that the order in the file does not matter; with a checksum where words do not
    fit into a folder's name."""
    words = "_".join(f"{name}-{value_text(settings[name])}" for name in sorted(settings))
    plain = re.sub(r"[^\w.+-]+", "-", words, flags=re.ASCII)
    if plain == words and len(words) <= LONGEST_NAME:
        return words
    checksum = hashlib.sha1(json.dumps(settings, sort_keys=True).encode()).hexdigest()[:8]
    return f"{plain[:LONGEST_NAME]}_{checksum}"


def points(study: Study) -> dict[str, dict]:
    """All points: those of `vary` combined, then the explicit ones; each repeated with the seeds 1, 2, ..., if asked for."""
    chosen = (COMBINE[study.combine](study) if study.vary else []) + study.points
    if study.repeats > 1:
        chosen = [{**point, SEED: seed} for point in chosen for seed in range(1, study.repeats + 1)]
    return {point_name(point): point for point in chosen}


def varied(chosen: dict[str, dict]) -> list[str]:
    """Names of the parameters that vary, in the order of the file."""
    return list(dict.fromkeys(name for point in chosen.values() for name in point))
