"""What the cases share in which a specimen of ice is loaded until it breaks, frazilDem alone: ice_tension, ice_compression,
ice_bending. y is up, close-packed rows along x, the specimen is centred on the axis x = z = 0. SI units.
"""
import math

import numpy

import checks
import folder
import ice
import lattice


LATTICE = "hcp"  # the parameter `packing`; otherwise the file of a cell (packing/cell.py)
PAPER = {"E": 0.7e9, lattice.COMPRESSION: 2.56e6, lattice.BENDING: 0.81e6}  # bulk values of its ice [Pa]; no tension


class Specimen:
    """A bar of ice and its measures: columns x rows x layers spheres of the lattice, or as large a bar of a random packing."""

    def __init__(self, parameters):
        self.diameter = parameters["sphere_diameter"]
        self.columns, self.rows, self.layers = (parameters[name] for name in ("columns", "rows", "layers"))
        self.packing = parameters["packing"]
        self.length = self.diameter * self.columns
        self.thickness = ice.thickness(self.diameter, self.layers)
        self.width = self.diameter * (1 + ice.ROW * (self.rows - 1))  # over all spheres, as the thickness
        self.section = self.width * self.thickness

    def build(self):
        """Sets centres, the middle of the bar at the origin, diameters [m] and pairs to be bonded."""
        if self.packing == LATTICE:
            points = ice.plate(self.diameter, self.columns, self.rows, self.layers)
            self.points = [(x, y - 0.5 * self.thickness, z) for x, y, z in points]
            self.diameters = [self.diameter] * len(points)
            self.pairs = ice.contacts(self.points, self.diameter)
        else:
            from packing import cell, shapes
            half = 0.5 * numpy.array((self.length, self.thickness, self.width))
            try:
                packed = cell.read(self.packing)
            except (OSError, ValueError) as error:
                raise SystemExit(f"packing={self.packing}: {error}. Give {LATTICE}, or the cell.csv that python3 -m packing or "
                                 "frazil calibrate --packing random leaves.") from None
            self.points, self.diameters = shapes.fill(shapes.box(-half, half), packed)
            self.pairs = shapes.bonds(self.points, self.diameters)
        return self

    def write(self, path, density, margin, motion=None):
        """LIGGGHTS data file, with a box that leaves a margin [m] on all sides; motion(centre) gives a sphere's velocity
        [m/s] and spin [rad/s] at the start."""
        box = [(min(axis) - margin, max(axis) + margin) for axis in zip(*self.points)]
        ice.write_data(path, self.points, self.diameters, density, box, types=1)
        if motion:
            with open(path, "a") as data:
                data.write("\nVelocities\n\n")
                data.writelines("%d %.17g %.17g %.17g %.17g %.17g %.17g\n" % (n, *motion(point))
                                for n, point in enumerate(self.points, 1))

    def write_bonds(self, breaking, lasting, lasts):
        """Lists of the bonds for fix bond/parallel: those between two spheres for whose centres `lasts` is true, and
        the others, which may break."""
        with open(breaking, "w") as weak, open(lasting, "w") as strong:
            for n, m in self.pairs:
                (strong if lasts(self.points[n]) and lasts(self.points[m]) else weak).write(f"{n + 1} {m + 1}\n")


def material(parameters, stiffness_ratio):
    """The level's ice with one of its stiffness ratios."""
    return lattice.Ice(parameters["sphere_diameter"], parameters["ice_density"], parameters["bond_young"],
                       stiffness_ratio, parameters["tensile_strength"], parameters["shear_strength"],
                       parameters["friction_angle"])


def time_steps(parameters, smallest):
    """DEM step for each stiffness ratio [s]; smallest: diameter of a sphere [m]. The lattice's, which has the most bonds."""
    return [parameters["step_share"] * ice.critical_step(smallest, parameters["ice_density"], parameters["bond_young"], ratio)
            for ratio in parameters["stiffness_ratios"]]


