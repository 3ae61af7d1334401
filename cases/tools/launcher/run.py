"""A run: what is to be run, in which folder, on how many ranks; its inputs and its mpirun line."""
from __future__ import annotations

import argparse
import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path

from . import places
from .case import find_case, parameters, read
from .environment import environment
from .say import did_you_mean, Failure, logged, output_of

EXITS = "log.exit"  # in the run folder: program and exit code of whatever failed, the first one first


@dataclass
class Run:
    """What is to be run, where, and on how many ranks. Without a fluid np_foam is 0: frazilDem runs alone."""

    case: Path
    level: str
    params: dict
    np_dem: int
    np_foam: int
    folder: Path

    @property
    def title(self) -> str:
        """Short name for messages."""
        return f"{self.case.name} --level {self.level}"


def version() -> str:
    """Of Frazil: the checkout's commit, with `dirty` if it has changes; without git the newest heading of CHANGELOG.md."""
    commit = output_of(["git", "-C", str(places.TOP), "describe", "--tags", "--always", "--dirty"]).strip()
    return commit or re.search(r"^## (.*)$", (places.TOP / "CHANGELOG.md").read_text(), re.MULTILINE).group(1)


def free_folder(wanted: Path) -> Path:
    """The folder itself, or with the first free number behind it: results are never overwritten."""
    number, folder = 1, wanted
    while folder.exists():
        number += 1
        folder = wanted.with_name(f"{wanted.name}-{number}")
    return folder


def plan(arguments: argparse.Namespace) -> Run:
    """Reads case.json and the command line."""
    case = find_case(arguments.case)
    text = read(case)
    level = arguments.level or text.get("default_level", "demo")
    if level not in text["levels"]:
        raise Failure(f"{case.name} has no level {level}.{did_you_mean(level, list(text['levels']))}")
    folder = Path(arguments.out).resolve() if arguments.out else free_folder(places.TOP / "runs" / f"{case.name}-{level}")
    if folder.exists() and any(folder.iterdir()):
        raise Failure(f"{folder} holds something already; choose another --out or remove it.")
    ranks, pair = text.get("np", {}), text.get("pair", True)
    if arguments.np_foam is not None and not pair:
        raise Failure(f"--np-foam {arguments.np_foam}: {case.name} has no fluid; frazilDem runs alone, on --np-dem ranks.")
    given = {"dem": arguments.np_dem, "foam": arguments.np_foam}
    np = {side: ranks.get(side, 1) if number is None else number for side, number in given.items()}
    if min(np.values()) < 1:
        raise Failure("--np-dem and --np-foam are at least 1.")
    params = parameters(text, level, arguments.set)
    return Run(case, level, params, np["dem"], np["foam"] if pair else 0, folder)


DECOMPOSITION = """FoamFile {{ version 2.0; format ascii; class dictionary; object decomposeParDict; }}
// Cut along the two horizontal axes only: the particles float in a flat layer, and every rank gets its share.
numberOfSubdomains {ranks};
method hierarchical;
coeffs {{ n ({x} 1 {z}); order xyz; }}
"""


def decomposition(ranks: int) -> str:
    """decomposeParDict with the most nearly square cut of x and z (y is up)."""
    z = max(n for n in range(1, int(ranks**0.5) + 1) if ranks % n == 0)
    return DECOMPOSITION.format(ranks=ranks, x=ranks // z, z=z)


def prepare(run: Run) -> None:
    """Writes the inputs of the programs and the fluid's mesh."""
    run.folder.mkdir(parents=True, exist_ok=True)
    plan_file = {"case": str(run.case), "level": run.level, "np_dem": run.np_dem, "np_foam": run.np_foam,
                 "version": version()}
    (run.folder / "run.json").write_text(json.dumps(plan_file, indent=2) + "\n")
    params = run.folder / "params.json"
    params.write_text(json.dumps(run.params, indent=2) + "\n")
    log = run.folder / "log.prepare"
    env = dict(environment(), FRAZIL_NP_DEM=str(run.np_dem), FRAZIL_NP_FOAM=str(run.np_foam))
    logged("prepare", [sys.executable, str(run.case / "prepare"), str(run.folder), str(params)], log, env=env)
    if run.np_foam:
        prepare_mesh(run, log)


def prepare_mesh(run: Run, log: Path) -> None:
    """The fluid's mesh and initial fields, cut for its ranks."""
    foam = run.folder / "foam"
    commands = ["blockMesh"] + (["setFields"] if (foam / "system/setFieldsDict").is_file() else [])
    if run.np_foam > 1:
        (foam / "system/decomposeParDict").write_text(decomposition(run.np_foam))
        commands.append("decomposePar")
    for command in commands:
        logged(command, [command, "-case", str(foam)], log, env=environment())


def mpirun_command(run: Run) -> list[str]:
    """The mpirun line of the pair, or of frazilDem alone.

    frazilDem writes to its log only, so standard output is the fluid's and goes to log.foam. Not `-screen none`: LIGGGHTS's
    mesh reader writes to the screen's file without asking whether there is one.
    A shell around each program records how it failed: mpirun's own message about that is lost now and then."""
    record = f'"$0" "$@" || {{ code=$?; echo "$0 $code" >>{EXITS}; exit $code; }}'
    dem = ["frazilDem", "-in", f"dem/in.{run.case.name}", "-log", "log.dem", "-screen", "/dev/null"]
    foam = ["frazilFoam", "-case", "foam", *(["-parallel"] if run.np_foam > 1 else [])]
    fluid = [":", "-np", str(run.np_foam), "sh", "-c", record, *foam] if run.np_foam else []
    return ["mpirun", "-np", str(run.np_dem), "sh", "-c", record, *dem, *fluid]
