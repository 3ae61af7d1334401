"""Corrects the bonds by what their specimens have, until every target is met.

E is proportional to E_b and each strength to the one strength of the bonds that decides it in a lattice: a correction is target
over measured. Where a random packing answers less than in proportion (pressed, its bonds fail in tension, too), two rounds give
the exponent of the answer, and the next correction allows for it."""
from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

import lattice

from .bonds import Bonds, Sample, Targets
from .specimens import Measured, measure, strains
from .theory import asked, first_guess, shared

STRENGTHS = (lattice.BENDING, lattice.COMPRESSION, lattice.TENSION)


@dataclass(frozen=True)
class Round:
    """Bonds and what their specimens have: by load, for every seed."""
    bonds: Bonds
    specimens: dict[str, list[Measured]]

    def young(self) -> float:
        """Of the specimens in tension, where contacts take no part [Pa]."""
        return mean(one.young for one in self.specimens[lattice.TENSION])

    def strengths(self) -> dict[str, float]:
        """Mean over the seeds, by load [Pa]."""
        return {load: mean(one.strength for one in self.specimens[load]) for load in STRENGTHS}

    def errors(self, targets: Targets) -> dict[str, float]:
        """Relative, of everything that is asked for."""
        pairs = {"young": (targets.young, self.young())}
        pairs.update({load: (getattr(targets, load), value) for load, value in self.strengths().items() if getattr(targets, load)})
        return {name: value / target - 1 for name, (target, value) in pairs.items()}

    def corrected(self, targets: Targets, before: Round | None = None) -> Bonds:
        """The next bonds; before: the round before this one."""
        has = self.strengths()
        pull = asked(targets, has, lattice.BENDING, lattice.TENSION)
        press = asked(targets, has, lattice.COMPRESSION)
        factor = shared(press) ** (1 / self.answer(before)) if press else 1.0
        return self.bonds.scaled(targets.young / self.young(), shared(pull) if pull else 1.0, factor)

    def answer(self, before: Round | None) -> float:
        """d ln(strength in compression)/d ln(τc) between two rounds [-], within 0.4 to 1; 1 where τc has hardly changed."""
        steps = math.log(self.bonds.shear_strength / before.bonds.shear_strength) if before else 0.0
        if abs(steps) < 0.1:
            return 1.0
        has, had = (one.strengths()[lattice.COMPRESSION] for one in (self, before))
        return min(1.0, max(0.4, math.log(has / had) / steps))


def out_of_reach(rounds: list[Round], targets: Targets, tolerance: float) -> list[str]:
    """What the specimens could not have, a sentence each."""
    last, found = rounds[-1], []
    for load, error in last.errors(targets).items():
        if abs(error) >= tolerance:
            why = ""
            if load == lattice.COMPRESSION and len(rounds) > 1 and last.bonds.shear_strength > last.bonds.tensile_strength:
                why = ": its bonds fail in tension now, by the strength that bending or tension asks for, whatever τc is"
            found.append(f"{load}: {100 * error:+.1f} % after {len(rounds)} rounds{why}")
    return found


def expected(targets: Targets, sample: Sample, bonds: Bonds) -> dict[str, float]:
    """Strength by load [Pa]: the target, or where it is greater or there is none what the lattice has."""
    ice = lattice.Ice(sample.diameter, sample.density, bonds.young, bonds.stiffness_ratio, bonds.tensile_strength,
                      bonds.shear_strength, bonds.friction_angle)
    plate = lattice.Plate(ice, sample.layers)
    return {load: max(getattr(targets, load) or 0.0, plate.first_failure(load)[0]) for load in STRENGTHS}


def settled(before: Round, after: Round, targets: Targets, tolerance: float) -> bool:
    """Whether a further round would change nothing: all is met, or what is not cannot be."""
    errors, earlier = after.errors(targets), before.errors(targets)
    return all(abs(error) < tolerance or abs(error - earlier[name]) < 0.1 * tolerance for name, error in errors.items())


def fit(targets: Targets, sample: Sample, start: Bonds | None, options, folder: Path, say) -> list[Round]:
    """All rounds; the last one has the bonds looked for. say(round number, round) is called after each."""
    bonds = (start or first_guess(targets, sample, options.stiffness_ratio, options.friction_angle, options.weibull)).rounded()
    rounds: list[Round] = []
    while len(rounds) < options.rounds:
        strain = strains(targets, expected(targets, sample, bonds))
        one = Round(bonds, measure(bonds, sample, strain, options.seeds, folder / f"round-{len(rounds) + 1}"))
        rounds.append(one)
        say(len(rounds), one)
        if max(abs(error) for error in one.errors(targets).values()) < options.tolerance:
            break
        if len(rounds) > 1 and settled(rounds[-2], one, targets, options.tolerance):
            break
        bonds = one.corrected(targets, rounds[-2] if len(rounds) > 1 else None).rounded()
    return rounds
