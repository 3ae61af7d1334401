"""fix results as ParaView reads it: each component of a known stress is where its name says, in both of VTK's XDMF readers.

Two bonded spheres are pulled apart along n = (1 2 3)/√14: their stress is s n n, six different components of known ratio.
Needs a VTK with XDMF: the environment variable FRAZIL_PVPYTHON, `pvpython` in PATH, or the Python that runs this;
otherwise CTest skips it. Debian's is in the package python3-paraview (120 MB, 700 MB installed).
"""
import json
import shutil
from pathlib import Path

from bond_dem import *

N = unit([1, 2, 3])
STEPS = 20
NAMES = "xx xy xz yx yy yz zx zy zz".split()  # components 0 to 8 of VTK's tensors


def script():
    pull = "".join(f"group g{i} id {i}\nvelocity g{i} set {vec(scaled(N, 0.1 * side))} units box\n"
                   for i, side in ((1, -1), (2, 1)))
    return (head() + MODEL + spheres([scaled(N, -R), scaled(N, R)]) + "timestep 1e-7\n" + bond() +
            "fix nve all nve/sphere\n" + pull + f"fix out all results {STEPS} bonds bonds\nrun {STEPS}\n")


def read(path):
    """{reader: stress of each sphere}, by the first Python that can."""
    candidates = [os.environ.get("FRAZIL_PVPYTHON"), shutil.which("pvpython"), sys.executable]
    for python in filter(None, candidates):
        command = [python, Path(__file__).with_name("read_xdmf.py"), path, "stress"]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, timeout=120)
        if done.returncode == 0:
            return json.loads(done.stdout.splitlines()[-1])
        if done.returncode != 77:
            sys.exit(f"{python} failed on {path}: {done.returncode}")
    print("no VTK with XDMF readers: skipped")
    sys.exit(77)


check = Check()
run = check.run(script())
for reader, stress in read(os.path.join(run.folder, "particles.xdmf")).items():
    for sphere, components in enumerate(stress):
        check.true(f"{reader}, sphere {sphere}: components", len(components) == 9, str(len(components)))
        components += [0] * (9 - len(components))
        scale = sum(components[n] for n in (0, 4, 8))  # the trace, s
        check.true(f"{reader}, sphere {sphere}: tension", scale > 1, f"trace {scale:g} Pa")
        for n, name in enumerate(NAMES):
            i, j = ("xyz".index(letter) for letter in name)
            check.near(f"{reader}, sphere {sphere}, {name} of the trace", components[n] / scale, N[i] * N[j], 1e-6)
check.finish()
