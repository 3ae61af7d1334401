"""Immersed bodies on a real mesh: guarantees, volumes and wet fractions, the same on 1, 2 and 4 ranks; input errors.

run.py CASE PROGRAM    CASE: ranks | wet | errors | cost
"""
import math
import os
import re
import subprocess
import sys

import mpirun
import tank_case
from surfaces import revolve, write_stl

D = 0.016


def foam(case, path, text):
    tank_case.write(os.path.join(case, path), text)


def sphere(centre, rings=48):
    angles = [math.pi * i / rings for i in range(rings + 1)]
    profile = [(D / 2 * math.sin(a) if 0 < i < rings else 0, -D / 2 * math.cos(a)) for i, a in enumerate(angles)]
    return revolve(profile, 2 * rings, centre, axis=2)


def cone(centre, length=0.024):
    h = D / 2 / math.sqrt(3)
    return revolve([(0, 0), (D / 2, h), (D / 2, length), (0, length)], 96, centre, axis=2)


def make(case, bodies, cells=40, edge=0.04, extra="", velocity="(3 2 -20)", omega="(100 50 30)"):
    half = edge / 2
    foam(case, "system/controlDict", "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 0.001;\n"
         "writeControl timeStep; writeInterval 1000; writePrecision 12; timePrecision 6;\n")
    foam(case, "system/fvSchemes", "gradSchemes{} divSchemes{} laplacianSchemes{}\n")
    foam(case, "system/fvSolution", "\n")
    foam(case, "system/blockMeshDict", f"""scale 1;
vertices ((-{half} -{half} 0) ({half} -{half} 0) ({half} {half} 0) (-{half} {half} 0)
          (-{half} -{half} {edge}) ({half} -{half} {edge}) ({half} {half} {edge}) (-{half} {half} {edge}));
blocks (hex (0 1 2 3 4 5 6 7) ({cells} {cells} {cells}) simpleGrading (1 1 1));
edges (); boundary (); defaultPatch {{ name walls; type wall; }}
""")
    entries = ""
    for name, triangles in bodies.items():
        write_stl(os.path.join(case, "constant/triSurface", name + ".stl"), triangles)
        entries += f'{name} {{ surface "constant/triSurface/{name}.stl"; {extra} }}\n'
    foam(case, "constant/couplingProperties", f"velocity {velocity}; omega {omega}; bodies {{ {entries} }}\n")
    call(["blockMesh", "-case", case])


