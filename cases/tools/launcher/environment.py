"""The environment of the pair; `frazil exec` and `frazil test`, which run a command in it."""
from __future__ import annotations

import argparse
import os
import subprocess
from typing import NoReturn

from . import places
from .build import setup
from .foam_source import foam_folder
from .say import Failure


def environment() -> dict[str, str]:
    """The environment in which the pair and the host programs run.

    Open MPI: more ranks than cores are allowed, and then a waiting rank must leave the core to the other side. The
    single-copy mechanism of its shared memory needs ptrace rights that containers lack, and only costs a warning."""
    env = dict(os.environ)
    for key, folder in (("PATH", "bin"), ("LD_LIBRARY_PATH", "lib")):
        env[key] = f"{places.BUILD / folder}{os.pathsep + env[key] if env.get(key) else ''}"
    env["PYTHONPATH"] = places.python_path()
    env.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    env.update(OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
               OMPI_MCA_btl_vader_single_copy_mechanism="none", FRAZIL_OPENFOAM_ROOT=str(foam_folder()))
    if os.geteuid() == 0:
        env.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return env


def execute(arguments: argparse.Namespace) -> NoReturn:
    """Replaces this process by a command, in the environment of the pair."""
    env = environment()
    try:
        os.execvpe(arguments.command[0], arguments.command, env)
    except FileNotFoundError:
        hint = "" if (places.BUILD / "bin/frazilDem").exists() else " Nothing is built yet: ./frazil setup."
        raise Failure(f"{arguments.command[0]}: no such command.{hint}") from None


def test(arguments: argparse.Namespace) -> int:
    """Sets up, then runs CTest, whose summary is the last thing printed."""
    setup()
    cores = str(os.cpu_count() or 1)  # tests of the pair run alone all the same, those on several ranks take as many cores
    command = ["ctest", "--test-dir", str(places.BUILD), "--output-on-failure", "--parallel", cores, *arguments.ctest]
    return subprocess.run(command, env=environment()).returncode
