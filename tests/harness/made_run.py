"""A run folder made by hand, in the form in which the programs leave one, small enough to work out every diagnostic.

An octahedron, 16 mm wide and 40 mm high, falls on five spheres. Three rows at 0, 1 and 2 ms; two snapshots, at 0 and 2 ms.
"""
import json

import h5py
import numpy

HISTORY = {
    "time": (0, 1e-3, 2e-3), "x": (0, 0.003, 0.003), "y": (0.03, 0.02, 0.01), "z": (0, 0, 0.004),
    "vx": (0, 0, 0), "vy": (-3, -3, -1), "vz": (0, 4, 0), "wx": (0, 0, 0), "wy": (0, 0, 0), "wz": (0, 0, 200),
    "contact_fx": (0, 0, 0), "contact_fy": (0, 4, 2), "contact_fz": (0, 3, 0),
    "fluid_fx": (0, 0, 3), "fluid_fy": (0, 0, 10), "fluid_fz": (0, 0, 4), "wetted": (0, 5e-5, 0.25),
    "bonds_intact": (4, 3, 2), "broken_tension": (0, 1, 1), "broken_shear": (0, 0, 1), "eta": (1, 0.75, 0.5),
    "fluid_dt": (1e-3, 1e-3, 0), "substeps": (10, 10, 0), "wall": (1, 3, 4), "dem_waited": (0, 1, 1),
    "foam_waited": (0, 0.5, 2)}

COLUMNS = ("particles dryParticles volumeParticles volumeAbsent volumeCoarse volumeFine volumeClipped cellsClipped "
           "volumeErrorCoarse volumeErrorFine impulseReceivedY impulseFineY impulseHeldY impulseErrorCoarse impulseErrorFine passiveReceivedY "
           "passiveReturnedY responseY passiveError demParticles particlesLost demVolume demMomentumY volumeErrorTransport "
           "impulseErrorTransport").split()
LEDGER = {
    "time": (0, 1e-3, 2e-3), **{name: (0, 0, 0) for name in COLUMNS},
    "particles": (5, 5, 4), "dryParticles": (0, 1, 0), "volumeParticles": (1e-5, 1e-5, 0.8e-5),
    "volumeClipped": (0, 1e-6, 2e-6), "particlesLost": (0, 0, 1), "passiveError": (1e-15, 3e-14, 2e-15), "volumeErrorFine": (0, 0, 5e-16),
    "demMomentumY": (0, -0.003, -0.01), "impulseHeldY": (0, 0, 0.001)}

EVENTS = "time,id1,id2,mode,x,y,z,sigma,tau\n0.0005,1,2,tension,9,9,9,2e6,0\n0.0015,2,3,shear,9,9,9,0,1e6\n"

LOG_DEM = """LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd, git commit unknown)
Body projectile: mass 0.03 kg, volume 1.02338e-05 m3, centre (0, 0.03, 0) m, velocity (0, -3, 0) m/s
FRAZIL_TIMERS side=dem wall=4.0000 waiting=1.0000 exchange=0.5000 force=0.2500
"""
BUDGET = ("Momentum budget: change (0 {change} 0) boundary (0 1 0) weight (0 0 0) tension (0 0 0) particles (0 1 0) "
          "solid (0 1 0) bodies (0 2 0) splitting (0 0 0) gradient (0 0 0) error (0 0 0)\n")
LOG_FOAM = """Build  : OPENFOAM=1912 patch=200626
frazilDem: 5 particles, 1 bodies, time step 1e-04 s; coarse grid 2 x 2 x 2 cells of 0.5 m

Time = 0.001
""" + BUDGET.format(change=5) + """
Time = 0.002
""" + BUDGET.format(change=5.5) + """
Coupling, wall time on the first fluid rank [s] and share of the run [%]
    projection 0.2 5
    exchange 0.2 5
    waiting for frazilDem 2 50

End
"""
BLOCK = """vertices ( (-0.5 -0.75 -0.5) (0.5 -0.75 -0.5) (-0.5 0.75 -0.5) (0.5 0.75 -0.5)
           (-0.5 -0.75 0.5) (0.5 -0.75 0.5) (-0.5 0.75 0.5) (0.5 0.75 0.5) );
blocks ( hex (0 1 3 2 4 5 7 6) (2 3 2)
    simpleGrading (((1 2 1)) ((0.75 1 1) (0.75 2 2)) ((1 2 1))) );
"""
GRID = ('<Grid><Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">-0.5 -0.75 -0.5</DataItem>'
        '<DataItem Dimensions="3">0.5 0.5 0.5</DataItem></Geometry></Grid>')
WATER = numpy.array([[[1.0, 1.0], [0.5, 0.0], [0.0, 0.0]], [[1.0, 1.0], [0.7, 0.2], [0.0, 0.0]]])  # [z, y, x]


