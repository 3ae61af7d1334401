"""Options of fix bond/parallel that decide which bonds there are and how strong each is.

list      the pairs of a file give the same structure as the gap, on 1, 2 and 4 ranks; mistakes are told with their line
groups    two floes that touch do not freeze together, unless one fix is given both
weibull   the strengths measured on many pairs have mean 1 and the modulus asked for; the same on 2 ranks
"""

import math
import random
import statistics

from bond_dem import *

BOX = "-0.02 0.02 -0.02 0.02 -0.02 0.02"
L = 1.004 * D


def neighbours(points):
    """Pairs of ids of spheres that touch."""
    return [(i + 1, j + 1) for i in range(len(points)) for j in range(i) if math.dist(points[i], points[j]) < 1.001 * D]


def struck(check, points, bonds, ranks, files=None):
    """Positions and thermo after 500 steps of a lump with one sphere struck."""
    script = head(skin=0.0005, data_file="lump.data") + MODEL + "timestep 1e-7\n" + bonds
    script += "fix integrate all nve/sphere\ngroup one id 1\nvelocity one set 3 5 7\n"
    script += dump("d", 500, "x y z") + "thermo_style custom step f_bonds[1] f_bonds[2]\nrun 500\n"
    box = data([(p, D, RHO) for p in points], BOX)
    run = check.run(script, ranks=ranks, files={"lump.data": box, **(files or {})})
    return run.rows("d", 500), run.thermo()[-1][1:]


def listed(check):
    points = hcp(6, 5, 3)
    pairs = neighbours(points)
    random.Random(1).shuffle(pairs)
    lines = ["# pairs", ""] + [f"{j} {i}  # {n}" if n % 2 else f"{i} {j}" for n, (i, j) in enumerate(pairs)]
    files = {"pairs.txt": "\n".join(lines) + "\n"}
    strong = dict(tensile=SIGMA_C, shear=TAU_C)
    expected, counts = struck(check, points, bond(**strong), 1)
    check.true("gap bonds every touching pair", sum(counts) == len(pairs) and counts[1] > 0, f"{counts} of {len(pairs)}")
    for ranks in (1, 2, 4):
        rows, others = struck(check, points, bond(more="list pairs.txt", **strong), ranks, files)
        shift = max(math.dist(rows[i], expected[i]) for i in expected) / D
        check.true(f"list on {ranks}: the same structure", others == counts and shift < 1e-9, f"{others}, within {shift:.1e} D")


MISTAKES = {
    "no pair of ids": ("1 2\n1 x\n", ["pairs.txt, line 2", "'1 x'", "two whole numbers"]),
    "three numbers": ("1 2 3\n", ["line 1", "'1 2 3'"]),
    "with itself": ("2 2\n", ["line 1", "sphere 2 with itself"]),
    "twice": ("1 2\n\n2 1\n", ["line 3", "1 2", "line 1", "once"]),
    "unknown": ("1 2\n2 9\n", ["line 2", "2 and 9", "do not both exist"]),
    "not in the group": ("1 2\n2 3\n", ["line 2", "2 and 3", "group"]),
    "far apart": ("1 4\n", ["line 1", "1 and 4", "cutoff"]),
    "empty": ("# nothing\n", ["no pair"]),
}


def mistakes(check):
    centres = [[-0.015, 0, 0], [L - 0.015, 0, 0], [2 * L - 0.015, 0, 0], [0.015, 0, 0]]
    text = head(processors="2 1 1") + MODEL + spheres(centres) + "timestep 1e-7\ngroup ice id 1 2 4\n"
    for name, (lines, words) in MISTAKES.items():
        script = text + bond(group="ice", more="list pairs.txt") + "run 1\n"
        run = check.run(script, ranks=2, expect_failure=True, files={"pairs.txt": lines})
        message = next((line for line in run.output.splitlines() if "ERROR" in line), "")
        check.true(f"list, {name}", all(word in message for word in words), message)
    for more, words in (("list nowhere.txt", ["nowhere.txt", "cannot be read"]),
                        ("list pairs.txt create_gap 0.02", ["list pairs.txt", "create_gap", "one of the two"])):
        run = check.run(text + bond(more=more) + "run 1\n", ranks=2, expect_failure=True)
        message = next((line for line in run.output.splitlines() if "ERROR" in line), "")
        check.true(more, all(word in message for word in words), message)


