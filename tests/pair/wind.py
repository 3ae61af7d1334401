#!/usr/bin/env python3
"""A held sphere just below still water does not feel the wind above it, nor one just above it the water's stillness.

Air at 20 m/s over still water, one coarse cell for both. At the first exchange, along the wind:

    1.5 mm below the surface    nothing but viscous stress, over its weight              1e-4
    1.5 mm above                the drag law of air at 20 m/s (Di Felice, one sphere)    1 %

FRAZIL_BUILD names the build folder.
"""
import math
import sys
import tempfile
from pathlib import Path

import dem_script
import pair
import tank_case

DIAMETER, WIND, HALF, DEPTH = 0.002, 20.0, 0.04, 0.0015
NU_AIR, RHO_AIR = 1.314e-5, 1.294  # of tank_case's air

BOX = dem_script.box((-HALF,) * 3, (HALF,) * 3)
SCRIPT = dem_script.head(BOX, sort=" sort 0 0") + "timestep {step}\n" + dem_script.GRAVITY + f"""
create_atoms 1 single 0.003 {{height}} 0.002 units box
set group all diameter {DIAMETER} density 1000
fix fluid all couple/foam
variable fx equal f_fluid[3]
fix out all print 1 "${{{{fx}}}}" file force.txt screen no title fx
run 11
"""


def force(folder, height):
    """Along the wind, after the first DEM step [N]."""
    folder.mkdir()
    case = folder / "foam"
    tank_case.write_case(case, tank_case.box_mesh((-HALF,) * 3, (HALF,) * 3, (20,) * 3), 0.0,
                         tank_case.control(1e-5, 1e-5, adjust="no"), "")
    tank_case.write(case / "system/setFieldsDict", f"""
defaultFieldValues (volScalarFieldValue alpha.water 0 volVectorFieldValue U ({WIND} 0 0));
regions (boxToCell {{ box (-10 -10 -10) (10 0 10);
    fieldValues (volScalarFieldValue alpha.water 1 volVectorFieldValue U (0 0 0)); }});
""")
    tank_case.write(case / "constant/couplingProperties",  # the surface in the middle of a cell
                    f"coarseGrid {{ min (-0.06 -0.06 -0.06); max (0.06 0.06 0.06); cellSize 0.024; }}\n")
    (folder / "in.two").write_text(SCRIPT.format(step=1e-6, height=height))
    pair.mesh(folder, ["blockMesh", "setFields"])
    pair.launch(folder)
    return float((folder / "force.txt").read_text().split()[1])


def main():
    weight = 1000 * 9.81 * math.pi / 6 * DIAMETER**3
    reynolds = WIND * DIAMETER / NU_AIR
    drag = 0.5 * RHO_AIR * WIND**2 * (0.63 + 4.8 / math.sqrt(reynolds))**2 * math.pi / 4 * DIAMETER**2
    with tempfile.TemporaryDirectory(prefix="frazil-wind-") as scratch:
        below, above = (force(Path(scratch) / name, y) for name, y in (("below", -DEPTH), ("above", DEPTH)))
    good = abs(below) < 1e-4 * weight, abs(above / drag - 1) < 0.01
    print(f"{'PASS' if good[0] else 'FAIL'} below the surface: {below / weight:.3g} of the weight (1e-4)")
    print(f"{'PASS' if good[1] else 'FAIL'} above it: {above:.4g} N, drag law {drag:.4g} N, off by {above / drag - 1:.2g} (1 %)")
    sys.exit(not all(good))


if __name__ == "__main__":
    main()
