"""Snakemake's command line for a study, on the local cores or on Slurm, and its process."""
from __future__ import annotations

import argparse
import os
import shlex
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import TextIO

from launcher import places
from launcher.environment import environment
from launcher.say import Failure

from .lock import say_how_to_end
from .study_folder import StudyFolder

HERE = Path(__file__).resolve().parent
INTERRUPT_PATIENCE = 90  # a pair that is asked to end gets 30 s to write its output [s]


def command(folder: StudyFolder, arguments: argparse.Namespace) -> list[str]:
    """Snakemake's words. --nolock: our own lock tells a living sweep from one that was killed (run.py). Only a missing mark
    makes a point run: neither a newer Snakefile nor another time of a file does."""
    words = ["snakemake", "--snakefile", str(HERE / "Snakefile"), "--directory", str(folder.path), "--nolock", "--keep-going",
             "--rerun-incomplete", "--rerun-triggers", "mtime", "--scheduler", "greedy",
             "--config", f"python={sys.executable}", f"sweep={HERE}"]
    if arguments.profile:
        return [*words, "--profile", arguments.profile]
    if arguments.slurm:
        return [*words, *slurm_words(arguments)]
    return [*words, "--cores", str(arguments.cores or os.cpu_count() or 1)]


def slurm_words(arguments: argparse.Namespace) -> list[str]:
    """Snakemake on Slurm through sbatch: a job has as many tasks as its point has ranks, and a copy of this environment."""
    if not shutil.which("sbatch"):
        raise Failure("--slurm: there is no sbatch here. Start the sweep on a machine that submits to your Slurm.")
    options = [shlex.quote(f"--{option}") for option in arguments.sbatch]
    submit = ["sbatch", "--parsable", "--nodes=1", "--ntasks={threads}", "--job-name=frazil-{wildcards.point}",
              "--output=log/slurm-%j.txt", *options]
    status = shlex.join([sys.executable, "-B", str(HERE / "slurm_status.py")])
    return ["--jobs", str(arguments.jobs), "--cluster", " ".join(submit), "--cluster-status", status,
            "--cluster-cancel", "scancel", "--latency-wait", "60"]


def start(folder: StudyFolder, arguments: argparse.Namespace, lock: TextIO) -> subprocess.Popen:
    """Snakemake, in a session of its own, so that Ctrl-C reaches it and its jobs through `stop` only. It inherits the lock,
    which it keeps if this process is killed. Its jobs end by SIGINT, which a shell's background jobs inherit as ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with (folder.path / "snakemake.log").open("ab") as log:
        words = command(folder, arguments)
        log.write(f"\n$ {shlex.join(words)}\n".encode())
        log.flush()
        env = {**environment(), "FRAZIL_BUILD": str(places.BUILD)}
        process = subprocess.Popen(words, stdout=log, stderr=log, stdin=subprocess.DEVNULL, start_new_session=True, env=env,
                                   pass_fds=[lock.fileno()])
    say_how_to_end(lock, process.pid)
    return process


def stop(process: subprocess.Popen) -> None:
    """Ctrl-C for Snakemake and its local jobs, whose pairs write their output and end; it cancels those of a cluster."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, number)
            process.wait(INTERRUPT_PATIENCE)
            return
        except ProcessLookupError:
            return
        except subprocess.TimeoutExpired:
            continue
