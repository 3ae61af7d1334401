#!/usr/bin/env python3
"""Two bodies keep their own loads, whatever the order in which script and couplingProperties define them.

Spheres `right` and `left`, mirror images of each other (x -> -x), enter water obliquely, towards each other. Asserted of
every fluid step after the first, relative to the greatest force on a body:

    mirrored    the load of `left` is the mirror image of that of `right`                      1e-6
    same        with the script's bodies in the other order: the same loads                    1e-12
    continued   a run on from the middle, by restart files of both programs                    1e-9, and not the other's

FRAZIL_BUILD names the build folder.
"""
import csv
import sys
import tempfile
from pathlib import Path

import dem_script
import pair
import surfaces
import tank_case

DIAMETER, GAP = 0.016, 0.0005
PLACE, SPEED = 0.022, (-2.0, -4.0)  # of `right`: centre's x [m]; velocity along x and y [m/s]
STEP, STEPS, SUBSTEPS = 4e-5, 24, 10
MIDDLE = STEPS // 2 * STEP
LO, HI, CELLS = (-0.06, -0.06, -0.03), (0.06, 0.03, 0.03), (32, 24, 16)

BOX = dem_script.box(LO, HI)
BODY = """
fix hull_{name} all mesh/surface/stress file {name}.stl type 1
fix {name} all body/rigid mesh hull_{name} density 500 velocity {vx} {vy} 0
"""
COUPLE = """
fix walls all wall/gran model hertz tangential history mesh n_meshes 2 meshes hull_right hull_left
fix fluid all couple/foam restart restart.*
run {steps}
"""
TIGHT = (("tolerance 1e-7; relTol 0.001; maxIter 500", "tolerance 1e-13; relTol 0; maxIter 3000"),
         ("tolerance 1e-10; relTol 1e-5; maxIter 500", "tolerance 1e-13; relTol 0; maxIter 3000"),
         ("tolerance 1e-9", "tolerance 1e-15"))


def head(start, step):
    return dem_script.head(start, sort=" sort 0 0") + f"timestep {step}\n" + dem_script.GRAVITY


def write_surfaces(folder):
    """The right sphere, and its mirror image with the corners in the other order."""
    right = surfaces.sphere(DIAMETER, (PLACE, DIAMETER / 2 + GAP, 0.0), rings=24)
    left = [tuple((-x, y, z) for x, y, z in reversed(triangle)) for triangle in right]
    for name, triangles in (("right", right), ("left", left)):
        for place in (folder, folder / "foam/constant/triSurface"):
            surfaces.write_stl(place / f"{name}.stl", triangles)


def write_script(folder, order, start=BOX, steps=STEPS):
    """frazilDem's script with the bodies in this order."""
    velocity = {"right": SPEED[0], "left": -SPEED[0]}
    bodies = "".join(BODY.format(name=name, vx=velocity[name], vy=SPEED[1]) for name in order)
    (folder / "in.two").write_text(head(start, STEP / SUBSTEPS) + bodies +
                                   COUPLE.format(steps=steps * SUBSTEPS + 1))


def write_fluid(folder):
    """frazilFoam's case: fixed time steps, tight solvers, fields written in the middle and at the end."""
    case = folder / "foam"
    bodies = " ".join(f"{name} {{ surface \"constant/triSurface/{name}.stl\"; }}" for name in ("right", "left"))
    tank_case.write_case(case, tank_case.box_mesh(LO, HI, CELLS), 0.0,
                         tank_case.control(STEPS * STEP, STEP, adjust="no", write_interval=MIDDLE), bodies)
    solution = case / "system/fvSolution"
    text = solution.read_text()
    for loose, tight in TIGHT:
        assert loose in text, loose
        text = text.replace(loose, tight)
    solution.write_text(text)
    tank_case.write(case / "constant/couplingProperties", "coarseGrid { min (-0.06 -0.06 -0.03); max (0.06 0.03 0.03); "
                    f"cellSize 0.03; }}\nbodies {{ {bodies} }}\n")


def loads(folder, order):
    """{name: [force and spin of each fluid step]} of a run whose script defines the bodies in this order.

    The spin stands for the torque, which the history does not hold."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))[2:]
    table = {}
    for prefix, name in zip(("", order[1] + "_"), order):
        table[name] = [[float(row[prefix + column]) for column in ("fluid_fx", "fluid_fy", "fluid_fz", "wx", "wy", "wz")]
                       for row in rows]
    return table


def run(folder, order):
    folder.mkdir()
    write_fluid(folder)
    write_surfaces(folder)
    write_script(folder, order)
    pair.mesh(folder, ("blockMesh", "setFields"))
    pair.launch(folder)
    return loads(folder, order)


def go_on(folder, order):
    """The same run once more from its middle."""
    (folder / "foam/system/controlDict").write_text(
        (folder / "foam/system/controlDict").read_text().replace("startTime 0", f"startTime {MIDDLE:g}"))
    write_script(folder, order, f"read_restart restart.{STEPS // 2 * SUBSTEPS}", STEPS - STEPS // 2)
    pair.launch(folder)
    return loads(folder, order)


def mirrored(rows):
    """A force changes its x, a spin (an axial vector) its y and z."""
    return [[-fx, fy, fz, wx, -wy, -wz] for fx, fy, fz, wx, wy, wz in rows]


def report(name, mine, theirs, limit):
    """Prints the largest difference of force and spin, each relative to the greatest; whether it passes."""
    worst = 0
    for columns in (slice(0, 3), slice(3, 6)):
        scale = max(abs(value) for row in theirs for value in row[columns])
        worst = max(worst, max(abs(a - b) for x, y in zip(mine, theirs) for a, b in zip(x[columns], y[columns])) / scale)
    passed = len(mine) == len(theirs) and worst <= limit
    print(f"{'PASS' if passed else 'FAIL'} {name}: {worst:.2g} (limit {limit:g})", flush=True)
    return passed


def main():
    with tempfile.TemporaryDirectory(prefix="frazil-two-bodies-") as scratch:
        orders = (("right", "left"), ("left", "right"))
        results = [run(Path(scratch) / "-".join(order), order) for order in orders]
        first, other = results
        print(f"{len(first['right'])} steps, greatest force along x "
              f"{max(abs(row[0]) for row in first['right']):.3g} N, along y {max(row[1] for row in first['right']):.3g} N")
        passed = [report("mirrored", mirrored(result["left"]), result["right"], 1e-6) for result in results]
        passed += [report(f"same, {name}", other[name], first[name], 1e-12) for name in ("right", "left")]
        again = go_on(Path(scratch) / "left-right", orders[1])
        passed += [report(f"continued, {name}", again[name], other[name], 1e-9) for name in ("right", "left")]
    sys.exit(not all(passed))


if __name__ == "__main__":
    main()
