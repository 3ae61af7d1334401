"""The ice: broken bonds, loss, fragments, cracks. From history.csv, dem/bonds.csv (events) and particles.h5. y is up."""
from __future__ import annotations

from dataclasses import dataclass

import numpy

from .catalogue import Missing, series, Series, value
from .run import Run


@series("bonds broken in tension", "")
def broken_tension(run: Run) -> Series:
    """Number of bonds broken because σ > σ_c [-]."""
    return run.column("broken_tension")


@series("bonds broken in shear", "")
def broken_shear(run: Run) -> Series:
    """Number of bonds broken because τ > τ_c [-]."""
    return run.column("broken_shear")


@series("broken share of the bonds", "")
def broken_share(run: Run) -> Series:
    """(tension + shear)/(intact + tension + shear) [-]."""
    intact = run.column("bonds_intact")
    broken = broken_tension(run).values + broken_shear(run).values
    return Series(intact.time, broken / (intact.values + broken))


@series("loss of the ice, 1 - η", "")
def loss(run: Run) -> Series:
    """1 - η [-], η: volume of the largest fragment over that of the ice at the start (the study, section 4.2.3)."""
    eta = run.column("eta")
    return Series(eta.time, 1 - eta.values)


@value("bonds broken in tension", "")
def end_broken_tension(run: Run) -> float:
    """Number at the end [-]."""
    return broken_tension(run).last()


@value("bonds broken in shear", "")
def end_broken_shear(run: Run) -> float:
    """Number at the end [-]."""
    return broken_shear(run).last()


@value("broken share of the bonds", "")
def end_broken_share(run: Run) -> float:
    """(tension + shear)/all at the end [-]."""
    return broken_share(run).last()


@value("loss of the ice, 1 - η", "")
def end_loss(run: Run) -> float:
    """1 - η at the end [-]; the study has 0.739."""
    return loss(run).last()


@dataclass(frozen=True)
class Fragments:
    """The pieces of one snapshot, the largest first: spheres and volume [m3] of each."""

    time: float
    spheres: numpy.ndarray
    volume: numpy.ndarray

    def share_of_smaller(self) -> tuple[numpy.ndarray, numpy.ndarray]:
        """(n, share of the volume in pieces of at most n spheres), n rising."""
        order = numpy.argsort(self.spheres, kind="stable")
        return self.spheres[order], numpy.cumsum(self.volume[order]) / self.volume.sum()


def fragments(run: Run, n: int = -1) -> Fragments:
    """Pieces that intact bonds hold together, in snapshot n: spheres with one `fragment` (compute fragment; 0 is outside of
    its group), volume Σ 4/3 π R³."""
    radius, fragment = run.particles.read(n, "radius", "fragment")
    inside = fragment > 0
    _, place, spheres = numpy.unique(fragment[inside], return_inverse=True, return_counts=True)
    volume = numpy.bincount(place, weights=4 / 3 * numpy.pi * radius[inside] ** 3)
    order = numpy.argsort(-volume, kind="stable")
    return Fragments(float(run.particles.times[n]), spheres[order], volume[order])


@series("pieces", "")
def pieces(run: Run) -> Series:
    """Number of fragments in each snapshot [-]."""
    return Series(run.particles.times, numpy.array([len(fragments(run, n).spheres) for n in range(len(run.particles.steps))]))


@value("pieces at the end", "")
def end_pieces(run: Run) -> float:
    """Number of fragments in the last snapshot [-]."""
    return float(len(fragments(run).spheres))


@value("share of the ice in single spheres", "")
def crushed_share(run: Run) -> float:
    """Volume of fragments of one sphere over that of all, in the last snapshot [-]."""
    last = fragments(run)
    return float(last.volume[last.spheres == 1].sum() / last.volume.sum())


@dataclass(frozen=True)
class Cracks:
    """Broken bonds: time [s]; centre [m], direction (unit vector) and length [m] of each in the unbroken ice."""

    time: numpy.ndarray
    place: numpy.ndarray
    normal: numpy.ndarray
    length: numpy.ndarray


def cracks(run: Run) -> Cracks:
    """Every broken bond, where it was in the ice at the first snapshot, so that a crack keeps its form while the pieces
    move: centre ½(x1 + x2), direction and length of x2 - x1. The crack's face is the disc across the bond."""
    events = run.events
    if not len(events["time"]):
        raise Missing(f"{run.folder / 'dem/bonds.csv'}: no bond has broken yet.")
    ids, position = run.particles.read(0, "id", "position")
    first, second = (position[numpy.searchsorted(ids, events[name])] for name in ("id1", "id2"))
    length = numpy.linalg.norm(second - first, axis=1)
    return Cracks(events["time"], 0.5 * (first + second), (second - first) / length[:, None], length)


@series("radius of the cracks", "m")
def crack_radius(run: Run) -> Series:
    """Largest distance from the vertical axis x = z = 0 of a bond broken so far [m]; the cracks' way through the plane."""
    found = cracks(run)
    return Series(found.time, numpy.maximum.accumulate(numpy.hypot(found.place[:, 0], found.place[:, 2])))


@value("radius of the cracks at the end", "m")
def end_crack_radius(run: Run) -> float:
    """Largest distance of a broken bond from the axis x = z = 0 [m]."""
    return crack_radius(run).last()
