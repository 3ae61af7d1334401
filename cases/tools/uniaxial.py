"""ice_tension and ice_compression: one script, pulled or pressed; what the stress-strain curves say of the specimen."""
import math
from pathlib import Path

import folder
import ice
import lattice
from specimen import Specimen, material, schedule

SCRIPT = Path(__file__).resolve().parents[1] / "ice_tension/dem/in.ice_tension"
GRIP = 4  # columns at each end


def prepare(run, parameters, name, strain_rate):
    """Script and specimen in the run folder; strain_rate [1/s], negative to press."""
    body, diameter = Specimen(parameters).build(), parameters["sphere_diameter"]
    half = 0.5 * body.length
    grip = half - (GRIP - 0.25) * diameter
    ratios = [lattice.Plate(material(parameters, ratio), body.layers) for ratio in parameters["stiffness_ratios"]]
    numbers = {key: parameters[key] for key in ("bond_young", "tensile_strength", "shear_strength", "bond_damping")}
    numbers.update(schedule(parameters, min(body.diameters), parameters["largest_strain"] / abs(strain_rate), rows=400),
                   strain_rate=strain_rate, skin=0.25 * diameter, bond_words=ice.bond_words(parameters), grip=grip,
                   mark_inner=0.5 * half - diameter, mark_outer=0.5 * half + diameter, side_inner=0.25 * body.width - diameter,
                   side_outer=0.25 * body.width + diameter, mid_plane=0.1 * diameter, section=body.section,
                   poisson_ratio=[plate.poisson() for plate in ratios])
    folder.copy_dem(SCRIPT, run, numbers, name=name)
    body.write(run / "dem/specimen.data", parameters["ice_density"], margin=0.25 * half)
    body.write_bonds(run / "dem/bonds.txt", run / "dem/grip_bonds.txt", lambda centre: abs(centre[0]) > grip)
    print(f"ice: {len(body.points)} spheres, section {1e6 * body.section:.4g} mm2")
