"""fix results without a partner: the stress in the file is that of its own step; what it says to bad input."""

from bond_dem import *

try:
    import h5py
except ImportError:
    sys.exit(77)  # CTest: skipped

EVERY = 7
ASKEW = unit([1, 2, 3])


def script(more, thermo=1000):
    text = head(processors="* 1 1") + MODEL + spheres([[-R, 0, 0], [R, 0, 0]]) + "timestep 1e-7\n" + bond()
    text += f"fix nve all nve/sphere\nvelocity all set 0 0 0\ngroup right id 2\nvelocity right set 0.1 0 0\n{more}"
    return text + f"thermo {thermo}\nrun {5 * EVERY}\n"


def stress_of_its_step(check):
    """No thermo or dump asks for the stress on these steps; the dump of a second run does."""
    for ranks in (1, 2):
        file = check.run(script(f"fix out all results {EVERY} bonds bonds\n"), ranks=ranks)
        text = check.run(script(dump("d", EVERY, "f_bonds[3]")), ranks=ranks)
        with h5py.File(os.path.join(file.folder, "particles.h5")) as results:
            for step in range(EVERY, 5 * EVERY + 1, EVERY):
                group = results[f"particles/{step:012d}"]
                found = {int(i): row[0] for i, row in zip(group["id"][:], group["stress"][:])}
                for i, (reference,) in text.rows("d", step).items():
                    check.near(f"stress of sphere {i}, step {step}, {ranks} ranks", found[i], reference, 1e-12)


def full_tensor(check):
    """Nine components in the file, of the six in the bond fix's array; two spheres bonded askew have six different ones."""
    columns = " ".join(f"f_bonds[{n}]" for n in range(3, 9))
    motion = f"fix out all results {EVERY} bonds bonds\n" + dump("d", EVERY, columns)
    run = check.run(script(motion).replace(vec([-R, 0, 0]), vec(scaled(ASKEW, -R))).replace(vec([R, 0, 0]), vec(scaled(ASKEW, R))))
    with h5py.File(os.path.join(run.folder, "particles.h5")) as results:
        group = results[f"particles/{5 * EVERY:012d}"]
        found = dict(zip(group["id"][:], group["stress"][:]))
    for i, (xx, yy, zz, xy, xz, yz) in run.rows("d", 5 * EVERY).items():
        check.true(f"nine components of sphere {i}", list(found[i]) == [xx, xy, xz, xy, yy, yz, xz, yz, zz], str(found[i]))
        check.true(f"six of them differ, sphere {i}", len({round(value, 3) for value in found[i]}) == 6)
    with open(os.path.join(run.folder, "particles.xdmf")) as file:
        check.true("XDMF type", 'Name="stress" AttributeType="Tensor"' in file.read())


def times_after_a_restart(check):
    """Steps count on; so does the time, also from a restart file that a continued run wrote."""
    fixes = bond() + f"fix nve all nve/sphere\nfix out all results {EVERY} bonds bonds\n"
    text = head() + MODEL + spheres([[-R, 0, 0], [R, 0, 0]]) + "timestep 1e-7\n" + fixes
    run = check.run(text + f"run {EVERY}\nwrite_restart once\n")
    for file, steps in (("once", 2), ("twice", 1)):
        text = f"atom_style granular\nboundary f f f\nnewton off\ncommunicate single vel yes\nread_restart {file}\n"
        text += "neighbor 0.0005 bin\nneigh_modify delay 0\n" + MODEL + "timestep 1e-7\n" + fixes
        check.run(text + f"run {steps * EVERY}\nwrite_restart twice\n", folder=run.folder)
    with h5py.File(os.path.join(run.folder, "particles.h5")) as results:
        times = {int(step): group.attrs["time"] for step, group in results["particles"].items()}
    check.true("steps over two restarts", sorted(times) == [n * EVERY for n in range(5)], str(sorted(times)))
    for step, time in times.items():
        check.near(f"time of step {step}", time, step * 1e-7, 1e-12, scale=1e-7)


def bad_input(check):
    for words, said in (("", 'keyword "N" is missing'), ("0", "N 0: must be above zero"), ("nan", "N nan: is not a whole number"),
                        ("inf", "N inf: is not a whole number"), ("3000000000", "N 3000000000: is too large"),
                        (f"{EVERY} bons bonds", 'bons: unknown keyword (did you mean "bonds"?)'),
                        (f"{EVERY} file", "file: needs 1 value"), (f"{EVERY} file a file b", "file: stands twice")):
        run = check.run(script(f"fix out all results {words}\n"), expect_failure=True)
        check.true(f"results {words}", said in run.output, next((l for l in run.output.splitlines() if "ERROR" in l), ""))
    for keyword, style in (("fluid", "nve/sphere"), ("bonds", "nve/sphere")):
        run = check.run(script(f"fix out all results {EVERY} {keyword} nve\n"), ranks=2, expect_failure=True)
        check.true(f"{keyword} of another style", f"{keyword} nve: is a fix {style}, must be" in run.output)
    run = check.run(script(f"fix out all results {EVERY} bonds bons\n"), expect_failure=True)
    check.true("an ID almost right", 'bonds bons: there is no fix of this ID (did you mean "bonds"?)' in run.output)
    more = f"compute ke all ke/atom\nfix out all results {EVERY} fragment ke\n"
    run = check.run(script(more), ranks=2, expect_failure=True)
    check.true("fragment of another style", "fragment ke: is a compute ke/atom, must be a compute fragment" in run.output)


def failure_of_one_rank(check):
    """Only the first rank writes the XDMF file: a folder in its place must end the other rank too."""
    more = f"shell mkdir particles.xdmf\nfix out all results {EVERY}\n"
    run = check.run(script(more), ranks=2, expect_failure=True)
    check.true("XDMF file cannot be written", "cannot write particles.xdmf" in run.output)


check = Check()
stress_of_its_step(check)
full_tensor(check)
times_after_a_restart(check)
bad_input(check)
failure_of_one_rank(check)
check.finish()
