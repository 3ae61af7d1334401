"""Fills a shape with a random packing: python3 -m packing OUT (--stl FILE | --polygon CORNERS --thickness T) --diameter D ..."""
import argparse
import re
import sys
from pathlib import Path

import numpy

import ice
from . import cell, shapes


def corners(text):
    """(x, z) pairs of "(x z) (x z) ..." or of any numbers in that order."""
    numbers = re.findall(r"[-+.\deE]+", text)
    if len(numbers) < 6 or len(numbers) % 2:
        raise argparse.ArgumentTypeError(f"{text!r}: three corners or more, each x and z")
    return numpy.array(numbers, float).reshape(-1, 2)


def options():
    """The words of the command line."""
    command = argparse.ArgumentParser(prog="python3 -m packing", description=sys.modules["packing"].__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_argument("out", metavar="OUT")
    shape = command.add_mutually_exclusive_group(required=True)
    shape.add_argument("--stl", metavar="FILE", help="closed surface")
    shape.add_argument("--polygon", type=corners, metavar="CORNERS", help="corners (x z) [m]; needs --thickness")
    command.add_argument("--thickness", type=float, metavar="M", help="from y = 0 upwards")
    command.add_argument("--diameter", type=float, required=True, metavar="M")
    command.add_argument("--largest", type=float, metavar="M", help="diameters from --diameter to this, evenly")
    command.add_argument("--density", type=float, default=900.0, metavar="KG/M3", help="of the spheres (900)")
    command.add_argument("--spheres", type=int, default=2000, help="of the cell that repeats (2000)")
    command.add_argument("--cell", metavar="FILE", help="a cell made before")
    command.add_argument("--seed", type=int, default=1)
    given = command.parse_args()
    if given.polygon is not None and not (given.thickness and given.thickness > 0):
        command.error("--polygon needs --thickness, above 0")
    if given.diameter <= 0 or given.density <= 0 or given.spheres < 100 or (given.largest or given.diameter) < given.diameter:
        command.error("--diameter and --density are above 0, --largest not below --diameter, --spheres 100 or more")
    return given


def main():
    """Writes spheres.data, bonds.txt and cell.csv."""
    given = options()
    out = Path(given.out)
    out.mkdir(parents=True, exist_ok=True)
    shape = (shapes.Surface(shapes.read_stl(given.stl)) if given.stl
             else shapes.Prism(given.polygon, 0.0, given.thickness))
    if given.cell:
        packed = cell.read(given.cell)
    else:
        diameters = numpy.linspace(given.diameter, given.largest or given.diameter, given.spheres)
        packed = cell.make(diameters, given.seed, out / "packing")
    packed.write(out / "cell.csv")
    points, diameters = shapes.fill(shape, packed)
    if not len(points):
        sys.exit(f"{given.stl or 'polygon'}: no sphere of {given.diameter:g} m lies inside as a whole. Smaller spheres, or a larger "
                 "shape: STL files in millimetres must be scaled to metres.")
    pairs = shapes.bonds(points, diameters)
    margin = packed.diameters.max()
    ice.write_data(out / "spheres.data", points, diameters, given.density,
                   [(low - margin, high + margin) for low, high in zip(*shape.bounds())], types=1)
    (out / "bonds.txt").write_text("".join(f"{n + 1} {m + 1}\n" for n, m in pairs))
    print(f"{len(points)} spheres, {packed.solid_fraction():.3f} solid inside, {2 * len(pairs) / len(points):.3g} bonds each: {out}")


try:
    main()
except (OSError, ValueError, RuntimeError) as error:
    sys.exit(f"packing: {error}")