def call(command, expect=0):
    done = subprocess.run(command, env=mpirun.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if (done.returncode == 0) != (expect == 0):
        print(done.stdout[-4000:])
        sys.exit(f"FAILED: {' '.join(command)} ended with {done.returncode}")
    return done.stdout


def sums(output):
    return [[float(x) for x in line.split()[1:]] for line in output.splitlines() if line.startswith("sums ")]


def on_ranks(case, program, ranks, *options):
    if ranks == 1:
        return call([program, "-case", case, *options])
    split = {2: "(1 1 2)", 4: "(2 1 2)"}[ranks]
    foam(case, "system/decomposeParDict",
         f"numberOfSubdomains {ranks}; method hierarchical; coeffs {{ n {split}; delta 0.001; order xyz; }}\n")
    call(["decomposePar", "-case", case, "-force"])
    return call([*mpirun.COMMAND, "-np", str(ranks), program, "-case", case, "-parallel", *options])


def check(holds, what):
    print(("ok      " if holds else "FAILED  ") + what)
    if not holds:
        sys.exit(1)


def same_on_ranks(program):
    """Two bodies, turning, one of them on its way to the boundary: guarantees hold, sums do not depend on the ranks."""
    make("ranks", {"ball": sphere((-0.009, 0, 0.024)), "cone": cone((0.0088, 0.001, 0.008))}, cells=30)
    reference = None
    for ranks in (1, 2, 4):
        for options in ([], ["-refine"]):
            got = sums(on_ranks("ranks", program, ranks, "-steps", "20", *options))
            check(len(got) == 21, f"{ranks} ranks {options}: 21 poses")
            reference = reference or got
            scale = [max(abs(row[i]) for row in reference) for i in range(len(reference[0]))]
            worst = max(abs(a - b) / max(s, 1e-30) for x, y in zip(got, reference) for a, b, s in zip(x, y, scale))
            check(worst < 1e-8, f"{ranks} ranks {options}: sums as on one rank (worst {worst:.1e} of the largest)")
    exact = reference[0][8] + reference[0][11]
    defect = max(abs(row[0] / exact - 1) for row in reference)
    check(defect < 1e-12, f"sum of gamma V is the volume of the surfaces (worst {defect:.1e})")


def wet(program):
    """A sphere across the surface z = 0.02: its wet fraction is that of the cap; and it rises smoothly with depth."""
    for offset in (-0.006, -0.003, 0.0, 0.003, 0.0072):
        make("wet", {"ball": sphere((0, 0, 0.02 - offset))}, velocity="(0 0 0)", omega="(0 0 0)")
        got = sums(on_ranks("wet", program, 1, "-steps", "0"))[0]
        h = D / 2 + offset
        cap = math.pi * h * h * (D * 1.5 - h) / 3 / (math.pi * D**3 / 6)
        check(abs(got[10] - cap) < 0.03, f"centre {1000 * offset:.1f} mm below water: wet {got[10]:.4f}, cap {cap:.4f}")


def errors(program):
    """Each mistake ends the program with a message that names it."""
    def refused(bodies, words, extra="", options=()):
        make("errors", bodies, cells=10, extra=extra)
        message = call([program, "-case", "errors", "-steps", "1", *options], expect=1)
        if not all(w in message for w in words):
            print(message[-1500:])
        check(all(w in message for w in words), f"refused with {words}")
    good = sphere((0, 0, 0.02), 12)
    refused({"ball": good[:-1]}, ["not closed", "bodies.ball", "open edges"])
    refused({"ball": good}, ["slipp", "slip"], extra="slipp yes;")
    refused({"ball": sphere((0, 0, 20), 12)}, ["no part of the body is inside the mesh", "20"])
    refused({"ball": good}, ["lattice"], extra="lattice -1;")
    refused({"ball": good}, ["cellSize"], extra="cellSize 0;")
    needle = revolve([(0, 0), (0.0003, 0.0003), (0.0003, 0.02), (0, 0.02)], 8, (0.0014, 0.0014, 0.01), axis=2)
    refused({"needle": needle}, ["bodies.needle", "finer mesh"])
    thin = revolve([(0, 0), (0.006, 0.0001), (0.006, 0.0021), (0, 0.002)], 24, (0.0005, 0.0007, 0.0208), axis=2)
    refused({"disc": thin}, ["bodies.disc", "Refine the mesh"])
    make("errors", {"ball": good}, cells=10)
    os.remove("errors/constant/triSurface/ball.stl")
    message = call([program, "-case", "errors", "-steps", "0"], expect=1)
    check("cannot be opened" in message and "ball.stl" in message, "refused: surface not found")


def cost(program):
    """16 cells per diameter: milliseconds per step (printed, not judged: machines differ)."""
    make("cost", {"cone": cone((0, 0, 0.008))}, omega="(0 0 0)", velocity="(3 2 -1)")
    output = on_ranks("cost", program, 1, "-steps", "40")
    print(re.search(r"CPU time per step.*", output).group(0))
    rows = sums(output)
    cut = [row[9] / row[8] - 1 for row in rows]
    print(f"volume cut / volume - 1: {min(cut):+.5f} to {max(cut):+.5f}")
    check(max(cut) - min(cut) < 2e-3, "volume as cut changes by less than 0.2 % while crossing cells")


if __name__ == "__main__":
    {"ranks": same_on_ranks, "wet": wet, "errors": errors, "cost": cost}[sys.argv[1]](os.path.abspath(sys.argv[2]))
