"""The options of `frazil calibrate` and what they may be. Imports nothing that a bare machine lacks."""
from __future__ import annotations

import argparse
import math

from launcher.say import Failure


def add_options(command: argparse.ArgumentParser) -> None:
    """The options; stresses in Pa, angles in degrees."""
    number = command.add_argument
    number("--young", type=float, required=True, metavar="PA", help="modulus of the ice in tension")
    number("--bending", type=float, metavar="PA", help="its strength in three-point bending")
    number("--compression", type=float, metavar="PA", help="its strength in compression")
    number("--tension", type=float, metavar="PA", help="its strength in tension")
    number("--diameter", type=float, default=0.0024, metavar="M", help="of the spheres (0.0024)")
    number("--layers", type=int, default=8, help="of spheres through the ice (8)")
    number("--poisson", type=float, metavar="NU", help="its Poisson's ratio in the plane, by which kn/ks is found")
    number("--density", type=float, default=900.0, metavar="KG/M3", help="of the spheres (900)")
    number("--stiffness-ratio", type=float, metavar="K", help="of the bonds, kn/ks, in place of --poisson (2.66)")
    number("--friction-angle", type=float, default=0.0, metavar="DEG", help="of the bonds (0)")
    number("--weibull", type=float, default=0.0, metavar="M", help="modulus of the scatter of the bonds' strengths (0: none)")
    number("--seeds", type=int, default=1, help="specimens per load, each with other strengths (1)")
    number("--packing", default="hcp", choices=("hcp", "random"), help="of the spheres: a lattice (default) or a random one")
    number("--largest", type=float, metavar="M", help="of the spheres of a random packing: diameters from --diameter to this")
    number("--spheres", type=int, default=2000, help="of the cell that the random packing repeats (2000)")
    number("--tolerance", type=float, default=0.02, help="largest relative error at which the search ends (0.02)")
    number("--rounds", type=int, default=5, help="at most so many (5)")
    number("--out", metavar="DIR", help="folder of the specimens (default: a new one in runs/)")


def refuse(key: str, value: object, problem: str) -> None:
    """An option that cannot be."""
    raise Failure(f"--{key} {value}: {problem}")


def checked(options: argparse.Namespace) -> None:
    """Numbers finite and in their ranges; Failure names the option."""
    for key in ("young", "bending", "compression", "tension", "diameter", "density", "poisson", "stiffness_ratio", "tolerance"):
        value = getattr(options, key)
        if value is not None and not (math.isfinite(value) and value > 0):
            refuse(key.replace("_", "-"), value, "give a number above 0.")
    for key in ("layers", "seeds", "rounds"):
        if getattr(options, key) < 1:
            refuse(key, getattr(options, key), "give 1 or more.")
    if options.poisson and options.stiffness_ratio:
        refuse("poisson", options.poisson, "the bonds' kn/ks is found by it; leave out --stiffness-ratio.")
    if not 0 <= options.friction_angle < 90:
        refuse("friction-angle", options.friction_angle, "give 0 or more, below 90 degrees.")
    if not (math.isfinite(options.weibull) and options.weibull >= 0):
        refuse("weibull", options.weibull, "give a modulus above 0, or 0 for equal strengths.")
    if options.seeds > 1 and not options.weibull:
        refuse("seeds", options.seeds, "without --weibull all specimens are the same.")
    if not (options.bending or options.compression or options.tension):
        raise Failure("give at least one strength: --bending, --compression or --tension.")
    if options.spheres < 100:
        refuse("spheres", options.spheres, "a cell of fewer than 100 spheres is no packing.")
    if options.largest is not None and not options.diameter <= options.largest <= 3 * options.diameter:
        refuse("largest", options.largest, "give a number from --diameter to three times that.")
    if options.largest and options.packing == "hcp":
        refuse("largest", options.largest, "the spheres of a lattice are equal; add --packing random.")
