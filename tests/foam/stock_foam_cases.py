#!/usr/bin/env python3
"""Cases of stock_foam.py: tutorials below tutorials/multiphase/interFoam, prepared as their own Allrun does, shortened.

Run as a program it prints their names, for ctest. What OpenFOAM v1912 cannot run reliably is no case: solitary waves
(solitary, solitaryGrimshaw, solitaryMcCowan, mangroveInteraction), whose model keeps a reference to a temporary, and
tutorials whose geometry is not among them (DTCHullMoving, motorBike, mixerVesselAMI).
"""

import dataclasses

MESH_AND_FIELDS = ("blockMesh", "setFields")
M4_MESH_AND_FIELDS = ("m4 system/blockMeshDict.m4 > system/blockMeshDict",) + MESH_AND_FIELDS
SOLUTION, SCHEMES, BLOCKS = "system/fvSolution", "system/fvSchemes", "system/blockMeshDict"


@dataclasses.dataclass(frozen=True)
class Stock:
    """A tutorial, how to prepare it and where to stop. Two end times: the run stops at the first and is continued."""

    tutorial: str
    covers: str
    end: tuple
    prepare: tuple = MESH_AND_FIELDS  # shell commands
    control: dict = dataclasses.field(default_factory=dict)  # entries of controlDict
    edits: tuple = ()  # (file, text, its replacement), before the preparation
    flags: tuple = ()  # of every program
    split: str = "2 1 1"  # ranks along x, y, z
    early: float = 0  # when to compare with the installed interFoam too; the end is a multiple of it


def dam(covers, end=(0.1,), early=0.01, **options):
    """A variant of the laminar dam break (MULESCorr yes, Euler), the cheapest of the tutorials."""
    return Stock("laminar/damBreak/damBreak", covers, end, early=early, **options)


EULER = "default         Euler;"
MULES_CORR = "MULESCorr       yes;"
SUB_CYCLES = "nAlphaSubCycles 1;"
OUTER = "nOuterCorrectors    1;"

