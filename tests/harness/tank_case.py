"""Small tanks for frazilFoam, alone (`coupling off`) or in a pair: meshes, dictionaries, fields."""

import pathlib

HEADER = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


def write(path, text, kind="dictionary"):
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(HEADER.format(kind=kind, name=path.name) + text)


def box_mesh(lo, hi, cells, grading="(1 1 1)"):
    """Dictionary of one block; the patch `top` is the +y face, all others `walls`."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    return f"""scale 1;
vertices (({x0} {y0} {z0}) ({x1} {y0} {z0}) ({x1} {y1} {z0}) ({x0} {y1} {z0})
          ({x0} {y0} {z1}) ({x1} {y0} {z1}) ({x1} {y1} {z1}) ({x0} {y1} {z1}));
blocks (hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} {cells[2]}) simpleGrading {grading});
edges ();
boundary
(
    top {{ type patch; faces ((3 7 6 2)); }}
    walls {{ type wall; faces ((0 4 7 3) (2 6 5 1) (1 5 4 0) (0 3 2 1) (4 5 6 7)); }}
);
"""


SCHEMES = """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes
{
    div(rhoPhi,U) Gauss linearUpwind grad(U);
    div(phi,alpha) Gauss vanLeer;
    div(phirb,alpha) Gauss linear;
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""

SOLUTION = """
solvers
{
    "alpha.water.*"
    {
        nAlphaCorr 1; nAlphaSubCycles 1; cAlpha 1;
        MULESCorr yes; nLimiterIter 5;
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-13; relTol 0;
    }
    "pcorr.*" { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 1e-5; maxIter 500; }
    "p_rgh.*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.001; maxIter 500; }
    "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-9; relTol 0; }
}
PIMPLE
{
    momentumPredictor yes; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0;
    pRefCell 0; pRefValue 0;
}
relaxationFactors { equations { ".*" 1; } }
"""


def control(end_time, delta_t, max_co=0.5, adjust="yes", write_interval=None):
    return f"""
application frazilFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {end_time}; deltaT {delta_t};
writeControl {"adjustableRunTime" if adjust == "yes" else "runTime"}; writeInterval {write_interval or end_time};
purgeWrite 0; writeFormat ascii; writePrecision 16; writeCompression off; timeFormat general; timePrecision 10;
runTimeModifiable no; adjustTimeStep {adjust}; maxCo {max_co}; maxAlphaCo {max_co}; maxDeltaT 1;
"""


def water_and_air(surface_tension=0.0725):
    return f"""
phases (water air);
water {{ transportModel Newtonian; nu 1.79e-6; rho 1000; }}
air {{ transportModel Newtonian; nu 1.314e-5; rho 1.294; }}
sigma {surface_tension};
"""


# Keys of the exchange, which may stay in the file while it is off
LEFT = """coarseGrid { min (0 0 0); max (1 1 1); cellSize 0.1; } dualGrid on; kernel trilinear; watchdog 600;
prolongation { exponent 2; limiter cell; } voidFraction { min 0.25; } momentumExchange on;
forces { drag DiFelice; pressureGradient on; viscous on; addedMass on; rotationalDrag off; shielding off; }
"""


def write_case(case, mesh, surface_y, times, bodies, gravity=9.81, top="open", sigma=0.0725, extra=""):
    """A tank of water up to surface_y [m] (None: full) with an open or closed top and the bodies' dictionary text."""
    case = pathlib.Path(case)
    write(case / "system/blockMeshDict", mesh)
    write(case / "system/fvSchemes", SCHEMES)
    write(case / "system/fvSolution", SOLUTION)
    write(case / "system/controlDict", times)
    write(case / "system/decomposeParDict", "numberOfSubdomains 2; method hierarchical; coeffs { n (2 1 1); }\n")
    write(case / "constant/transportProperties", water_and_air(sigma))
    write(case / "constant/turbulenceProperties", "simulationType laminar;\n")
    write(case / "constant/g", f"dimensions [0 1 -2 0 0 0 0]; value (0 {-gravity} 0);\n", "uniformDimensionedVectorField")
    write(case / "constant/couplingProperties", f"coupling off;\n{LEFT}bodies {{ {bodies} }}\n{extra}")
    air_inlet = 1 if surface_y is None else 0
    slip, flux, gradient = "type slip;", "type fixedFluxPressure; value uniform 0;", "type zeroGradient;"
    at_top = {
        "open": ("type pressureInletOutletVelocity; value uniform (0 0 0);", "type totalPressure; p0 uniform 0;",
                 f"type inletOutlet; inletValue uniform {air_inlet}; value uniform {air_inlet};"),
        "closed": (slip, flux, gradient),
    }[top]
    patches = "boundaryField {{ top {{ {} }} walls {{ {} }} }}\n"
    write(case / "0/U", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); "
          + patches.format(at_top[0], slip), "volVectorField")
    write(case / "0/p_rgh", "dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0; "
          + patches.format(at_top[1], flux), "volScalarField")
    write(case / "0/alpha.water", f"dimensions [0 0 0 0 0 0 0]; internalField uniform {air_inlet}; "
          + patches.format(at_top[2], gradient), "volScalarField")
    if surface_y is not None:
        write(case / "system/setFieldsDict", f"""defaultFieldValues (volScalarFieldValue alpha.water 0);
regions (boxToCell {{ box (-10 -10 -10) (10 {surface_y} 10); fieldValues (volScalarFieldValue alpha.water 1); }});
""")
    return case
