"""The three specimens with given bonds, as `frazil run` runs them, as many side by side as there are cores."""
from __future__ import annotations

import argparse
import json
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import lattice
from launcher.failure import failure_text
from launcher.run import plan, prepare
from launcher.say import Failure
from launcher.watch import start_programs
from specimen import Curve, Specimen

from .bonds import Bonds, Sample, Targets

CASES = {lattice.TENSION: "ice_tension", lattice.COMPRESSION: "ice_compression", lattice.BENDING: "ice_bending"}
REACH = 1.6   # the load goes on to so many times the strength that is expected
SHEARING = 1.25  # deflection of a beam over that by bending alone, and a margin


@dataclass(frozen=True)
class Measured:
    """Of one specimen: E [Pa], strength [Pa], the largest load if it did not fail; pulled, its ν in the plate's plane and through
    the thickness [-]."""
    young: float
    strength: float
    fails: bool
    poisson: float | None = None
    poisson_through: float | None = None


def strains(targets: Targets, expected: dict[str, float]) -> dict[str, float]:
    """Strain [-] at which each load surely has broken the specimen."""
    return {load: REACH * expected[load] / targets.young for load in CASES}


def settings(load: str, bonds: Bonds, sample: Sample, strain: float, seed: int) -> dict:
    """Parameters of the case."""
    words = {"sphere_diameter": sample.diameter, "ice_density": sample.density, "layers": sample.layers,
             "bond_young": bonds.young, "stiffness_ratios": [bonds.stiffness_ratio],
             "tensile_strength": bonds.tensile_strength, "shear_strength": bonds.shear_strength,
             "friction_angle": bonds.friction_angle, "weibull_modulus": bonds.weibull_modulus, "weibull_seed": seed, "packing": sample.packing}
    if load == lattice.BENDING:
        half_span = 24 * sample.diameter  # of ice_bending
        thickness = Specimen({**words, "columns": 1, "rows": 1}).thickness
        words["largest_deflection"] = SHEARING * strain * (2 * half_span)**2 / (6 * thickness)
    else:
        words["largest_strain"] = strain
    return words


def carry_out(load: str, words: dict, folder: Path) -> Measured:
    """Runs one specimen. Failure if frazilDem ends with an error."""
    given = [f"{name}={json.dumps(value)}" for name, value in words.items()]
    run = plan(argparse.Namespace(case=CASES[load], level=None, out=str(folder), set=given, np_dem=1, np_foam=None))
    prepare(run)
    process = start_programs(run)
    try:
        if process.wait():
            raise Failure(failure_text(run))
    finally:
        process.terminate()
    curve = Curve(run.folder, words["stiffness_ratios"][0], -1 if load == lattice.COMPRESSION else 1)
    lateral = (curve.poisson(), curve.poisson("through")) if load == lattice.TENSION else ()
    return Measured(curve.modulus(), *curve.strength(), *lateral)


def measure(bonds: Bonds, sample: Sample, strain: dict[str, float], seeds: int, folder: Path) -> dict[str, list[Measured]]:
    """All specimens with these bonds, each load with every seed."""
    os.environ.setdefault("OMPI_MCA_hwloc_base_binding_policy", "none")  # else all share the first core
    with ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as cores:
        work = {(load, seed): cores.submit(carry_out, load, settings(load, bonds, sample, strain[load], seed),
                                           folder / f"{load}-{seed}")
                for load in (lattice.BENDING, lattice.COMPRESSION, lattice.TENSION) for seed in range(1, seeds + 1)}
        return {load: [work[load, seed].result() for seed in range(1, seeds + 1)] for load in CASES}
