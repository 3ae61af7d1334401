"""What a calibration says: a table target / reached / error, the lines for the script, and a file for the cases."""
from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from statistics import stdev

import lattice

from .bonds import Targets
from .fit import Round, STRENGTHS

NAMES = {"young": "E in tension", lattice.BENDING: "strength in bending", lattice.COMPRESSION: "strength in compression",
         lattice.TENSION: "strength in tension", "poisson": "poisson, in plane [-]", "poisson_through": "poisson, through [-]"}


def rows(targets: Targets, one: Round) -> list[dict]:
    """What was asked for or measured: name, unit, target or None, reached, its scatter over the seeds, error [-], whether the
    specimens failed."""
    table = []
    for key, name in NAMES.items():
        measured = one.specimens[key if key in STRENGTHS else lattice.TENSION]
        values = [getattr(specimen, "strength" if key in STRENGTHS else key) for specimen in measured]
        target, reached = getattr(targets, key, None), sum(values) / len(values)
        table.append({"name": name, "unit": "-" if "poisson" in key else "Pa", "target": target, "reached": reached,
                      "error": reached / target - 1 if target else None, "scatter": stdev(values) if len(values) > 1 else None,
                      "fails": key not in STRENGTHS or all(specimen.fails for specimen in measured)})
    return table


def table_text(table: list[dict]) -> str:
    """The table as text; stresses in MPa."""
    lines = [f"  {'':<24} {'target':>10} {'reached':>10} {'± seeds':>9} {'error':>8}   [MPa]"]
    for row in table:
        scale = 1e6 if row["unit"] == "Pa" else 1.0
        target, reached, scatter = ("-" if row[name] is None else f"{row[name] / scale:.4g}"
                                    for name in ("target", "reached", "scatter"))
        error = "-" if row["error"] is None else f"{100 * row['error']:+.1f} %"
        lines.append(f"  {row['name']:<24} {target:>10} {reached:>10} {scatter:>9} {error:>8}"
                     + ("" if row["fails"] else "   largest load: not all specimens parted"))
    return "\n".join(lines)


def write(path: Path, targets: Targets, rounds: list[Round], best: Round, conflicts: list[str], seconds: float) -> None:
    """calibration.json: the bonds, the table, how it came about."""
    path.write_text(json.dumps({
        "bonds": dataclasses.asdict(best.bonds), "table": rows(targets, best), "conflicts": conflicts,
        "rounds": [{"bonds": dataclasses.asdict(one.bonds), "errors": one.errors(targets)} for one in rounds],
        "wall_seconds": round(seconds, 1)}, indent=2) + "\n")
