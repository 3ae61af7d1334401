"""The command line and its commands."""
from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import NoReturn

from . import places, studies
from .build import setup
from .case import find_case, read, shipped
from .environment import environment
from .results import check, link_results, picture, plot, summary, write_metrics
from .resume import resume
from .run import plan, prepare, Run
from .say import Failure
from .watch import start_programs, watch


def execute(arguments: argparse.Namespace) -> NoReturn:
    """Replaces this process by a command, in the environment of the pair."""
    try:
        os.execvpe(arguments.command[0], arguments.command, environment())
    except FileNotFoundError:
        hint = "" if (places.BUILD / "bin/frazilDem").exists() else " Nothing is built yet: ./frazil setup."
        raise Failure(f"{arguments.command[0]}: no such command.{hint}") from None


def test(arguments: argparse.Namespace) -> int:
    """Sets up, then runs CTest, whose summary is the last thing printed."""
    setup()
    cores = str(os.cpu_count() or 1)  # tests of the pair run alone all the same, those on several ranks take as many cores
    command = ["ctest", "--test-dir", str(places.BUILD), "--output-on-failure", "--parallel", cores, *arguments.ctest]
    return subprocess.run(command, env=environment()).returncode


def run_case(arguments: argparse.Namespace) -> int:
    """Sets up and runs a case."""
    run = resume(arguments) if arguments.resume else plan(arguments)
    setup()
    ranks = f"frazilDem on {run.np_dem}" + (f", frazilFoam on {run.np_foam}" if run.np_foam else "")
    print(f"{run.title}: {ranks} ranks, in {run.folder}", flush=True)
    return carry_out(run, fresh=not arguments.resume)


def carry_out(run: Run, fresh: bool) -> int:
    """Prepares a new run folder, runs the programs in it and reports; the exit status of the case's check."""
    if fresh:
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
    """Ends the help of `run`: every case with its question."""
    questions = {name: read(find_case(name)).get("question", "") for name in shipped()}
    return "cases:\n" + "\n".join(f"  {name:<20} {question}" for name, question in questions.items())


class Parser(argparse.ArgumentParser):
    """With a function as epilog, so that cases are read only where help is shown."""

    def format_help(self) -> str:
        if callable(self.epilog):
            self.epilog = self.epilog()
        return super().format_help()


def parser() -> argparse.ArgumentParser:
    """The commands and their options."""
    top = Parser(prog="frazil", description="LIGGGHTS and OpenFOAM, coupled: set up, run, test.")
    commands = top.add_subparsers(dest="name", required=True, metavar="COMMAND")
    command = commands.add_parser("setup", help="install what is missing and build (quick when there is nothing to do)")
    command.set_defaults(act=setup)
    command = commands.add_parser("exec", help="run any command in the environment of the pair")
    command.add_argument("command", nargs=argparse.REMAINDER, metavar="CMD ...")
    command.set_defaults(act=execute)
    command = commands.add_parser("run", help="run a case of cases/, set-up included", epilog=list_of_cases,
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_argument("case", metavar="CASE")
    command.add_argument("--level", help="demo (minutes), validation or paper; the case's own default otherwise")
    command.add_argument("--np-dem", type=int, metavar="N", help="ranks of frazilDem")
    command.add_argument("--np-foam", type=int, metavar="M", help="ranks of frazilFoam")
    command.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="override a level's parameter")
    command.add_argument("--out", metavar="DIR", help="run folder (default: a new one in runs/)")
    command.add_argument("--resume", action="store_true", help="continue an interrupted run")
    command.set_defaults(act=run_case)
    studies.add_commands(commands)
    command = commands.add_parser("test", help="set up and run all tests; further arguments go to ctest")
    command.add_argument("ctest", nargs=argparse.REMAINDER, metavar="ctest arguments")
    command.set_defaults(act=test)
    return top


def command_line() -> argparse.Namespace:
    """The words of the command line; wrong ones end with status 2."""
    arguments, options = parser().parse_known_args()
    if options and arguments.name != "test":
        parser().error(f"unrecognized arguments: {' '.join(options)}")
    if options:  # argparse leaves leading options out of the remainder
        arguments.ctest = options + arguments.ctest
    if arguments.name == "exec" and not arguments.command:
        parser().error("exec: which command?")
    return arguments


def main() -> int:
    """Runs a command; errors meant for the user end with status 1."""
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:  # nohup's word counts
            signal.signal(number, signal.default_int_handler)  # ends a run as Ctrl-C does
    try:
        arguments = command_line()
        return arguments.act(arguments)
    except (Failure, OSError, subprocess.CalledProcessError) as failure:
        print(f"frazil: {failure}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
