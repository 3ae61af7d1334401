"""Parts of frazilFoam on a real mesh: the flow on particles, the water fraction's scheme, sizes and steps of bodies,
what a coupled case cannot have.

run.py PART PROGRAM [RANKS]    PART: see PARTS

Closed forms: linear fields in every cell, quadratic ones away from the boundary, to 1e-12;
expected sizes and steps by a loop over the cells. The words of a refusal are those that the user reads.
"""
import os
import subprocess
import sys

import mpirun
import tank_case
from surfaces import sphere, write_stl
from turned_box import block_mesh, turned

HALF = (0.02, 0.025, 0.015)
CELLS = (8, 10, 6)
SCHEMES = """
ddtSchemes {{ default Euler; {ddt} }}
gradSchemes {{ default Gauss linear; }}
divSchemes {{ div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
"""
BODIES = {"large": (0.009, turned((0.004, -0.006, 0.002))), "tiny": (2e-4, turned((-0.0051, 0.0079, 0.0038)))}


def make(ddt="", pimple="", dynamic=None, grading=(1, 1, 1), ranks=1):
    """The mesh is binary: ten digits of a point are not enough for differences to be exact."""
    tank_case.write("system/controlDict", "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1e-4;\n"
                    "writeControl timeStep; writeInterval 1000; timePrecision 8; writeFormat binary;\n")
    tank_case.write("system/fvSchemes", SCHEMES.format(ddt=ddt))
    tank_case.write("system/fvSolution", f'solvers {{ "alpha.water.*" {{ cAlpha 0.7; }} }}\nPIMPLE {{ {pimple} }}\n')
    tank_case.write("system/blockMeshDict", block_mesh(HALF, CELLS, grading))
    tank_case.write("system/decomposeParDict", f"numberOfSubdomains {ranks}; method hierarchical;\n"
                    f"coeffs {{ n ({ranks} 1 1); delta 0.001; order xyz; }}\n")
    tank_case.write("constant/transportProperties", tank_case.water_and_air())
    tank_case.write("constant/turbulenceProperties", "simulationType laminar;\n")
    tank_case.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);\n", "uniformDimensionedVectorField")
    tank_case.write("0/alpha.water", "dimensions [0 0 0 0 0 0 0]; internalField uniform 1;\n"
                    'boundaryField { ".*" { type zeroGradient; } }\n', "volScalarField")
    if dynamic:
        tank_case.write("constant/dynamicMeshDict", dynamic)
    elif os.path.exists("constant/dynamicMeshDict"):
        os.remove("constant/dynamicMeshDict")
    call(["blockMesh"])


def add_bodies():
    """Bodies and the boxes around them, for bodyCellSize; `coupling off`, for a coupling without a partner."""
    boxes = entries = ""
    for name, (diameter, centre) in BODIES.items():
        triangles = sphere(diameter, centre, 24)
        write_stl(f"constant/triSurface/{name}.stl", triangles)
        corners = [corner for triangle in triangles for corner in triangle]
        low, high = (" ".join(f"{f(c[i] for c in corners):.17g}" for i in range(3)) for f in (min, max))
        boxes += f"{name} {{ min ({low}); max ({high}); }}\n"
        entries += f'{name} {{ surface "constant/triSurface/{name}.stl"; }}\n'
    tank_case.write("constant/couplingProperties", f"bodies {{ {entries} }}\nboxes {{ {boxes} }}\n")


def add_moving_body():
    name, (diameter, centre) = "large", BODIES["large"]
    write_stl(f"constant/triSurface/{name}.stl", sphere(2 * diameter, centre, 24))
    tank_case.write("constant/couplingProperties", f"coupling off;\n{tank_case.LEFT}\n"
                    f'bodies {{ {name} {{ surface "constant/triSurface/{name}.stl"; '
                    "motion { velocity (5 -30 0); } } }\n")