CASES = {
    "damBreak": dam("MULESCorr, 2 alpha correctors"),
    "damBreak_subCycles": dam("explicit MULES in 3 sub-cycles", edits=(
        (SOLUTION, SUB_CYCLES, "nAlphaSubCycles 3;"),
        (SOLUTION, MULES_CORR, "MULESCorr no;"))),
    "damBreak_prevCorr": dam("MULESCorr in 2 sub-cycles, alphaApplyPrevCorr, icAlpha, scAlpha", edits=(
        (SOLUTION, SUB_CYCLES, "nAlphaSubCycles 2; icAlpha 0.2; scAlpha 0.1;"),
        (SOLUTION, MULES_CORR, "MULESCorr yes; alphaApplyPrevCorr yes;"))),
    "damBreak_crankNicolson": dam("Crank-Nicolson 0.9, continued from its own fields", end=(0.06, 0.1), edits=(
        (SCHEMES, EULER, "default CrankNicolson 0.9;"),)),
    "damBreak_pimple": dam("2 outer correctors, momentum predictor, explicit MULES", edits=(
        (SOLUTION, OUTER, "nOuterCorrectors 2;"),
        (SOLUTION, "momentumPredictor   no;", "momentumPredictor yes;"),
        (SOLUTION, "    U\n", "    \"U.*\"\n"),
        (SOLUTION, MULES_CORR, "MULESCorr no;"))),
    "damBreak_localEuler": dam("local time steps, explicit MULES in 2 sub-cycles", end=(40,), early=4, edits=(
        (SCHEMES, EULER, "default localEuler;"),
        (SOLUTION, SUB_CYCLES, "nAlphaSubCycles 2;"),
        (SOLUTION, MULES_CORR, "MULESCorr no;")),
        control={"deltaT": 1, "adjustTimeStep": "no"}),
    "damBreakRas": Stock("RAS/damBreak/damBreak", "kEpsilon", (0.1,), early=0.01),
    "damBreakPorousBaffle": Stock("RAS/damBreakPorousBaffle", "baffles, 3 outer correctors", (0.05,),
        MESH_AND_FIELDS + ("createBaffles -overwrite",), early=0.01),
    "damBreakWithObstacle": Stock("laminar/damBreakWithObstacle", "refined mesh, correctPhi, 3 sub-cycles", (0.03,),
        ("blockMesh", "topoSet", "subsetMesh -overwrite c0 -patch walls", "setFields"),
        edits=((BLOCKS, "(32 32 32)", "(16 16 16)"),), early=0.01),
    "capillaryRise": Stock("laminar/capillaryRise", "contact angle, 2 sub-cycles", (0.001,),
        edits=((BLOCKS, "(20 400 1)", "(20 200 1)"),)),
    "mixerVessel2D": Stock("laminar/mixerVessel2D", "rotating frame (MRF)", (0.02,),
        ("m4 system/blockMeshDict.m4 > system/blockMeshDict", "blockMesh", "topoSet", "setsToZones -noFlipMap",
         "setFields")),
    "testTubeMixer": Stock("laminar/testTubeMixer", "rigidly moving mesh, 3 sub-cycles", (0.02,)),
    "sloshingTank2D": Stock("laminar/sloshingTank2D", "tank without an outlet moved by a table", (0.3,),
        M4_MESH_AND_FIELDS),
    "sloshingTank3D6DoF": Stock("laminar/sloshingTank3D6DoF", "the same in 3-D with 6 degrees of freedom", (0.05,),
        M4_MESH_AND_FIELDS),
    "floatingObject": Stock("RAS/floatingObject", "floating body, deforming mesh, Crank-Nicolson 0.5, RAS", (0.05,),
        ("blockMesh", "topoSet", "subsetMesh -overwrite c0 -patch floatingObject", "setFields"),
        edits=((BLOCKS, "(20 20 30)", "(15 15 20)"),)),
    "stokesI": Stock("laminar/waves/stokesI", "wave inlet and absorbing outlet, 3 sub-cycles", (1,),
        edits=((BLOCKS, "(500 1 75)", "(125 1 25)"),)),
    "waveMakerFlap": Stock("laminar/waves/waveMakerFlap", "wave maker: a wall that moves", (0.2,),
        edits=((BLOCKS, "(200 1 140)", "(50 1 35)"),)),
    "weirOverflow": Stock("RAS/weirOverflow", "inflow, kEpsilon, 2 sub-cycles", (0.1,)),
    "waterChannel": Stock("RAS/waterChannel", "extruded mesh, inflow, kOmegaSST", (2,),
        ("blockMesh",
         "for i in 1 2; do cp system/extrudeMeshDict.$i system/extrudeMeshDict && extrudeMesh || exit; done",
         "setFields")),
    "angledDuct": Stock("RAS/angledDuct", "porous zone, inflow, kEpsilon", (0.02,),
        ("m4 system/blockMeshDict.m4 > system/blockMeshDict", "blockMesh")),
    "nozzleFlow2D": Stock("LES/nozzleFlow2D", "LES, refined mesh, 4 sub-cycles, surface tension", (1e-7,),
        edits=((BLOCKS, "(75 30 1)", "(38 15 1)"), (BLOCKS, "(75 40 1)", "(38 20 1)"),
               (BLOCKS, "(75 15 1)", "(38 8 1)")),
        prepare=("blockMesh", "for i in 1 2; do topoSet -dict system/topoSetDict.$i"
                      " && refineMesh -dict system/refineMeshDict -overwrite || exit; done")),
    "DTCHull": Stock("RAS/DTCHull", "local time steps, kOmegaSST, alphaApplyPrevCorr; no hull in it", (20,),
        edits=((BLOCKS, "(42 19 50)", "(21 10 20)"), (BLOCKS, "(42 19 4)", "(21 10 4)"),
               (BLOCKS, "(42 19 40)", "(21 10 16)"), (BLOCKS, "(42 19 20)", "(21 10 8)")),
        early=2, flags=("-noFunctionObjects",)),
}


if __name__ == "__main__":
    print(*CASES, sep="\n")
