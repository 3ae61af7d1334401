"""What a run leaves beside the programs' own files: links, curves, picture, metrics, the table at the end, the check."""
from __future__ import annotations

import json
import subprocess
import sys
import time

from . import places
from .case import read
from .environment import environment
from .run import Run
from .say import clock
from .table import History, read_columns, speed


def link_results(run: Run) -> None:
    """results.h5: one file with an external link to each HDF5 file that the programs wrote."""
    files = sorted(path for path in run.folder.rglob("*.h5") if path.name != "results.h5")
    if not files or (run.folder / "results.h5").exists():
        return
    try:
        import h5py
    except ImportError:
        return
    with h5py.File(run.folder / "results.h5", "w") as results:
        for path in files:
            name = path.relative_to(run.folder)
            results[str(name.with_suffix(""))] = h5py.ExternalLink(str(name), "/")


def plot(run: Run) -> None:
    """summary.png: speed of the body, forces on it and broken bonds over time."""
    history = read_columns(run.folder / "history.csv")
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        return
    if not history.get("time"):
        return
    panels = [("speed [m/s]", {"body": [speed(dict(zip(history, row))) for row in zip(*history.values())]}),
              ("vertical force [N]", {"contact": history.get("contact_fy"), "fluid": history.get("fluid_fy")}),
              ("bonds broken", {"tension": history.get("broken_tension"), "shear": history.get("broken_shear")})]
    figure, axes = pyplot.subplots(len(panels), 1, sharex=True, figsize=(7, 7), layout="constrained")
    for axis, (label, curves) in zip(axes, panels):
        for name, values in curves.items():
            if values and any(value is not None and value == value for value in values):
                axis.plot(history["time"], values, label=name)
        axis.set_ylabel(label)
        if axis.lines:
            axis.legend(loc="best", frameon=False)
    axes[-1].set_xlabel("time [s]")
    figure.suptitle(run.title)
    figure.savefig(run.folder / "summary.png", dpi=120)


def picture(run: Run) -> None:
    """picture.png by the script of cases/tools that case.json names, if it names one. A run without a picture is a good
    run: the script says what it misses."""
    script = read(run.case).get("picture")
    if script:
        command = [sys.executable, str(places.TOP / "cases/tools" / script), str(run.folder), str(run.folder / "picture.png")]
        subprocess.run(command, env=environment())


def write_metrics(run: Run, seconds: float) -> dict:
    """metrics.json: what was run, and the last row of the history."""
    history = History(run.folder / "history.csv")
    last = history.read()
    metrics = {"case": run.case.name, "level": run.level, "np_dem": run.np_dem, "np_foam": run.np_foam,
               "params": run.params, "wall_seconds": round(seconds, 1), "fluid_steps": history.rows, "last": last}
    (run.folder / "metrics.json").write_text(json.dumps(metrics, indent=2) + "\n")
    return metrics


def summary(metrics: dict) -> list[tuple[str, str]]:
    """Rows of the table at the end."""
    last = metrics["last"]
    rows = [("wall time", clock(metrics["wall_seconds"]))]
    if metrics["np_foam"]:
        rows.append(("fluid steps", str(metrics["fluid_steps"])))
    for label, key, unit in (("simulated time", "time", "s"), ("body height", "y", "m"),
                             ("bonds intact", "bonds_intact", ""), ("broken in tension", "broken_tension", ""),
                             ("broken in shear", "broken_shear", ""), ("largest fragment η", "eta", "")):
        if key in last:
            rows.append((label, f"{last[key]:.6g} {unit}".strip()))
    if speed(last) is not None:
        rows.append(("body speed", f"{speed(last):.4g} m/s"))
    return rows


def check(run: Run) -> int:
    """Runs the case's own check, which asserts what its README expects."""
    if not (run.case / "check").is_file():
        return 0
    return subprocess.run([sys.executable, str(run.case / "check"), str(run.folder)], env=environment()).returncode
