"""Corrects the bonds by what their specimens have, until every target is met.

ν depends on κ alone: the next κ is that with which the lattice's ν differs by what is missing, and E and the strengths are
expected to change with κ as in theory.py. Then E is proportional to E_b and each strength to the one strength of the bonds that
decides it in a lattice: a correction is target over measured. Where a random packing answers less than in proportion (pressed, its
bonds fail in tension, too), two rounds give the exponent of the answer, and the next correction allows for it; likewise for its ν."""
from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

import lattice

from .bonds import Bonds, Sample, Targets
from .specimens import Measured, measure, strains
from .theory import asked, per_bond, poisson, ratio_for, RATIOS, SHARE, shared

STRENGTHS = (lattice.BENDING, lattice.COMPRESSION, lattice.TENSION)


@dataclass(frozen=True)
class Round:
    """Bonds and what their specimens have: by load, for every seed."""
    bonds: Bonds
    specimens: dict[str, list[Measured]]

    def young(self) -> float:
        """Of the specimens in tension, where contacts take no part [Pa]."""
        return mean(one.young for one in self.specimens[lattice.TENSION])

    def poisson(self) -> float:
        """Of the specimens in tension, in the plate's plane [-]."""
        return mean(one.poisson for one in self.specimens[lattice.TENSION])

    def strengths(self) -> dict[str, float]:
        """Mean over the seeds, by load [Pa]."""
        return {load: mean(one.strength for one in self.specimens[load]) for load in STRENGTHS}

    def errors(self, targets: Targets) -> dict[str, float]:
        """Relative, of everything that is asked for."""
        pairs = {"young": (targets.young, self.young())}
        if targets.poisson:
            pairs["poisson"] = (targets.poisson, self.poisson())
        pairs.update({load: (getattr(targets, load), value) for load, value in self.strengths().items() if getattr(targets, load)})
        return {name: value / target - 1 for name, (target, value) in pairs.items()}

    def with_ratio(self, ratio: float, sample: Sample) -> dict[str, float]:
        """E and strengths expected of these bonds with another κ [Pa]: they change with it as theory's."""
        now, then = (per_bond(sample, each, self.bonds.friction_angle) for each in (self.bonds.stiffness_ratio, ratio))
        return {name: value * then[name] / now[name] for name, value in {"young": self.young(), **self.strengths()}.items()}

    def corrected(self, targets: Targets, sample: Sample, before: Round | None = None) -> Bonds:
        """The next bonds; before: the round before this one."""
        ratio = self.next_ratio(targets.poisson, sample, before) if targets.poisson else self.bonds.stiffness_ratio
        has = self.with_ratio(ratio, sample)
        pull = asked(targets, has, lattice.BENDING, lattice.TENSION)
        press = asked(targets, has, lattice.COMPRESSION)
        answer = self.answer(sample, before)
        factor = shared(press) ** (1 / answer) if press and answer else 1.0
        return self.bonds.with_ratio(ratio).scaled(targets.young / has["young"], shared(pull) if pull else 1.0, factor)

    def next_ratio(self, target: float, sample: Sample, before: Round | None) -> float:
        """The next κ, by the lattice's ν. The measured one rises as fast as that or, where two rounds differ enough for a secant,
        0.5 to 2 times as fast."""
        theory, rise = poisson(sample, self.bonds.stiffness_ratio), 1.0
        step = theory - poisson(sample, before.bonds.stiffness_ratio) if before else 0.0
        if abs(step) > 0.003:
            rise = min(2.0, max(0.5, (self.poisson() - before.poisson()) / step))
        return ratio_for(theory + (target - self.poisson()) / rise, sample)

    def answer(self, sample: Sample, before: Round | None) -> float:
        """d ln(strength in compression)/d ln(τc) between two rounds [-], within 0.4 to 1; 1 where τc has hardly changed, 0 where
        the strength has not answered."""
        steps = math.log(self.bonds.shear_strength / before.bonds.shear_strength) if before else 0.0
        if abs(steps) < 0.1:
            return 1.0
        has, had = (one.with_ratio(self.bonds.stiffness_ratio, sample)[lattice.COMPRESSION] for one in (self, before))
        rise = math.log(has / had) / steps
        return min(1.0, max(0.4, rise)) if rise > 0.1 else 0.0


def nearest(rounds: list[Round], targets: Targets, tolerance: float) -> Round:
    """The round that misses the fewest targets; of several the one whose largest error is the least."""
    errors = lambda one: [abs(error) for error in one.errors(targets).values()]
    return min(rounds, key=lambda one: (sum(error >= tolerance for error in errors(one)), max(errors(one))))


def out_of_reach(rounds: list[Round], targets: Targets, sample: Sample, tolerance: float) -> list[str]:
    """What the specimens could not have, a sentence each."""
    best, found = nearest(rounds, targets, tolerance), []
    unanswered = any(after.answer(sample, before) == 0 for before, after in zip(rounds, rounds[1:]))
    for load, error in best.errors(targets).items():
        if abs(error) >= tolerance:
            why = ""
            if load == lattice.COMPRESSION and (unanswered or best.bonds.shear_strength > best.bonds.tensile_strength):
                why = ": its bonds fail in tension now, by the strength that bending or tension asks for, whatever τc is"
            if load == "poisson" and best.bonds.stiffness_ratio in RATIOS:
                why = f": κ is at the end of its range, {RATIOS[0]:g} to {RATIOS[1]:g}"
            found.append(f"{load}: {100 * error:+.1f} % after {len(rounds)} rounds{why}")
    return found


def expected(targets: Targets, sample: Sample, bonds: Bonds) -> dict[str, float]:
    """Strength by load [Pa]: the target, or where it is greater or there is none what the lattice has, or a random packing's share
    of it."""
    ice = lattice.Ice(sample.diameter, sample.density, bonds.young, bonds.stiffness_ratio, bonds.tensile_strength,
                      bonds.shear_strength, bonds.friction_angle)
    plate, share = lattice.Plate(ice, sample.layers), 1.0 if sample.lattice() else SHARE
    return {load: max(getattr(targets, load) or 0.0, share * plate.first_failure(load)[0]) for load in STRENGTHS}


def settled(before: Round, after: Round, targets: Targets, tolerance: float) -> bool:
    """Whether a further round would change nothing: all is met, or what is not cannot be."""
    errors, earlier = after.errors(targets), before.errors(targets)
    return all(abs(error) < tolerance or abs(error - earlier[name]) < 0.1 * tolerance for name, error in errors.items())


def fit(targets: Targets, sample: Sample, start: Bonds, options, folder: Path, say) -> list[Round]:
    """All rounds; if all targets can be met, the last one has them. say(round number, round) is called after each."""
    bonds = start.rounded()
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
        bonds = one.corrected(targets, sample, rounds[-2] if len(rounds) > 1 else None).rounded()
    return rounds
