"""`frazil calibrate`: from the options to the lines for the script."""
from __future__ import annotations

import argparse
import os
import time
from pathlib import Path

from launcher import places
from launcher.environment import environment
from launcher.run import free_folder
from launcher.say import clock, Failure

from . import result
from .bonds import Sample, Targets
from .fit import fit, nearest, out_of_reach, Round
from .options import checked
from .theory import conflicts, first_guess, first_ratio

STUDY_RATIO = 2.66  # κ where neither it nor ν is given


def sample_of(options: argparse.Namespace, folder: Path) -> Sample:
    """What the specimens are made of; a random packing is made here, in the folder."""
    if options.packing == "hcp":
        return Sample(options.diameter, options.density, options.layers)
    import numpy

    from packing import cell
    diameters = numpy.linspace(options.diameter, options.largest or options.diameter, options.spheres)
    os.environ.update(environment())
    packed = cell.make(diameters, 1, folder / "packing")
    packed.write(folder / "cell.csv")
    print(f"cell of {options.spheres} spheres, {packed.solid_fraction():.3f} solid, side {packed.side:.4g} m", flush=True)
    return Sample(options.diameter, options.density, options.layers, str(folder / "cell.csv"))


def ratio_of(options: argparse.Namespace) -> float:
    """κ of the first round: given, or the lattice's with the ν asked for. Failure where that is out of reach."""
    if options.poisson is None:
        return options.stiffness_ratio or STUDY_RATIO
    return first_ratio(options.poisson, Sample(options.diameter, options.density, options.layers, options.packing))


def calibrate(options: argparse.Namespace) -> int:
    """Finds the bonds; status 0 if every target is met within the tolerance."""
    checked(options)
    targets = Targets(options.young, options.bending, options.compression, options.tension, options.poisson)
    ratio = ratio_of(options)
    folder = Path(options.out).resolve() if options.out else free_folder(places.TOP / "runs/calibration")
    if folder.exists() and any(folder.iterdir()):
        raise Failure(f"{folder} holds something already; choose another --out or remove it.")
    sample = sample_of(options, folder)
    start = first_guess(targets, sample, ratio, options.friction_angle, options.weibull)
    impossible = conflicts(targets, start, sample)
    for sentence in impossible:
        print(f"cannot be met together: {sentence}", flush=True)
    begin = time.monotonic()

    def say(number: int, one: Round) -> None:
        print(f"round {number}, {clock(time.monotonic() - begin)}: E_b {one.bonds.young:.4g} Pa, κ "
              f"{one.bonds.stiffness_ratio:.4g}, σc {one.bonds.tensile_strength:.4g} Pa, τc {one.bonds.shear_strength:.4g} Pa")
        print(result.table_text(result.rows(targets, one)), flush=True)

    rounds = fit(targets, sample, start, options, folder, say)
    best, missed = nearest(rounds, targets, options.tolerance), out_of_reach(rounds, targets, sample, options.tolerance)
    for sentence in missed:
        print(f"not met, round {rounds.index(best) + 1} is the nearest: {sentence}", flush=True)
    result.write(folder / "calibration.json", targets, rounds, best, impossible + missed, time.monotonic() - begin)
    print(f"\n{best.bonds.script()}\n\nspecimens and calibration.json: {folder}")
    return 1 if missed else 0
