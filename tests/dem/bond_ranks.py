"""An HCP plate struck by a heavy ball: the same cracks on 1, 2 and 4 ranks, after split runs and after restarts.

The ball hits where the rank boundaries of 2 x 1 and 2 x 2 cross. Over 5,000 steps through the first cracks the set of
broken bonds, their modes and steps must be equal and positions agree to 1e-9 D.
"""

import math

from bond_dem import *

# LIGGGHTS's contact laws evaluate damping with another velocity, and friction without a step, when a run is set up: with
# them no continued run equals an unbroken one. Without damping and friction the contacts are a function of position,
# so any difference would be the bonds'.
MEMORYLESS = MODEL.replace("peratomtypepair 1 0.5", "peratomtypepair 1 1.0").replace("tangential history", "tangential off")
DT = 1e-7
STEPS = 5000
BOX = "-0.001 0.031 -0.001 0.031 -0.01 0.02"
PLATE = hcp(12, 13, 3)
FILES = {"plate.data": data([(c, D, RHO) for c in PLATE] + [([0.0149, 0.0151, 0.0085], 0.006, 7000.0)], BOX)}
GROUPS = f"""
group ball id {len(PLATE) + 1}
group ice subtract all ball
velocity ball set 0 0 -20 units box
"""


def fixes():
    text = bond("ice", tensile=SIGMA_C, shear=TAU_C, more="events events.csv")
    text += "compute fragments ice fragment bonds\nfix nve all nve/sphere\n" + f"timestep {DT}\n"
    text += "thermo_style custom step f_bonds[1] f_bonds[2] f_bonds[3] f_bonds[4] f_bonds[5] f_bonds[6] c_fragments[1] c_fragments[2]\n"
    text += "thermo 500\nthermo_modify lost ignore format float %.12g\n"
    return text + dump("d", STEPS // 2, "x y z f_bonds[1] f_bonds[2] f_bonds[3] c_fragments")


def start(processors, model=MODEL):
    return head(BOX, processors, 0.0004, "plate.data") + model + GROUPS + fixes()


def again(processors):
    """Continues from the restart file."""
    text = f"atom_style granular\nboundary f f f\nnewton off\ncommunicate single vel yes\nprocessors {processors}\n"
    text += "read_restart half.restart\nneighbor 0.0004 bin\nneigh_modify delay 0\n" + MEMORYLESS + fixes()
    return text + f"run {STEPS // 2}\n"


def broken(run):
    return sorted((float(e["time"]), int(e["id1"]), int(e["id2"]), e["mode"]) for e in run.events())


def compare(check, what, run, reference):
    mine, theirs = broken(run), broken(reference)
    same = [(round(t / DT), *rest) for t, *rest in mine] == [(round(t / DT), *rest) for t, *rest in theirs]
    check.true(f"{what}: broken bonds", same and len(mine) > 50, f"{len(mine)} of {len(theirs)}, ids, modes and steps equal: {same}")
    ours, refs = run.rows("d", STEPS), reference.rows("d", STEPS)
    far = max(norm(add(ours[i][:3], refs[i][:3], -1)) for i in refs) / D if ours.keys() == refs.keys() else math.inf
    check.true(f"{what}: positions", far <= 1e-9, f"{far:.1e} D <= 1e-9 D")
    check.true(f"{what}: fragments, bonds per sphere", all(ours[i][3:5] + ours[i][6:] == refs[i][3:5] + refs[i][6:] for i in refs), "equal")
    stress = max(abs(ours[i][5] - refs[i][5]) for i in refs) / SIGMA_C
    check.true(f"{what}: stress", stress <= 1e-6, f"{stress:.1e} sigma_c <= 1e-6")
    check.true(f"{what}: totals", run.thermo()[-1][1:5] == reference.thermo()[-1][1:5], str(run.thermo()[-1]))


def deletion(check):
    """Spheres that leave take their bonds with them, and the log says how many."""
    script = start("* * 1").replace("events events.csv", "") + "region out block 0.02 INF INF INF INF INF units box\n"
    script += "run 100\ngroup gone region out\ndelete_atoms group gone compress no\nrun 100\n"
    counts = set()
    for ranks in (1, 4):
        run = check.run(script, ranks=ranks, files=FILES)
        first, last = run.thermo()[0][1:3], run.thermo()[-1][1:3]
        lost = sum(int(line.split(":")[1].split()[0]) for line in run.output.splitlines() if "went with particles" in line)
        counts.add(lost)
        printed = run.output.count("went with particles")
        check.true(f"deletion on {ranks} ranks", lost > 0 and printed >= 1 and first[0] - last[0] - last[1] == lost,
                   f"{first[0]:g} bonds, {last[0]:g} left, {last[1]:g} broken, log says {lost:g} went with particles")
    check.true("deletion: same count on 1 and 4 ranks", len(counts) == 1, str(counts))


def leaving(check):
    """A struck plate loses spheres through the sides of its box: their bonds are counted as gone, the others go on."""
    script = start("* * 1").replace("events events.csv", "") + "group flier id 1:12\nvelocity flier set 0 -40 0 units box\n"
    script += f"run {STEPS}\n"
    results = []
    for ranks in (1, 4):
        run = check.run(script, ranks=ranks, files=FILES)
        first, last = run.thermo()[0][1:3], run.thermo()[-1][1:3]
        lost = sum(int(line.split(":")[1].split()[0]) for line in run.output.splitlines() if "went with particles" in line)
        gone = len(FILES["plate.data"].splitlines()) - 11 - len(run.rows("d", STEPS))
        check.true(f"leaving the box on {ranks} ranks", lost > 0 and first[0] - last[0] - last[1] == lost,
                   f"{gone} spheres and {lost} bonds left, {last[1]:g} broken, {last[0]:g} of {first[0]:g} are there")
        results.append((lost, *last))
    check.true("leaving the box: the same on 1 and 4 ranks", results[0] == results[1], str(results))


def main():
    check = Check()
    reference = check.run(start("1 1 1") + f"run {STEPS}\n", files=FILES)
    for ranks, processors in ((2, "2 1 1"), (4, "2 2 1")):
        compare(check, f"{ranks} ranks", check.run(start(processors) + f"run {STEPS}\n", ranks=ranks, files=FILES), reference)
    reference = check.run(start("1 1 1", MEMORYLESS) + f"run {STEPS}\n", files=FILES)
    split = f"run {STEPS // 10}\nrun {STEPS // 5}\nrun {STEPS - STEPS // 10 - STEPS // 5}\n"
    compare(check, "split runs on 2 ranks", check.run(start("1 2 1", MEMORYLESS) + split, ranks=2, files=FILES), reference)
    half = check.run(start("2 1 1", MEMORYLESS) + f"run {STEPS // 2}\nwrite_restart half.restart\n", ranks=2, files=FILES)
    for ranks, processors in ((1, "1 1 1"), (4, "2 2 1")):
        folder = half.folder + f"_restarted_{ranks}"
        shutil.copytree(half.folder, folder)
        compare(check, f"restart of 2 ranks on {ranks}", check.run(again(processors), ranks=ranks, folder=folder), reference)
    written = start("2 1 1", MEMORYLESS) + f"restart {STEPS // 7} on_the_way.*\nrun {STEPS}\n"
    compare(check, "restart files written on the way", check.run(written, ranks=2, files=FILES), reference)
    deletion(check)
    leaving(check)
    check.finish()


main()
