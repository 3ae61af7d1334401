"""The basin in which structures float: floating_plate, floating_structures. y is up, the still surface at y = 0. SI units."""
import math

import folder
import mesh


def box(p):
    """((x, X), (y, Y), (z, Z)) of the basin."""
    return ((-p["half_width"], p["half_width"]), (-p["depth"], p["height"]), (-p["half_width"], p["half_width"]))


def write(run, p, case, name, step, bonds=""):
    """The script and fluid of a case folder, for a DEM step [s]; bonds: words of fix bond/parallel that choose the pairs."""
    width, depth, height = p["half_width"], p["depth"], p["height"]
    folder.copy_dem(case / "dem/in.floating_plate", run, {
        "bond_young": p["bond_young"], "time_step": step, "skin": 0.25 * p["sphere_diameter"], "bonds": bonds,
        "steps": math.ceil(p["end_time"] / step) + 1, "log_every": round(1e-3 / step),
        "thermo_every": round(0.02 / step)}, name=name)
    folder.copy_foam(case / "foam", run, {
        "coarse_min": (-width, -depth, -width), "coarse_max": (width, height, width), "coarse_cell": p["coarse_cell"],
        "endTime": p["end_time"], "first_step": 1e-4, "longest_step": p["longest_fluid_step"]})
    across = mesh.axis(-width, -width, width, width, p["fine_width"], 1.0)
    along = mesh.axis(-depth, -p["core_depth"], p["core_height"], height, p["fine_cell"], p["growth"])
    mesh.write_block_mesh(run / "foam/system/blockMeshDict", box(p), (across, along, across))
    print(f"fluid: {mesh.cell_count(across, along, across)} cells")
