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
         lattice.TENSION: "strength in tension"}


def rows(targets: Targets, one: Round) -> list[dict]:
    """What was asked for or measured: name, target [Pa] or None, reached [Pa], its scatter over the seeds [Pa], error [-],
    whether the specimens failed."""
    table = []
    for key in ("young", *STRENGTHS):
        measured = one.specimens[lattice.TENSION if key == "young" else key]
        values = [specimen.young if key == "young" else specimen.strength for specimen in measured]
        target, reached = getattr(targets, key), sum(values) / len(values)
        table.append({"name": NAMES[key], "target": target, "reached": reached, "error": reached / target - 1 if target else None,
                      "scatter": stdev(values) if len(values) > 1 else None,
                      "fails": key == "young" or all(specimen.fails for specimen in measured)})
    return table


def table_text(table: list[dict]) -> str:
    """The table as text; stresses in MPa."""
    lines = [f"  {'':<24} {'target':>10} {'reached':>10} {'± seeds':>9} {'error':>8}   [MPa]"]
    mega = lambda value: "-" if value is None else f"{value / 1e6:.4g}"
    for row in table:
        error = "-" if row["error"] is None else f"{100 * row['error']:+.1f} %"
        lines.append(f"  {row['name']:<24} {mega(row['target']):>10} {mega(row['reached']):>10} {mega(row['scatter']):>9} {error:>8}"
                     + ("" if row["fails"] else "   largest load: not all specimens parted"))
    return "\n".join(lines)


def write(path: Path, targets: Targets, rounds: list[Round], conflicts: list[str], seconds: float) -> None:
    """calibration.json: the bonds, the table, how it came about."""
    last = rounds[-1]
    path.write_text(json.dumps({
        "bonds": dataclasses.asdict(last.bonds), "table": rows(targets, last), "conflicts": conflicts,
        "rounds": [{"bonds": dataclasses.asdict(one.bonds), "errors": one.errors(targets)} for one in rounds],
        "wall_seconds": round(seconds, 1)}, indent=2) + "\n")
