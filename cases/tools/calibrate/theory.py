"""The closed form of the endless lattice (lattice.py), or what random packings have been seen to have, as a first guess and for the
change with κ; and what no bonds can have together."""
from __future__ import annotations

import math

import lattice
from launcher.say import Failure

from .bonds import Bonds, Sample, Targets

LARGE = 1e6   # a strength over the other one that never decides
RATIOS = (1.0, 50.0)  # κ is looked for between them: at 1 the lattice has ν = 0, at 50 all but 0.015 of the 1/3 that it tends to
LEAST = 0.02  # ν that can be asked for: the specimens measure it to 0.0002, one per cent of this
SPREAD = 0.03  # ν of a random packing may differ by so much from the lattice's with the same κ
# A random packing, as its specimens of 8 layers have it: E over E_b, strength over σc, in compression over τc are c κ^n. (c, n):
RANDOM = {"young": (0.68, -0.37), lattice.TENSION: (0.42, -0.18), lattice.BENDING: (0.42, -0.18), lattice.COMPRESSION: (0.7, 0.35)}
SHARE = 0.25  # no strength of a random packing is greater than this times the lattice's: seven bonds in place of twelve


def plate(sample: Sample, ratio: float, tensile: float, shear: float, angle: float) -> lattice.Plate:
    """The endless plate with E_b = 1 Pa."""
    return lattice.Plate(lattice.Ice(sample.diameter, sample.density, 1.0, ratio, tensile, shear, angle), sample.layers)


def poisson(sample: Sample, ratio: float) -> float:
    """ν of the lattice in the plate's plane [-]."""
    return plate(sample, ratio, LARGE, LARGE, 0.0).poisson()


def ratio_for(value: float, sample: Sample) -> float:
    """κ with which the lattice has this ν, which rises with κ; the nearer end of RATIOS where none of them has it."""
    from scipy.optimize import brentq
    low, high = (poisson(sample, ratio) for ratio in RATIOS)
    if not low < value < high:
        return RATIOS[0] if value <= low else RATIOS[1]
    return brentq(lambda ratio: poisson(sample, ratio) - value, *RATIOS, rtol=1e-6)


def reachable(sample: Sample) -> tuple[float, float]:
    """Least and largest ν that can be asked for [-]: κ in RATIOS may give it, and a specimen can tell it from 0."""
    low, high = (poisson(sample, ratio) for ratio in RATIOS)
    return max(low, LEAST), high if sample.lattice() else high + SPREAD


def first_ratio(value: float, sample: Sample) -> float:
    """κ of the lattice with this ν; Failure where it is out of reach."""
    low, high = reachable(sample)
    if not low <= value <= high:
        raise Failure(f"--poisson {value:g}: bonds with kn/ks from {RATIOS[0]:g} to {RATIOS[1]:g} give the {sample.layers} layers "
                      f"ν from {low:.3f} to {'' if sample.lattice() else 'about '}{high:.3f}; give a number between.")
    return ratio_for(value, sample)


def per_bond(sample: Sample, ratio: float, angle: float) -> dict[str, float]:
    """E over E_b, strength in tension and bending over σc, in compression over τc [-]: of the lattice, each mode of failure by
    itself, or of a random packing, roughly."""
    if not sample.lattice():
        return {name: factor * ratio**power for name, (factor, power) in RANDOM.items()}
    pulled, pressed = plate(sample, ratio, 1.0, LARGE, 0.0), plate(sample, ratio, LARGE, 1.0, angle)
    return {"young": pulled.young(), lattice.COMPRESSION: pressed.first_failure(lattice.COMPRESSION)[0],
            **{load: pulled.first_failure(load)[0] for load in (lattice.TENSION, lattice.BENDING)}}


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
    """Bonds with these bulk values, each mode of failure by itself."""
    has = per_bond(sample, ratio, angle)
    pull, press = asked(targets, has, lattice.BENDING, lattice.TENSION), asked(targets, has, lattice.COMPRESSION)
    tensile, shear = shared(pull) if pull else None, shared(press) if press else None
    # Without a target for one of the strengths the study's τc/σc = 2/3
    if tensile is None and shear is None:
        tensile = shear = LARGE * targets.young
    return Bonds(targets.young / has["young"], ratio, tensile or 1.5 * shear, shear or tensile / 1.5, angle, modulus)


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
