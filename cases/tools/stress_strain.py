"""A figure of a specimen that was loaded until it broke: stress_strain.py RUNFOLDER OUT.png

Left the curves, one per stiffness ratio κ, dashed with the slope that theory gives; then modulus, and stress at the first
failure with the strength, over κ: points measured, line theory, dotted the bulk values of the paper's ice.
"""
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy
from matplotlib import pyplot

import checks
import folder
import lattice
from specimen import PAPER, Curve, material

LOADS = {"ice_tension": lattice.TENSION, "ice_compression": lattice.COMPRESSION, "ice_bending": lattice.BENDING}


def curves(axis, run, table, sign):
    """Stress over strain."""
    for ratio, young in zip(table["stiffness_ratio"], table["E_theory"]):
        curve = Curve(run, ratio, sign)
        line, = axis.plot(100 * curve.strain, curve.stress / 1e6, label=f"κ = {ratio:g}", linewidth=1.2)
        reach = numpy.array([0, curve.strength()[0] / young])
        axis.plot(100 * reach, young * reach / 1e6, color=line.get_color(), linewidth=0.8, linestyle="--")
    axis.set(xlabel="strain [%]", ylabel="stress [MPa]", xlim=(0, None), ylim=(0, None))
    axis.legend(frameon=False)


def over_ratio(axis, table, theory, measured, label, bulk):
    """Measured columns and theory(κ) over κ, in `label`'s unit."""
    ratios = numpy.linspace(1, 5, 41)
    axis.plot(ratios, [theory(ratio) for ratio in ratios], color="0.4", linewidth=1, label="theory")
    for name, values, marker in measured:
        axis.plot(table["stiffness_ratio"], values, marker, label=name, fillstyle="none")
    if bulk:
        axis.axhline(bulk, color="0.4", linestyle=":", label="bulk, paper")
    axis.set(xlabel="stiffness ratio κ", ylabel=label, ylim=(0, None))
    axis.legend(frameon=False, loc="lower right")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: stress_strain.py RUNFOLDER OUT.png")
    run = Path(sys.argv[1])
    parameters, table = json.loads((run / "params.json").read_text()), checks.table(run / "strength.csv")
    load = LOADS[Path(json.loads((run / "run.json").read_text())["case"]).name]
    plate = lambda ratio: lattice.Plate(material(parameters, ratio), parameters["layers"])
    young = lambda ratio: plate(ratio).bending_young() if load == lattice.BENDING else plate(ratio).young()
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 3.8), layout="constrained")
    curves(axes[0], run, table, -1 if load == lattice.COMPRESSION else 1)
    scaled = lambda name, unit: [value / unit for value in table[name]]
    over_ratio(axes[1], table, lambda ratio: young(ratio) / 1e9, [("measured", scaled("E", 1e9), "o")], "E [GPa]",
               PAPER["E"] / 1e9)
    over_ratio(axes[2], table, lambda ratio: plate(ratio).first_failure(load)[0] / 1e6,
               [("first failure", scaled("first_failure", 1e6), "o"), ("strength", scaled("strength", 1e6), "x")],
               "stress [MPa]", PAPER.get(load, 0) / 1e6)
    figure.savefig(sys.argv[2], dpi=120)


main()
