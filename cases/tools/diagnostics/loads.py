"""The loads on the body, from history.csv. y is up.

Forces are those of the last DEM step of each fluid step, not means over it: a peak between two rows is not in the file.
"""
from __future__ import annotations

from .body import wetted
from .catalogue import Missing, series, Series, value
from .run import Run
from .surface import length

WET = 1e-4  # share of the body's volume in water from which on it counts as touched: less is the blur of the surface [-]


@series("contact force", "N")
def contact_force(run: Run) -> Series:
    """|F_c|, all contacts with spheres [N]."""
    return length(run, "contact_fx", "contact_fy", "contact_fz")


@series("vertical contact force", "N")
def contact_force_y(run: Run) -> Series:
    """F_cy, upwards positive [N]."""
    return run.column("contact_fy")


@series("sideways contact force", "N")
def contact_force_sideways(run: Run) -> Series:
    """√(F_cx² + F_cz²) [N]."""
    return length(run, "contact_fx", "contact_fz")


@series("vertical fluid force", "N")
def fluid_force_y(run: Run) -> Series:
    """F_hy of pressure and friction, buoyancy included, upwards positive [N]."""
    return run.column("fluid_fy")


@series("sideways fluid force", "N")
def fluid_force_sideways(run: Run) -> Series:
    """√(F_hx² + F_hz²) [N]."""
    return length(run, "fluid_fx", "fluid_fz")


@value("first contact with a sphere", "s")
def first_contact(run: Run) -> float:
    """Time of the first row with |F_c| > 0 [s]."""
    moment = contact_force(run).first_above()
    if moment is None:
        raise Missing(f"{run.folder / 'history.csv'}: no contact of the body yet.")
    return moment


@value("first touch of ice or water", "s")
def touch(run: Run) -> float:
    """Time of the first row with |F_c| > 0 or a wetted share > 1e-4 [s]: the zero of the scaled time."""
    moments = [contact_force(run).first_above(), wetted(run).first_above(WET)]
    moments = [moment for moment in moments if moment is not None]
    if not moments:
        raise Missing(f"{run.folder / 'history.csv'}: the body has touched neither ice nor water yet.")
    return min(moments)


@value("largest contact force", "N")
def peak_contact_force(run: Run) -> float:
    """max |F_c| [N]."""
    return contact_force(run).peak()


@value("largest contact force after the first contact", "s")
def peak_contact_delay(run: Run) -> float:
    """Time from the first contact to max |F_c| [s]; the study has 0.122 ms."""
    return contact_force(run).time_of_peak() - first_contact(run)


@value("largest vertical fluid force", "N")
def peak_fluid_force(run: Run) -> float:
    """max F_hy [N]."""
    return fluid_force_y(run).peak()


@value("impulse of the contacts, upwards", "N s")
def contact_impulse(run: Run) -> float:
    """∫ F_cy dt [N s], trapezoidal rule over the rows."""
    return contact_force_y(run).integral()


@value("impulse of the fluid, upwards", "N s")
def fluid_impulse(run: Run) -> float:
    """∫ F_hy dt [N s], trapezoidal rule over the rows."""
    return fluid_force_y(run).integral()
