"""The study's units (J. Fluid Mech. 2026, doi 10.1017/jfm.2026.11203, section 3.1), for its scaled forms:

    c = √(E_b/ρ)   t* = t c/D0   u* = u/c   L* = L/D0   F* = F/(½ ρw c² S)   S = π D0²/4

E_b modulus of the bonds, ρ density of the spheres, ρw of the water, D0 the body's diameter.
"""
from __future__ import annotations

import math

import numpy

from .run import Run
from .surface import vertices

STUDY = {"bond_young": 0.5e9, "ice_density": 900.0}  # of its ice: a run without ice is scaled as one with it [Pa], [kg/m3]


def wave_speed(run: Run) -> float:
    """c = √(E_b/ρ) [m/s] of the run's ice."""
    young, density = (run.params.get(name, default) for name, default in STUDY.items())
    return math.sqrt(young / density)


def diameter(run: Run) -> float:
    """D0 [m]: twice the largest distance of the body's surface from the vertical line through its centre of mass at the
    start."""
    points = vertices(run)
    centre = [run.column(name).values[0] for name in ("x", "z")]
    return 2 * float(numpy.hypot(points[:, 0] - centre[0], points[:, 2] - centre[1]).max())


def time_scale(run: Run) -> float:
    """D0/c [s]."""
    return diameter(run) / wave_speed(run)


def force_scale(run: Run) -> float:
    """½ ρw c² S [N], with ρw of foam/constant/transportProperties."""
    density = run.entry("foam/constant/transportProperties", "rho")
    return 0.5 * density * wave_speed(run) ** 2 * math.pi / 4 * diameter(run) ** 2