def call(command, fails=False):
    done = subprocess.run(command, env=mpirun.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if (done.returncode != 0) != fails:
        print(done.stdout[-5000:])
        sys.exit(f"FAILED: {' '.join(command)} ended with {done.returncode}")
    return done.stdout


def check(holds, what, output=""):
    print(("ok      " if holds else "FAILED  ") + what)
    if not holds:
        sys.exit(output[-2000:])


def in_closed_form(part, program, ranks, grading=(1, 1, 1)):
    """The program compares; here it only has to end well."""
    make(grading=grading, ranks=ranks)
    if part == "bodyCellSize":
        add_bodies()
    if part == "accelerationShare":
        add_moving_body()
    command = [program, "-part", part]
    if ranks > 1:
        call(["decomposePar", "-force"])
        command = [*mpirun.COMMAND, "-np", str(ranks), *command, "-parallel"]
    print(call(command))


def refused(program, words, *options, **case):
    make(**case)
    output = call([program, *options], fails=True)
    # OpenFOAM breaks no lines of a message, so that the words stand as they were written
    check(all(word in output for word in words), f"refused with {words}", output)


def off_centring(program):
    """0 for Euler; for Crank-Nicolson its value once there is an old flux: in the second step, or after a restart."""
    part = ["-part", "offCentring"]
    for ddt, expected in (("", "0 0 0"), ("ddt(alpha) localEuler;", "0 0 0"),
                          ("ddt(alpha) CrankNicolson 0.9;", "0 0.9 0.9")):
        make(ddt=ddt)
        output = call([program, *part])
        check(f"off-centring {expected}\n" in output, f"{ddt or 'Euler'}: {expected}", output)
    refused(program, ["system/fvSchemes", "ddt(alpha) is backward", "Euler, localEuler or CrankNicolson"], *part,
            ddt="ddt(alpha) backward;")
    refused(program, ["system/fvSolution", "nAlphaSubCycles is 3", "CrankNicolson works with 1 only"], *part,
            "-subCycles", "3", ddt="ddt(alpha) CrankNicolson 0.9;")


def coupled_case(program):
    part = ["-part", "coupledCase"]
    moving = "dynamicFvMesh dynamicInkJetFvMesh; amplitude 0; frequency 1; refPlaneX 0;\n"
    both = "both must be Euler"
    for dynamic in (None, "dynamicFvMesh staticFvMesh;\n"):
        make(dynamic=dynamic)
        check("accepted" in call([program, *part]), f"accepted: {(dynamic or 'no dynamicMeshDict').strip()}")
    refused(program, ["constant/dynamicMeshDict", "moving or refined mesh", "staticFvMesh"], *part, dynamic=moving)
    refused(program, ["system/fvSchemes", "ddt(alpha) is CrankNicolson and ddt(rho,U) is Euler", both], *part,
            ddt="ddt(alpha) CrankNicolson 0.9;")
    refused(program, ["ddt(alpha) is Euler and ddt(rho,U) is backward", both], *part, ddt="ddt(rho,U) backward;")
    refused(program, ["system/fvSchemes", both], *part, "-localTime")
    refused(program, ["system/fvSolution", "frozenFlow", "Remove frozenFlow"], *part, pimple="frozenFlow yes;")


GRADED = (3, 0.5, 2)
PARTS = {
    "pressureGradient": lambda program, ranks: in_closed_form("pressureGradient", program, ranks),
    "flowAtParticles": lambda program, ranks: in_closed_form("flowAtParticles", program, ranks),
    "accelerationShare": lambda program, ranks: in_closed_form("accelerationShare", program, ranks),
    "compression": lambda program, ranks: in_closed_form("compression", program, ranks),
    "faceMax": lambda program, ranks: in_closed_form("faceMax", program, ranks, GRADED),
    "bodyCellSize": lambda program, ranks: in_closed_form("bodyCellSize", program, ranks, GRADED),
    "offCentring": lambda program, _: off_centring(program),
    "coupledCase": lambda program, _: coupled_case(program),
}

if __name__ == "__main__":
    PARTS[sys.argv[1]](os.path.abspath(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1)
