"""The ledger: do particles, coarse grid and fine mesh hold the same volume and momentum? From ledger.csv; its columns are
in foam_coupling/doc/couplingProperties.md."""
from __future__ import annotations

import numpy

from .catalogue import Missing, series, Series, value
from .run import Run


def errors(run: Run) -> dict[str, Series]:
    """The columns of relative errors [-], by name."""
    return {name: run.column(name, "ledger") for name in run.ledger if "error" in name.lower()}


@series("largest relative error of the ledger", "")
def ledger_error(run: Run) -> Series:
    """max over the columns of relative errors, at each exchange [-]; round-off, below 1e-8, unless the program is at fault."""
    columns = [numpy.abs(found.values) for found in errors(run).values()]
    if not columns:
        raise Missing(f"{run.folder / 'ledger.csv'}: has no column of errors.")
    return Series(run.ledger["time"], numpy.max(columns, axis=0))


@series("clipped share of the solid volume", "")
def clipped_share(run: Run) -> Series:
    """volumeClipped/volumeParticles [-]: solid that the fluid does not see, because too little room would be left."""
    clipped, whole = (run.column(name, "ledger") for name in ("volumeClipped", "volumeParticles"))
    return Series(clipped.time, numpy.divide(clipped.values, whole.values, out=numpy.zeros_like(whole.values),
                                             where=whole.values > 0))


@series("dry particles", "")
def dry_particles(run: Run) -> Series:
    """Particles that find no fluid around them [-]."""
    return run.column("dryParticles", "ledger")


@series("particles lost", "")
def particles_lost(run: Run) -> Series:
    """Σ particlesLost up to each exchange [-]: left the DEM's box, or deleted."""
    lost = run.column("particlesLost", "ledger")
    return Series(lost.time, numpy.cumsum(lost.values))


@value("largest relative error of the ledger", "")
def worst_ledger_error(run: Run) -> float:
    """max over exchanges and columns [-]."""
    return ledger_error(run).peak()


@value("largest clipped share of the solid volume", "")
def worst_clipped_share(run: Run) -> float:
    """max volumeClipped/volumeParticles [-]."""
    return clipped_share(run).peak()


@value("particles lost", "")
def end_particles_lost(run: Run) -> float:
    """Number at the end [-]."""
    return particles_lost(run).last()
