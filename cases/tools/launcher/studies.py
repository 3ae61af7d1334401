"""The commands that look at runs or make many of them: report, sweep, calibrate. Each is a package beside the launcher, which is
imported, with what it needs of other packages, only when its command runs."""
from __future__ import annotations

import argparse
from pathlib import Path

from .build import setup
from .packages import need
from .say import Failure


def report(arguments: argparse.Namespace) -> int:
    """Writes a page about one run or several."""
    try:
        from report.page import page
    except ImportError as missing:
        raise Failure(f"report needs Python's {missing.name}; install python3-{missing.name}, or all of Frazil's packages with "
                      "./frazil setup.") from None
    out = Path(arguments.output or Path(arguments.run[0], "report.html"))
    out.write_text(page(arguments.run))
    print(f"report: {out}")
    return 0


def sweep(arguments: argparse.Namespace) -> int:
    """Runs a case at many points."""
    need("yaml", "jinja2", "h5py", "matplotlib")
    from sweep.run import sweep as run_study
    return run_study(arguments)


def calibrate(arguments: argparse.Namespace) -> int:
    """Finds the bonds of a given ice."""
    setup()
    need("scipy")
    from calibrate.command import calibrate as find_bonds
    return find_bonds(arguments)


def add_commands(commands: argparse._SubParsersAction) -> None:
    """The three, with their options."""
    command = commands.add_parser("report", help="a page about a run, or several side by side, also while they go on")
    command.add_argument("run", nargs="+", metavar="RUN", help="run folder")
    command.add_argument("--output", metavar="FILE", help="the page (default: report.html in the first run folder)")
    command.set_defaults(act=report)
    command = commands.add_parser("sweep", help="run a case at many points, on the local cores or on Slurm")
    add_sweep(command)
    command.set_defaults(act=sweep)
    command = commands.add_parser("calibrate", help="find the bonds whose specimens have the bulk values of an ice")
    from calibrate.options import add_options
    add_options(command)
    command.set_defaults(act=calibrate)


def add_sweep(command: argparse.ArgumentParser) -> None:
    """The options of `sweep`."""
    command.add_argument("study", metavar="STUDY.yaml", help="case, level, what is fixed and what varies")
    command.add_argument("--out", metavar="DIR", help="study folder (default: runs/CASE-STUDY); the same one goes on")
    command.add_argument("--dry-run", action="store_true", help="show the points and how long they will take")
    command.add_argument("--retry-failed", action="store_true", help="run failed points again, from their start")
    command.add_argument("--cores", type=int, metavar="N", help="local cores to use (default: all)")
    command.add_argument("--slurm", action="store_true", help="submit each point to Slurm")
    command.add_argument("--sbatch", action="append", default=[], metavar="KEY=VALUE",
                         help="with --slurm: an option of sbatch, as in --sbatch time=2:00:00 --sbatch partition=short")
    command.add_argument("--jobs", type=int, default=100, metavar="N", help="points at Slurm at the same time (default: 100)")
    command.add_argument("--profile", metavar="DIR", help="a Snakemake 7 profile instead, for other schedulers")
