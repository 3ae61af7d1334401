"""Motion and loads of the body in the study's units (scales.py), so that runs of other sizes and other ice compare."""
from __future__ import annotations

from . import scales
from .body import depth, speed
from .catalogue import series, Series, value
from .loads import contact_force_y, fluid_force_y, peak_contact_force
from .run import Run


def scaled(what: Series, unit: float) -> Series:
    """A series over one of the study's units."""
    return Series(what.time, what.values / unit)


@series("scaled speed u*", "")
def scaled_speed(run: Run) -> Series:
    """u* = |v|/c [-], c = √(E_b/ρ)."""
    return scaled(speed(run), scales.wave_speed(run))


@series("scaled depth L*", "")
def scaled_depth(run: Run) -> Series:
    """L* = depth/D0 [-]."""
    return scaled(depth(run), scales.diameter(run))


@series("scaled vertical contact force F*c", "")
def scaled_contact_force(run: Run) -> Series:
    """F*c = F_cy/(½ ρw c² S) [-], c = √(E_b/ρ), S = π D0²/4."""
    return scaled(contact_force_y(run), scales.force_scale(run))


@series("scaled vertical fluid force F*h", "")
def scaled_fluid_force(run: Run) -> Series:
    """F*h = F_hy/(½ ρw c² S) [-], c = √(E_b/ρ), S = π D0²/4."""
    return scaled(fluid_force_y(run), scales.force_scale(run))


@value("largest scaled contact force F*c", "")
def peak_scaled_contact_force(run: Run) -> float:
    """max |F_c|/(½ ρw c² S) [-], c = √(E_b/ρ), S = π D0²/4."""
    return peak_contact_force(run) / scales.force_scale(run)
