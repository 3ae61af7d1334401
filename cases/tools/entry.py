"""What ice_entry and free_entry share: the body, the fluid's mesh and its numbers, so that they differ by the ice only.

y is up, the water's surface is at y = 0, the body falls along the axis x = z = 0. SI units; D0 is the body's diameter.
"""
import math
from pathlib import Path

import folder
import mesh
import projectile

D0 = 0.016
LENGTH = 3.375 * D0
CONE = math.radians(60)       # half-angle
TIP_RADIUS = 0.0008
DENSITY = 2700.0              # of the body, as dem/in.* has it [kg/m3]
CENTRE = 0.02848              # height of the centre of mass above the tip
SIDE, DEPTH, HEIGHT = 10 * D0, 32 * D0, 10 * D0  # half width of the water, its depth, the air above
FOAM = Path(__file__).resolve().parents[1] / "ice_entry" / "foam"


def surface(parameters, tip_height=0.0):
    """Triangles of the body, the tip at tip_height [m]."""
    profile = projectile.meridian(D0, LENGTH, CONE, TIP_RADIUS, parameters["facets"])
    return projectile.triangles(profile, parameters["facets"], (0.0, tip_height, 0.0))


def mass(parameters):
    """Of the body [kg]."""
    return DENSITY * projectile.volume(surface(parameters))


def write_projectile(run, parameters, tip_height):
    """One STL for both programs, the tip at tip_height [m]."""
    corners = surface(parameters, tip_height)
    for place in (run / "dem", run / "foam/constant/triSurface"):
        projectile.write_stl(place / "projectile.stl", corners, "projectile")


def coarse_box(parameters):
    """Box of the coarse grid and of the particles: as wide as the fluid, deep enough for the whole path."""
    cell = 2 * SIDE / parameters["coarse_cells"]
    down, up = math.ceil(parameters["reach_below"] / cell - 1e-9), math.floor(HEIGHT / cell + 1e-9)
    return cell, ((-SIDE, SIDE), (-down * cell, up * cell), (-SIDE, SIDE))


def write_fluid(run, parameters):
    """The fluid's case: even cells of D0/cells_per_diameter around the path and at the surface, growing outwards."""
    size = D0 / parameters["cells_per_diameter"]
    whole = lambda length: size * round(length / size)
    core = whole(parameters["core_radius"])
    across = mesh.axis(-SIDE, -core, core, SIDE, size, parameters["growth"])
    along = mesh.axis(-DEPTH, -whole(parameters["core_depth"]), whole(parameters["core_height"]), HEIGHT, size,
                      parameters["growth"])
    cell, box = coarse_box(parameters)
    longest = 0.3 * size / parameters["impact_speed"]
    folder.copy_foam(FOAM, run, {
        "coarse_min": tuple(low for low, _ in box), "coarse_max": tuple(high for _, high in box), "coarse_cell": cell,
        "endTime": parameters["end_time"], "first_step": 0.2 * longest, "longest_step": longest,
        "max_courant": parameters["max_courant"], "write_interval": parameters["write_interval"],
        "shielding": parameters.get("shielding", "off")})
    mesh.write_block_mesh(run / "foam/system/blockMeshDict", ((-SIDE, SIDE), (-DEPTH, HEIGHT), (-SIDE, SIDE)),
                          (across, along, across))
    print(f"fluid: {mesh.cell_count(across, along, across)} cells, {1e3 * size:.3g} mm in the core")


def check_cavity(run, history, result):
    """The cavity: at the end there is air on the axis behind the tail, where water or ice stood at the start."""
    starts = (run / "foam/postProcessing/axis").iterdir()  # one folder per start: a resumed run has several
    lines = (max(starts, key=lambda path: float(path.name)) / "alpha.water").read_text().splitlines()
    heights = [float(line.split()[4]) for line in lines if line.startswith("# Probe ")]
    water = [float(word) for word in lines[-1].split()[1:]]
    tail = history["y"][-1] + LENGTH - CENTRE
    behind = [(value, height) for value, height in zip(water, heights) if height > tail]
    lowest = min(behind, default=(1.0, 0.0))
    result.say(lowest[0] < 0.1, f"cavity: lowest water fraction on the axis above the tail at {1e3 * tail:.3g} mm",
               f"{lowest[0]:.3g} at {1e3 * lowest[1]:.3g} mm", "below 0.1")
