"""The body: motion and loads, from history.csv. y is up and the still surface is at y = 0; a load is one on the body.

Forces are those of the last DEM step of each fluid step, not means over it: a peak between two rows is not in the file.
"""
from __future__ import annotations

import numpy

from . import scales
from .catalogue import Missing, series, Series, value
from .run import Run
from .surface import motion, placed, poses, vertices

WET = 1e-4  # share of the body's volume in water from which on it counts as touched: less is the blur of the surface [-]


def length(run: Run, *names: str) -> Series:
    """Magnitude √(a² + b² + ...) of columns of the history."""
    return Series(run.column(names[0]).time, numpy.linalg.norm(motion(run, *names), axis=1))


def scaled(what: Series, unit: float) -> Series:
    """A series over one of the study's units."""
    return Series(what.time, what.values / unit)


@series("speed", "m/s")
def speed(run: Run) -> Series:
    """|v| of the centre of mass [m/s]."""
    return length(run, "vx", "vy", "vz")


@series("depth of the lowest point", "m")
def depth(run: Run) -> Series:
    """-min y over the body's surface [m]: how far its lowest point is below the still surface; negative above."""
    centre, attitude = poses(run)
    points = vertices(run)
    lowest = [placed(points, centre, attitude, row)[:, 1].min() for row in range(len(centre))]
    return Series(run.column("y").time, -numpy.array(lowest))


@series("drift off the axis", "m")
def drift(run: Run) -> Series:
    """√((x - x0)² + (z - z0)²) of the centre of mass [m]."""
    time, across = run.column("x").time, motion(run, "x", "z")
    return Series(time, numpy.linalg.norm(across - across[0], axis=1))


@series("tilt", "°")
def tilt(run: Run) -> Series:
    """Angle between the body's axis, vertical at the start, and the vertical [°]: arccos R_yy of its rotation R."""
    _, attitude = poses(run)
    upright = numpy.array([rotation[1, 1] for rotation in attitude])
    return Series(run.column("wx").time, numpy.degrees(numpy.arccos(numpy.clip(upright, -1, 1))))


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


@series("wetted share of the body's volume", "")
def wetted(run: Run) -> Series:
    """Volume of the body in water over its volume [-]."""
    return run.column("wetted")


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


@value("largest scaled contact force F*c", "")
def peak_scaled_contact_force(run: Run) -> float:
    """max |F_c|/(½ ρw c² S) [-], c = √(E_b/ρ), S = π D0²/4."""
    return peak_contact_force(run) / scales.force_scale(run)


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


@value("speed at the end", "m/s")
def end_speed(run: Run) -> float:
    """|v| in the last row [m/s]."""
    return speed(run).last()


@value("speed lost", "m/s")
def speed_lost(run: Run) -> float:
    """|v| in the first row less that in the last [m/s]."""
    return float(speed(run).values[0]) - end_speed(run)


@value("depth of the lowest point at the end", "m")
def end_depth(run: Run) -> float:
    """Depth in the last row [m]."""
    return depth(run).last()


@value("tilt at the end", "°")
def end_tilt(run: Run) -> float:
    """Tilt in the last row [°]."""
    return tilt(run).last()
