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
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/verification"))
import body_case

BUILD = Path(os.environ.get("FRAZIL_BUILD", ROOT / "build"))
DIAMETER, GAP = 0.016, 0.0005
PLACE, SPEED = 0.022, (-2.0, -4.0)  # of `right`: centre's x [m]; velocity along x and y [m/s]
STEP, STEPS, SUBSTEPS = 4e-5, 24, 10
MIDDLE = STEPS // 2 * STEP
LO, HI, CELLS = (-0.06, -0.06, -0.03), (0.06, 0.03, 0.03), (32, 24, 16)

HEAD = """
units si
atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
{start}
neighbor 0.002 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep {step}
fix gravity all gravity 9.81 vector 0 -1 0
"""
BOX = "region box block -0.06 0.06 -0.06 0.03 -0.03 0.03 units box\ncreate_box 1 box"
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


def write_surfaces(folder):
    """The right sphere, and its mirror image with the corners in the other order."""
    right = body_case.sphere(DIAMETER, (PLACE, DIAMETER / 2 + GAP, 0.0), rings=24)
    left = [tuple((-x, y, z) for x, y, z in reversed(triangle)) for triangle in right]
    for name, triangles in (("right", right), ("left", left)):
        for place in (folder, folder / "foam/constant/triSurface"):
            body_case.write_stl(place / f"{name}.stl", triangles)


def write_script(folder, order, start=BOX, steps=STEPS):
    """frazilDem's script with the bodies in this order."""
    velocity = {"right": SPEED[0], "left": -SPEED[0]}
    bodies = "".join(BODY.format(name=name, vx=velocity[name], vy=SPEED[1]) for name in order)
    (folder / "in.two").write_text(HEAD.format(start=start, step=STEP / SUBSTEPS) + bodies +
                                   COUPLE.format(steps=steps * SUBSTEPS + 1))


def write_fluid(folder):
    """frazilFoam's case: fixed time steps, tight solvers, fields written in the middle and at the end."""
    case = folder / "foam"
    bodies = " ".join(f"{name} {{ surface \"constant/triSurface/{name}.stl\"; }}" for name in ("right", "left"))
    body_case.write_case(case, body_case.box_mesh(LO, HI, CELLS), 0.0,
                         body_case.control(STEPS * STEP, STEP, adjust="no", write_interval=MIDDLE), bodies)
    solution = case / "system/fvSolution"
    text = solution.read_text()
    for loose, tight in TIGHT:
        assert loose in text, loose
        text = text.replace(loose, tight)
    solution.write_text(text)
    body_case.write(case / "constant/couplingProperties", "coarseGrid { min (-0.06 -0.06 -0.03); max (0.06 0.03 0.03); "
                    f"cellSize 0.03; }}\nbodies {{ {bodies} }}\n")


def mesh(folder, tools):
    for tool in tools:
        subprocess.run([ROOT / "frazil", "exec", tool], cwd=folder / "foam", check=True, stdout=subprocess.DEVNULL)


def launch(folder, dem_ranks=1):
    with open(folder / "log.pair", "a") as log:
        code = subprocess.run([ROOT / "frazil", "exec", "mpirun", "--oversubscribe", "-np", str(dem_ranks),
                               BUILD / "bin/frazilDem", "-in", "in.two", "-log", "log.dem", "-screen", "/dev/null", ":", "-np", "1",
                               BUILD / "bin/frazilFoam", "-case", "foam"], cwd=folder, stdout=log, stderr=log,
                              timeout=600).returncode
    if code:
        logs = "".join((folder / name).read_text(errors="replace")[-2000:] for name in ("log.dem", "log.pair"))
        sys.exit(f"{folder.name} ended with {code}:\n{logs}")


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
    mesh(folder, ("blockMesh", "setFields"))
    launch(folder)
    return loads(folder, order)


def go_on(folder, order):
    """The same run once more from its middle."""
    (folder / "foam/system/controlDict").write_text(
        (folder / "foam/system/controlDict").read_text().replace("startTime 0", f"startTime {MIDDLE:g}"))
    write_script(folder, order, f"read_restart restart.{STEPS // 2 * SUBSTEPS}", STEPS - STEPS // 2)
    launch(folder)
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