def groups(check):
    """The right floe is a copy of the left one, touching it, and drifts away."""
    left = hcp(4, 4, 2)
    right = [add(p, [4 * D, 0, 0]) for p in left]
    each, both = len(neighbours(left)), len(neighbours(left + right))
    text = head(skin=0.0005, data_file="floes.data") + MODEL + f"timestep 1e-7\ngroup left id <= {len(left)}\n"
    text += "group right subtract all left\n"
    drift = "fix integrate all nve/sphere\nvelocity right set 10 0 0\n"
    thermo = "thermo_style custom step f_a[1] f_a[2] f_{b}[1] f_{b}[2]\nrun 300\n"
    files = {"floes.data": data([(p, D, RHO) for p in left + right], BOX)}
    apart = text + bond("left", "a", tensile=SIGMA_C, shear=TAU_C, more="events a.csv")
    apart += bond("right", "b", tensile=SIGMA_C, shear=TAU_C, more="events b.csv") + drift + thermo.format(b="b")
    for ranks in (1, 2):
        row = check.run(apart, ranks=ranks, files=files).thermo()[-1][1:]
        check.true(f"two floes on {ranks}: bonds within each, none breaks", row == [each, 0, each, 0], f"{row}, each {each}")
    one = text + bond("all", "a", tensile=SIGMA_C, shear=TAU_C) + drift + thermo.format(b="a")
    row = check.run(one, files=files).thermo()
    check.true("one fix for both freezes them together", sum(row[0][1:3]) == both and row[-1][2] > 0, f"{row[-1]}, all {both}")


def strengths(check, modulus, ranks):
    """Measured strength over the mean one of 400 pairs that are pulled apart, by id."""
    side, steps, dt = 20, 2000, 1e-8
    origin = -0.5 * 3 * D * (side - 1)
    centres = [[origin + 3 * D * i, origin + 3 * D * j, 0] for j in range(side) for i in range(side)]
    pairs = [(p, D, RHO) for c in centres for p in (c, add(c, [0, 0, L]))]
    speed = 2.5 * SIGMA_C / E * L / (steps * dt)
    low, high = origin - D, -origin + D
    box = f"{low} {high} {low} {high} -0.01 0.01"
    script = head(data_file="pairs.data") + MODEL + f"timestep {dt}\n"
    script += bond(tensile=SIGMA_C, more=f"weibull {modulus} 7 events events.csv")
    script += "region top block INF INF INF INF 0.001 INF units box\ngroup top region top\ngroup bottom subtract all top\n"
    script += f"fix a bottom move linear 0 0 0\nfix b top move linear 0 0 {speed:.17g}\nrun {steps}\n"
    events = check.run(script, ranks=ranks, files={"pairs.data": data(pairs, box)}).events()
    return {int(e["id1"]): float(e["sigma"]) / SIGMA_C for e in events}


def weibull(check):
    modulus = 8
    factors = strengths(check, modulus, 1)
    check.true("weibull: every pair breaks", len(factors) == 400, str(len(factors)))
    values = list(factors.values())
    scatter = math.sqrt(math.gamma(1 + 2 / modulus) / math.gamma(1 + 1 / modulus)**2 - 1)
    check.near("weibull: mean", statistics.mean(values), 1, 3 * scatter / math.sqrt(400))
    check.near("weibull: relative scatter of modulus 8", statistics.stdev(values), scatter, 0.15)
    check.true("weibull: the same on 2 ranks", strengths(check, modulus, 2) == factors)


def main():
    check = Check()
    listed(check)
    mistakes(check)
    groups(check)
    weibull(check)
    check.finish()


main()