def csv(columns):
    """Text of a table."""
    rows = zip(*columns.values())
    return ",".join(columns) + "\n" + "".join(",".join(f"{value:.17g}" for value in row) + "\n" for row in rows)


def octahedron(run):
    """The body's STL: 8 mm around the axis, 20 mm above and below the centre of mass at (0 0.03 0)."""
    ring = [(0.008, 0.03, 0), (0, 0.03, 0.008), (-0.008, 0.03, 0), (0, 0.03, -0.008)]
    facets = [(apex, ring[n], ring[(n + 1) % 4]) for apex in ((0, 0.05, 0), (0, 0.01, 0)) for n in range(4)]
    lines = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % p for p in facet) + "endloop\nendfacet\n"
             for facet in facets]
    write(run / "foam/constant/triSurface/projectile.stl", "solid projectile\n" + "".join(lines) + "endsolid\n")


def spheres(run):
    """particles.h5: spheres 1-5, stored out of order; the fourth has twice the radius of the others, the fifth is in no
    fragment. The last group has no xdmf: it was cut off."""
    ids = numpy.array([2, 1, 3, 5, 4])
    position = numpy.array([(0.002, 0, 0), (0, 0, 0), (0, 0, 0.002), (0.5, 0, 0), (0.1, 0.4, 0.0041)])
    with h5py.File(run / "particles.h5", "w") as file:
        for step, time, fragment, whole in ((0, 0.0, (1, 1, 1, 0, 1), True), (20, 2e-3, (1, 1, 1, 0, 4), True),
                                            (40, 4e-3, (1, 1, 1, 0, 4), False)):
            group = file.create_group(f"particles/{step:012d}")
            group["id"], group["position"] = ids, position + (1e-4 * step, 0, 0)
            group["fragment"] = numpy.array(fragment, float)
            group["radius"] = numpy.array([1e-3, 1e-3, 1e-3, 1e-3, 2e-3])
            group["velocity"] = numpy.tile((0.0, 3.0, 4.0), (5, 1))
            group.attrs["time"] = time
            if whole:
                group.attrs["xdmf"] = "<Grid/>"


def fluid(run, ranks=1):
    """Mesh and water fraction at 0 and 2 ms; binary, or ascii in parts on two ranks, cut along x. coarse.h5 with the same."""
    write(run / "foam/system/blockMeshDict", BLOCK)
    write(run / "foam/system/controlDict", "endTime 0.002;\n")
    write(run / "foam/constant/couplingProperties", 'bodies { projectile { surface "constant/triSurface/projectile.stl"; } }\n')
    write(run / "foam/constant/transportProperties", "water { rho 1000; }\nair { rho 1.3; }\n")
    for time in ("0", "0.002"):
        if ranks == 1:
            head = b"FoamFile { format binary; }\ninternalField nonuniform List<scalar>\n12\n("
            write(run / f"foam/{time}/alpha.water", head + WATER.tobytes() + b")\n;\n")
            continue
        for rank in (0, 1):
            cells = numpy.arange(12)[rank::2]
            part = run / f"foam/processor{rank}"
            write(part / "constant/polyMesh/cellProcAddressing", foam_list("", cells))
            values = foam_list("internalField nonuniform List<scalar>", WATER.ravel()[cells])
            write(part / f"{time}/alpha.water", values + ";\n")
    with h5py.File(run / "coarse.h5", "w") as file:
        group = file.create_group("coarse/000000000000")
        group["water fraction"] = WATER
        group.attrs["time"], group.attrs["xdmf"] = 0.0, GRID


def foam_list(head, values):
    """A list in OpenFOAM's ascii form."""
    return f"FoamFile {{ format ascii; }}\n{head}\n{len(values)}\n(\n" + "\n".join(map(str, values)) + "\n)\n"


def write(path, content):
    """A file with its folders."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content if isinstance(content, bytes) else content.encode())


def make(run, ranks=1):
    """All of it."""
    run.mkdir(parents=True)
    plan = {"case": "/somewhere/cases/toy", "level": "demo", "np_dem": 1, "np_foam": ranks, "version": "v1"}
    write(run / "run.json", json.dumps(plan))
    write(run / "params.json", json.dumps({"bond_young": 0.9e9, "ice_density": 900.0, "shielding": "on"}))
    write(run / "history.csv", csv(HISTORY))
    write(run / "ledger.csv", csv(LEDGER))
    write(run / "dem/bonds.csv", EVENTS)
    write(run / "log.dem", LOG_DEM)
    write(run / "log.foam", LOG_FOAM)
    write(run / "log.prepare", "  nCells: 12\n")
    octahedron(run)
    spheres(run)
    fluid(run, ranks)
    return run
