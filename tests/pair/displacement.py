#!/usr/bin/env python3
"""The volume that particles displace has inertia, with and without a body in the case; inserted ones come gently.

    released    a light plate of bonded spheres in water: its acceleration over the first 2 ms is the same with a body locked in
                a far corner as without (1 %)
    inserted    a sphere that appears in still water: the fluid's greatest speed does not depend on its time step (20 %)
                and stays below that of the volume coming over the time `ramp`, V/(ramp h²)

FRAZIL_BUILD names the build folder.
"""
import math
import sys
import tempfile
from pathlib import Path

import dem_script
import pair
import surfaces
import tank_case
import foam_case as fc

HALF, SMALL = 0.04, 0.008  # half the tank, the locked body's diameter [m]
DIAMETER = 0.003

HEAD = (dem_script.head(dem_script.box((-HALF,) * 3, (HALF,) * 3), sort=" sort 0 0") + "timestep {step}\n" +
        dem_script.GRAVITY)
PLATE = HEAD + f"""
region plate block -0.012 0.012 -0.003 0.003 -0.012 0.012 units box
lattice sc {DIAMETER}
create_atoms 1 region plate
set group all diameter {DIAMETER} density 300
{{body}}
fix bonds all bond/parallel young 1e7 stiffness_ratio 2 tensile_strength 1e9 shear_strength 1e9 damping 0.1
fix motion all nve/sphere
fix fluid all couple/foam
variable vy equal vcm(all,y)
fix out all print 100 "${{{{vy}}}}" file speed.txt screen no title vy
run 2001
"""
LOCKED = """fix hull_small all mesh/surface/stress file small.stl type 1
fix small all body/rigid mesh hull_small density 1000 lock x y z rx ry rz
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes hull_small
"""
INSERTED = HEAD + f"""
create_atoms 1 single -0.03 0.03 0.03 units box  # LIGGGHTS does not start without any
set group all diameter {DIAMETER} density 1000
fix motion all nve/sphere
fix fluid all couple/foam ramp {{ramp}}
run {{first}} stop {{rest}}
create_atoms 1 single 0.001 0.002 -0.001 units box
set group all diameter {DIAMETER} density 1000
run {{rest}} upto
"""


def write_fluid(folder, end, delta_t, bodies="", write_interval=None):
    case, n = folder / "foam", 20
    tank_case.write_case(case, tank_case.box_mesh((-HALF,) * 3, (HALF,) * 3, (n, n, n)), None,
                         tank_case.control(end, delta_t, adjust="no", write_interval=write_interval), "")
    tank_case.write(case / "constant/couplingProperties", f"coarseGrid {{ min (-{HALF} -{HALF} -{HALF}); "
                    f"max ({HALF} {HALF} {HALF}); cellSize {3 * DIAMETER}; }}\n{bodies}")


def acceleration(folder, body):
    """Of the plate over 2 ms, after the first of them [m/s2]."""
    (folder / "foam/constant/triSurface").mkdir(parents=True)
    place = 0.7 * HALF
    surface = surfaces.sphere(SMALL, (place, place, place), rings=16)
    for path in (folder / "small.stl", folder / "foam/constant/triSurface/small.stl"):
        surfaces.write_stl(path, surface)
    bodies = 'bodies { small { surface "constant/triSurface/small.stl"; } }\n' if body else ""
    write_fluid(folder, 4e-3, 2e-4, bodies)
    (folder / "in.two").write_text(PLATE.format(step=2e-6, body=LOCKED if body else ""))
    pair.mesh(folder, ["blockMesh"])
    pair.launch(folder)
    speed = [float(word) for word in (folder / "speed.txt").read_text().split()[1:]]
    return (speed[15] - speed[5]) / (10 * 100 * 2e-6)


def released(scratch):
    with_body, without = (acceleration(scratch / name, body) for name, body in (("body", True), ("alone", False)))
    change = with_body / without - 1
    good = abs(change) < 0.01
    print(f"{'PASS' if good else 'FAIL'} plate released: {without:.4g} m/s2 alone, {with_body:.4g} with a locked body far "
          f"away, change {change:.2%} (1 %)", flush=True)
    return good


def fastest(folder, delta_t, ramp):
    """Greatest speed of the fluid in the first 5 ms after the insertion [m/s]."""
    folder.mkdir()
    substeps, steps = round(delta_t / 1e-5), round(6e-3 / delta_t)
    write_fluid(folder, steps * delta_t, delta_t, write_interval=delta_t)
    (folder / "in.two").write_text(INSERTED.format(step=1e-5, ramp=ramp, first=substeps, rest=steps * substeps + 1))
    pair.mesh(folder, ["blockMesh"])
    pair.launch(folder)
    found = 0
    for step in range(1, steps + 1):
        flat = (fc.lists(folder / "foam" / f"{step * delta_t:.10g}" / "U") or [[0]])[0]
        found = max(found, max(map(abs, flat)))
    return found


def inserted(scratch):
    ramp = 0.01
    speeds = [fastest(scratch / f"inserted{delta_t}", delta_t, ramp) for delta_t in (1e-4, 4e-4)]
    limit = math.pi / 6 * DIAMETER**3 / (ramp * (3 * DIAMETER)**2)
    good = max(speeds) < limit and abs(speeds[0] / speeds[1] - 1) < 0.2
    print(f"{'PASS' if good else 'FAIL'} sphere inserted: fluid at most {speeds[0]:.3g} m/s at Δt 0.1 ms, {speeds[1]:.3g} at "
          f"0.4 ms (limit {limit:.3g})", flush=True)
    return good


def main():
    with tempfile.TemporaryDirectory(prefix="frazil-displacement-") as folder:
        for name in ("body", "alone"):
            (Path(folder) / name).mkdir()
        passed = [released(Path(folder)), inserted(Path(folder))]
    sys.exit(not all(passed))


if __name__ == "__main__":
    main()
