"""The command line."""
from __future__ import annotations

import argparse
import signal
import subprocess
import sys

from .build import setup
from .case import shipped
from .environment import execute, test
from .results import check, link_results, picture, plot, summary, write_metrics
from .resume import resume
from .run import plan, prepare
from .say import Failure
from .watch import start_programs, watch


def run_case(arguments: argparse.Namespace) -> int:
    """Sets up, prepares a run folder, runs the pair in it and reports."""
    run = resume(arguments) if arguments.resume else plan(arguments)
    setup()
    ranks = f"frazilDem on {run.np_dem}" + (f", frazilFoam on {run.np_foam}" if run.np_foam else "")
    print(f"{run.title}: {ranks} ranks, in {run.folder}", flush=True)
    if not arguments.resume:
        prepare(run)
    seconds = watch(run, start_programs(run))
    metrics = write_metrics(run, seconds)
    link_results(run)
    plot(run)
    print()
    for label, value in summary(metrics):
        print(f"  {label:<22} {value}")
    print(flush=True)
    status = check(run)
    picture(run)
    print(f"results: {run.folder}")
    return status


def list_of_cases() -> str:
    """Ends the help of `run`."""
    return "cases:\n" + "\n".join(f"  {name:<16} {question}" for name, question in shipped().items())


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = argparse.ArgumentParser(prog="frazil", description="LIGGGHTS and OpenFOAM, coupled: set up, run, test.")
    commands = top.add_subparsers(dest="name", required=True, metavar="COMMAND")
    command = commands.add_parser("setup", help="install what is missing and build (quick when there is nothing to do)")
    command.set_defaults(act=setup)
    command = commands.add_parser("exec", help="run any command in the environment of the pair")
    command.add_argument("command", nargs=argparse.REMAINDER, metavar="CMD ...")
    command.set_defaults(act=execute)
    command = commands.add_parser("run", help="run a case of cases/, set-up included", epilog=list_of_cases(),
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_argument("case", metavar="CASE")
    command.add_argument("--level", help="demo (minutes), validation or paper; the case's own default otherwise")
    command.add_argument("--np-dem", type=int, metavar="N", help="ranks of frazilDem")
    command.add_argument("--np-foam", type=int, metavar="M", help="ranks of frazilFoam")
    command.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="override a level's parameter")
    command.add_argument("--out", metavar="DIR", help="run folder (default: a new one in runs/)")
    command.add_argument("--resume", action="store_true", help="continue an interrupted run")
    command.set_defaults(act=run_case)
    command = commands.add_parser("test", help="set up and run all tests; further arguments go to ctest")
    command.add_argument("ctest", nargs=argparse.REMAINDER, metavar="ctest arguments")
    command.set_defaults(act=test)
    return top


def main() -> int:
    """Runs a command; errors meant for the user end with status 1."""
    arguments, options = parser().parse_known_args()
    if options and arguments.name != "test":
        parser().error(f"unrecognized arguments: {' '.join(options)}")
    if options:  # argparse leaves leading options out of the remainder
        arguments.ctest = options + arguments.ctest
    if arguments.name == "exec" and not arguments.command:
        parser().error("exec: which command?")
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.default_int_handler)  # ends a run as Ctrl-C does
    try:
        return arguments.act(arguments)
    except (Failure, OSError, subprocess.CalledProcessError) as failure:
        print(f"frazil: {failure}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