def schedule(parameters, smallest, duration, rows):
    """Variables of the script that differ from ratio to ratio: time step, number of steps for a duration [s], the interval
    of a curve of so many rows, and the part of the run between two looks at what is left of the specimen."""
    steps = time_steps(parameters, smallest)
    count = [math.ceil(duration / step) for step in steps]
    every = [max(1, number // rows) for number in count]
    return {"stiffness_ratio": parameters["stiffness_ratios"], "time_step": steps, "steps": count,
            "part": [20 * number for number in every], "curve_every": every}


def median_of_three(values):
    """Each value's median with its neighbours; the ends repeat."""
    padded = numpy.pad(values, 1, mode="edge")
    return numpy.median((padded[:-2], values, padded[2:]), axis=0)


class Curve:
    """dem/curve_<ratio>.csv: stress [Pa] over strain [-], both positive in the direction of the load."""

    def __init__(self, run, ratio, sign=1):
        table = checks.table(run / f"dem/curve_{folder.text(ratio)}.csv")
        self.rows = {name: numpy.array(values) for name, values in table.items()}
        self.strain, self.stress = self.rows["strain"] * sign, self.rows["stress"] * sign
        self.broken = self.rows["broken_tension"] + self.rows["broken_shear"]

    def first_failure(self):
        """Stress at the last row before a bond is broken; the largest of all if none is."""
        broken = numpy.flatnonzero(self.broken)
        return self.stress[max(broken[0] - 1, 0)] if broken.size else self.stress.max()

    def strength(self):
        """(largest stress before the load falls by a tenth for the first time or a fifth of the bonds is gone, whether either
        happens: pressed, spheres of a large κ bear the load by their contacts when the bonds are gone). The stress is the median of
        three rows: the shock of a crack throws single ones up by half where the specimen is thin. It costs 0.3 % of a peak."""
        stress, bonds = median_of_three(self.stress), self.rows["bonds_intact"] + self.broken
        largest = numpy.maximum.accumulate(stress)
        failed = numpy.flatnonzero((self.broken > 0) & (stress < 0.9 * largest) | (self.broken > 0.2 * bonds))
        return (largest[failed[0]], True) if failed.size else (stress.max(), False)

    def slope(self, values):
        """Of values over strain below 0.1 %: there the contacts take less than 2 % of a pressed specimen's load."""
        elastic = (self.strain > 1e-4) & (self.strain < 1e-3) & (self.broken == 0)
        return numpy.polyfit(self.strain[elastic], values[elastic], 1)[0]

    def modulus(self):
        """E [Pa]."""
        return self.slope(self.stress)

    def poisson(self, direction="across"):
        """ν of a pulled specimen [-]: across in the plate's plane, which a plate's stiffness in bending, E h³/12(1 - ν²), depends
        on; through its thickness. From marks on an inner block (in.ice_tension)."""
        return -self.slope(self.rows[f"strain_{direction}"])


def report(run, parameters, load, limits, result, sign=1):
    """Table of all ratios, as strength.csv and on the screen, and its comparison with the endless plate's theory.

    load: of lattice.py; limits: relative, for E and for the first failure; sign: of the curves' columns."""
    columns = ("stiffness_ratio", "E", "E_theory", "first_failure", "first_failure_theory", "strength", "fails")
    lines = [",".join(columns)]
    print("  κ      E [GPa]  theory   first failure [MPa]  theory   strength [MPa]")
    for ratio in parameters["stiffness_ratios"]:
        plate = lattice.Plate(material(parameters, ratio), parameters["layers"])
        young = plate.bending_young() if load == lattice.BENDING else plate.young()
        theory, _ = plate.first_failure(load)
        curve = Curve(run, ratio, sign)
        strength, fails = curve.strength()
        row = (ratio, curve.modulus(), young, curve.first_failure(), theory, strength, int(fails))
        lines.append(",".join(f"{value:.6g}" for value in row))
        print(f"  {ratio:<5g} {row[1]/1e9:8.3f} {young/1e9:8.3f} {row[3]/1e6:14.3f} {theory/1e6:14.3f} "
              f"{'' if fails else 'over':>8} {strength/1e6:.3f}")
        if parameters["packing"] != LATTICE:
            continue  # theory is of the lattice
        result.near(f"E for κ = {ratio:g} [GPa]", row[1] / 1e9, young / 1e9, limits[0] * young / 1e9)
        result.near(f"stress at the first failure for κ = {ratio:g} [MPa]", row[3] / 1e6, theory / 1e6, limits[1] * theory / 1e6)
    strength = f"{PAPER[load] / 1e6:.3g} MPa" if load in PAPER else "not given"
    print(f"  bulk of the paper's ice: E {PAPER['E'] / 1e9:.3g} GPa, strength in {load} {strength}")
    (run / "strength.csv").write_text("\n".join(lines) + "\n")


def report_poisson(run, parameters, result):
    """Poisson's ratio of a pulled specimen for each ratio, on the screen and against the endless plate's theory.

    Tolerance: the spheres at a free side have lost a third of their bonds, so that their strain across is wrong by up to a third
    of the largest ν, 1/3. Beside each mark there is one row of them, D/width of the bar."""
    limit = parameters["sphere_diameter"] / Specimen(parameters).width / 9
    print("  κ      ν in the plane  theory   ν through the thickness")
    for ratio in parameters["stiffness_ratios"]:
        curve, theory = Curve(run, ratio), lattice.Plate(material(parameters, ratio), parameters["layers"]).poisson()
        print(f"  {ratio:<5g} {curve.poisson():14.4f} {theory:9.4f} {curve.poisson('through'):12.4f}")
        if parameters["packing"] == LATTICE:
            result.near(f"Poisson's ratio for κ = {ratio:g}", curve.poisson(), theory, limit)
