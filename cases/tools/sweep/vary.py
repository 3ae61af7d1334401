"""Checks of what varies in a study: `vary`, `combine`, `count`, `points`, `repeats`."""
from __future__ import annotations

from typing import Any

from launcher.say import did_you_mean

from .study import COMBINATIONS, RANGE_KEYS, SAMPLES, SEED, Study


def check_varied(study: Study) -> None:
    """`vary`, `combine`, `count`, `points`."""
    if study.combine not in COMBINATIONS:
        study.refuse("combine", study.combine, "no such way", did_you_mean(study.combine, list(COMBINATIONS)))
    sampled = study.combine in SAMPLES
    if sampled and (study.count < 1 or not study.vary):
        study.refuse("count", study.count, f"{study.combine} needs the number of points and `vary`", "Give both.")
    if not sampled and study.count:
        study.refuse("count", study.count, "is for samples", f"Leave it out, or combine: {' or '.join(SAMPLES)}.")
    for name, values in study.vary.items():
        check_axis(study, name, values, sampled)
    for number, point in enumerate(study.points, 1):
        if not isinstance(point, dict) or not point:
            study.refuse(f"points {number}", point, "is no point", "As in points: [{impact_speed: 10}].")
        for name, value in point.items():
            study.check_value(f"points {number} {name}", name, value)
    if not study.vary and not study.points:
        study.refuse("vary", {}, "nothing varies", "Give `vary` or `points`.")


def check_axis(study: Study, name: str, values: Any, sampled: bool) -> None:
    """One parameter of `vary`: a list, or a range."""
    key = f"vary.{name}"
    if isinstance(values, list) and values and not sampled:
        for value in values:
            study.check_value(key, name, value)
        return
    if not isinstance(values, dict):
        study.refuse(key, values, "is no range" if sampled else "is neither a list nor a range",
                     "As in {from: 5, to: 40" + ("}." if sampled else ", count: 8}."))
    check_range(study, key, name, values, sampled)


def check_range(study: Study, key: str, name: str, values: dict, sampled: bool) -> None:
    """{from: a, to: b} with count or step, where the range is not sampled, and scale: linear or log."""
    for word in values:
        if word not in RANGE_KEYS:
            study.refuse(f"{key}.{word}", values[word], "no such key", did_you_mean(str(word), list(RANGE_KEYS)))
    for word in ("from", "to"):
        if word not in values:
            study.refuse(key, values, f"has no `{word}`", "Give both ends.")
        study.check_value(f"{key}.{word}", name, values[word])
    low, high, scale = values["from"], values["to"], values.get("scale", "linear")
    if isinstance(low, (str, list)) or low >= high:
        study.refuse(key, values, "does not rise", "Give numbers with from < to.")
    if scale not in ("linear", "log") or scale == "log" and low <= 0:
        study.refuse(f"{key}.scale", scale, "is linear or log, and log needs from > 0", "linear is the default.")
    given = [word for word in ("count", "step") if word in values]
    if len(given) != (0 if sampled else 1):
        study.refuse(key, values, "a sample has one `count` for all" if sampled else "needs `count` or `step`, one of them",
                     "Leave it out here." if sampled else "")
    if given and (isinstance(values[given[0]], (str, bool)) or values[given[0]] <= 0 or given == ["count"]
                  and (type(values["count"]) is not int or values["count"] < 2)):
        study.refuse(f"{key}.{given[0]}", values[given[0]], "a count is at least 2, a step above 0")
    if given == ["step"] and scale == "log":
        study.refuse(f"{key}.step", values["step"], "a log range has a count", "Give count instead.")


def check_repeats(study: Study) -> None:
    """Repeats differ by the seed of the bonds' strengths, so these must scatter."""
    if study.repeats < 1:
        study.refuse("repeats", study.repeats, "is less than one", "Leave it out for a single run of each point.")
    if study.repeats == 1:
        return
    varied = set(study.vary).union(*study.points)
    if SEED not in study.defaults or SEED in varied:
        study.refuse("repeats", study.repeats, f"are seeds of {SEED}, which {study.case.name} does not have or you vary",
                     "Leave out one of them.")
    if not study.defaults["weibull_modulus"] and "weibull_modulus" not in varied:
        study.refuse("repeats", study.repeats, "all bonds are equally strong, so every repeat would be the same",
                     "Set weibull_modulus.")
