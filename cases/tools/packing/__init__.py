"""Ice beyond the lattice: random dense packings of equal or graded spheres in any shape.

LIGGGHTS itself makes a cell that repeats in space (cell.py): spheres without friction in a periodic box that shrinks until they
carry a pressure, then come to rest; their diameters are reduced by the largest overlap, some parts in a thousand, so that
nothing is stressed when bonds are made. A shape (shapes.py) is filled with copies of the cell, and the spheres that lie inside as
a whole are kept. Bonds join neighbours with a gap of at most GAP of their mean radius.

    python3 -m packing OUT --polygon "(-0.06 -0.04) (0.06 -0.04) (0 0.07)" --thickness 0.016 --diameter 0.0024
    python3 -m packing OUT --stl ridge.stl --diameter 0.002 --largest 0.003

leaves OUT/spheres.data (LIGGGHTS data file), OUT/bonds.txt (for fix bond/parallel ... list) and OUT/cell.csv. SI units.
"""
