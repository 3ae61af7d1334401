"""What openVolume and its files compute on a real mesh, against the slow reference beside it (openReference.H).

run.py RANKS PROGRAM [-closed]    RANKS: 1 | 2; -closed: without an outlet, where the level of a potential is free

A ball that slips and a cone that the fluid sticks to move and turn through a graded mesh whose axes are turned against
theirs, so that both cut cells obliquely; αf varies in space and time. Every step, and the same without bodies:

    ε, ε of parts of the step, ρε, factors of cells and faces, merged faces, face coefficient, reconstruct, convection,
    anchors, continuation of α and p_rgh into the bodies, blending, Courant number, means             1e-12
    Σ φ = -V Δε/Δt after correctFlux and after the pressure equation; the potential fluxes themselves   1e-11

relative to the largest value; the second is what the solvers of linear equations leave.
"""
import os
import subprocess
import sys

import mpirun
import tank_case
from surfaces import revolve, sphere, write_stl
from turned_box import block_mesh, turned

SCHEMES = """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { div(rhoPhi,U) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
SOLVER = "{ solver PCG; preconditioner DIC; tolerance 1e-15; relTol 0; maxIter 5000; }"


def bodies():
    cone = [(0, 0), (0.007, 0.004), (0.007, 0.013), (0, 0.013)]
    return {"ball": (sphere(0.018, turned((-0.012, 0.001, -0.002)), 32), "yes"),
            "cone": (revolve(cone, 48, turned((0.013, -0.005, 0.001))), "no")}


def make(ranks):
    tank_case.write("system/controlDict", "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1e-4;\n"
                    "writeControl timeStep; writeInterval 1000; timePrecision 8; writeFormat binary;\n")
    tank_case.write("system/fvSchemes", SCHEMES)
    tank_case.write("system/fvSolution", f'solvers {{ "p.*" {SOLVER} }}\nPIMPLE {{}}\n')
    tank_case.write("system/blockMeshDict", block_mesh((0.026, 0.018, 0.017), (30, 22, 20), (1.5, 0.8, 1.2)))
    tank_case.write("system/decomposeParDict", f"numberOfSubdomains {ranks}; method hierarchical;\n"
                    f"coeffs {{ n ({ranks} 1 1); delta 0.001; order xyz; }}\n")
    entries = ""
    for name, (triangles, slip) in bodies().items():
        write_stl(f"constant/triSurface/{name}.stl", triangles)
        entries += f'{name} {{ surface "constant/triSurface/{name}.stl"; slip {slip}; }}\n'
    tank_case.write("constant/couplingProperties",
                    f"velocity (4 -3 2); omega (60 90 -30); bodies {{ {entries} }}\n")


def call(command):
    done = subprocess.run(command, env=mpirun.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print(done.stdout[-6000:])
        sys.exit(f"FAILED: {' '.join(command)} ended with {done.returncode}")
    return done.stdout


def main():
    ranks, program, options = int(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3:]
    make(ranks)
    call(["blockMesh"])
    if ranks == 1:
        print(call([program, *options]))
    else:
        call(["decomposePar", "-force"])
        print(call([*mpirun.COMMAND, "-np", str(ranks), program, "-parallel", *options]))


if __name__ == "__main__":
    main()
