"""The closed form of the endless lattice (lattice.py) as a first guess, and what no bonds can have together."""
from __future__ import annotations

import math

import lattice

from .bonds import Bonds, Sample, Targets

LARGE = 1e6   # a strength over the other one that never decides
RANDOM = 0.4  # stiffness and strengths of a random packing over those of the lattice, roughly: seven bonds in place of twelve


def plate(sample: Sample, ratio: float, tensile: float, shear: float, angle: float) -> lattice.Plate:
    """The endless plate with E_b = 1 Pa."""
    return lattice.Plate(lattice.Ice(sample.diameter, sample.density, 1.0, ratio, tensile, shear, angle), sample.layers)


def shared(wanted: list[tuple[float, float]]) -> float:
    """The one factor for several (target, value) that leaves the least of the greatest relative errors: with r = target/value
    between r1 and r2 the errors f/r - 1 are equal and opposite at f = 2 r1 r2/(r1 + r2)."""
    ratios = [target / value for target, value in wanted]
    low, high = min(ratios), max(ratios)
    return 2 * low * high / (low + high)


def asked(targets: Targets, values: dict[str, float], *loads: str) -> list[tuple[float, float]]:
    """(target, value) of those loads for which something is asked."""
    return [(getattr(targets, load), values[load]) for load in loads if getattr(targets, load)]


def first_guess(targets: Targets, sample: Sample, ratio: float, angle: float, modulus: float) -> Bonds:
    """Bonds of a perfect lattice with these bulk values, each mode of failure by itself."""
    loads = (lattice.TENSION, lattice.COMPRESSION, lattice.BENDING)
    pulled, sheared = plate(sample, ratio, 1.0, LARGE, 0.0), plate(sample, ratio, LARGE, 1.0, angle)
    by_tension = {load: pulled.first_failure(load)[0] for load in loads}
    by_shear = {load: sheared.first_failure(load)[0] for load in loads}
    pull = asked(targets, by_tension, lattice.BENDING, lattice.TENSION)
    press = asked(targets, by_shear, lattice.COMPRESSION)
    tensile, shear = shared(pull) if pull else None, shared(press) if press else None
    # Without a target for one of the strengths the study's τc/σc = 2/3
    if tensile is None and shear is None:
        tensile = shear = LARGE * targets.young
    bonds = Bonds(targets.young / pulled.young(), ratio, tensile or 1.5 * shear, shear or tensile / 1.5, angle, modulus)
    return bonds if sample.lattice() else bonds.scaled(*3 * (1 / RANDOM,))


def conflicts(targets: Targets, bonds: Bonds, sample: Sample) -> list[str]:
    """What cannot be met together, a sentence each, by the lattice's closed form with these bonds."""
    if not sample.lattice():
        return []
    found = []
    strong = lattice.Plate(lattice.Ice(sample.diameter, sample.density, bonds.young, bonds.stiffness_ratio,
                                       bonds.tensile_strength, bonds.shear_strength, bonds.friction_angle), sample.layers)
    for load in (lattice.TENSION, lattice.BENDING, lattice.COMPRESSION):
        decided = "shear" if load == lattice.COMPRESSION else "tension"
        stress, mode = strong.first_failure(load)
        target = getattr(targets, load)
        if target and mode != decided:
            found.append(f"{load}: at {target / 1e6:.3g} MPa the lattice would fail in {mode}, at {stress / 1e6:.3g} MPa, by the "
                         f"strength that {'compression' if mode == 'shear' else 'bending or tension'} asks for")
    if targets.tension and targets.bending:
        one = plate(sample, bonds.stiffness_ratio, 1.0, LARGE, 0.0)
        has = one.first_failure(lattice.BENDING)[0] / one.first_failure(lattice.TENSION)[0]
        wants = targets.bending / targets.tension
        if not math.isclose(has, wants, rel_tol=0.03):
            found.append(f"bending and tension: {wants:.3g} times as strong in bending is asked for, the lattice is {has:.3g} times "
                         "as strong with any σc and τc: σc is chosen so that both are wrong by as little as possible")
    return found
