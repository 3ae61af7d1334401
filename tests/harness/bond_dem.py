"""Runs frazilDem on short generated scripts: common ground of the bond_*.py checks. SI units throughout."""

import argparse
import glob
import math
import os
import shutil
import subprocess
import sys
import tempfile

import dem_script
import mpirun

D = 0.0024  # sphere diameter [m], ice of the paper
R = D / 2
RHO = 900.0  # [kg/m3]
E = 0.5e9  # bond modulus [Pa]
KAPPA = 2.66  # kn/ks
SIGMA_C = 1.2e6  # [Pa]
TAU_C = 0.8e6  # [Pa]
MASS = RHO * math.pi * D**3 / 6
A = math.pi * R**2
I = A * R**2 / 4
J = 2 * I
STRONG = 1e30  # [Pa], a bond that never breaks

MODEL = dem_script.contacts(young="5e8", poisson=0.33, restitution=0.5, friction=0.2)


def vec(text):
    return " ".join("%.17g" % c for c in text)


def add(a, b, scale=1.0):
    return [p + scale * q for p, q in zip(a, b)]


def scaled(a, s):
    return [s * p for p in a]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return scaled(a, 1 / norm(a))


def across(n):
    """A unit vector perpendicular to n."""
    return unit(cross(n, [0.3, -0.5, 0.81] if abs(n[0]) > 0.5 else [1.0, 0.2, 0.1]))


DIRECTIONS = {"x": [1, 0, 0], "face diagonal": unit([1, 0, 1]), "random": unit([0.351, -0.772, 0.529])}


def head(box="-0.02 0.02 -0.02 0.02 -0.02 0.02", processors="* * *", skin=0.0005, data_file=None):
    sides = box.split()
    create = f"read_data {data_file}" if data_file else dem_script.box(sides[::2], sides[1::2])
    return dem_script.setting(create, processors=processors, skin=skin)


def bond(group="all", name="bonds", young=E, kappa=KAPPA, tensile=STRONG, shear=STRONG, more=""):
    return (
        f"fix {name} {group} bond/parallel young {young:.17g} stiffness_ratio {kappa:.17g} "
        f"tensile_strength {tensile:.17g} shear_strength {shear:.17g} {more}\n"
    )


def spheres(centres):
    lines = [f"create_atoms 1 single {vec(c)} units box" for c in centres]
    return "\n".join(lines) + f"\nset group all diameter {D} density {RHO}\n"


def data(spheres, box):
    """A data file, whose ids do not depend on the ranks as those of create_atoms do: (centre, diameter, density)."""
    low_high = box.split()
    lines = ["spheres", "", f"{len(spheres)} atoms", "1 atom types", ""]
    lines += [f"{low_high[2 * k]} {low_high[2 * k + 1]} {a}lo {a}hi" for k, a in enumerate("xyz")] + ["", "Atoms", ""]
    lines += [f"{i + 1} 1 {d:.17g} {rho:.17g} {vec(c)}" for i, (c, d, rho) in enumerate(spheres)]
    return "\n".join(lines) + "\n"


def hcp(nx, ny, nz):
    """Layers of nx x ny spheres stacked along z, touching."""
    row, layer = D * math.sqrt(3) / 2, D * math.sqrt(2 / 3)
    shift = lambda j, k: (0.5 * D * ((j + k) % 2), row / 3 * (k % 2))
    return [[i * D + shift(j, k)[0], j * row + shift(j, k)[1], k * layer] for k in range(nz) for j in range(ny) for i in range(nx)]


def dump(name, every, columns, group="all"):
    columns = "id " + columns
    form = " ".join(["%d"] + ["%.17g"] * (len(columns.split()) - 1))
    return f'dump {name} {group} custom {every} {name}.*.txt {columns}\ndump_modify {name} sort id format "{form}"\n'


class Run:
    """One run of frazilDem in a folder of its own, or in that of an earlier run."""

    def __init__(self, dem, script, ranks=1, folder=None, expect_failure=False, files=None):
        self.folder = folder or tempfile.mkdtemp(prefix="bond_")
        for name, text in {"in.script": script, **(files or {})}.items():
            with open(os.path.join(self.folder, name), "w") as file:
                file.write(text)
        command = [dem, "-in", "in.script"]
        if ranks > 1:
            command = [*mpirun.COMMAND, "-np", str(ranks), *command]
        done = subprocess.run(command, cwd=self.folder, env=mpirun.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", timeout=600)
        self.output = done.stdout
        failed = done.returncode != 0 or "ERROR" in self.output
        if failed != expect_failure:
            sys.exit(f"frazilDem {'failed' if failed else 'did not fail'} in {self.folder}:\n{self.output[-3000:]}")

    def rows(self, name, step):
        """Rows of a dump at a step: {id: [columns]}."""
        with open(os.path.join(self.folder, f"{name}.{step}.txt")) as file:
            lines = file.read().splitlines()
        start = next(i for i, line in enumerate(lines) if line.startswith("ITEM: ATOMS")) + 1
        return {int(line.split()[0]): [float(w) for w in line.split()[1:]] for line in lines[start:]}

    def steps(self, name):
        names = glob.glob(os.path.join(self.folder, f"{name}.*.txt"))
        return sorted(int(n.split(".")[-2]) for n in names)

    def thermo(self):
        """Table printed by thermo: list of rows of numbers."""
        rows, inside = [], False
        for line in self.output.splitlines():
            if line.strip().startswith("Step"):
                inside = True
            elif line.startswith("Loop time"):
                inside = False
            elif inside and line.split() and line.split()[0].isdigit():
                rows.append([float(w) for w in line.split()])
        return rows

    def events(self, name="events.csv"):
        with open(os.path.join(self.folder, name)) as file:
            lines = file.read().splitlines()
        keys = lines[0].split(",")
        return [dict(zip(keys, line.split(","))) for line in lines[1:]]


class Check:
    """Collects comparisons, prints them as a table, exits with the verdict."""

    def __init__(self):
        parser = argparse.ArgumentParser()
        parser.add_argument("--dem", default="frazilDem", help="the frazilDem program")
        dem = parser.parse_args().dem
        self.dem = os.path.abspath(dem) if os.sep in dem else dem
        self.failed = 0
        self.folders = []

    def run(self, script, **options):
        run = Run(self.dem, script, **options)
        self.folders.append(run.folder)
        return run

    def near(self, what, measured, reference, tolerance, scale=None):
        """Compares within tolerance x scale (the reference itself unless given)."""
        error = abs(measured - reference) / (abs(reference) if scale is None else scale)
        self.say(what, error <= tolerance, f"{measured:.9g} reference {reference:.9g} error {error:.2e} <= {tolerance:g}")

    def true(self, what, fine, detail=""):
        self.say(what, fine, detail)

    def say(self, what, fine, detail):
        self.failed += not fine
        print(f"{'ok  ' if fine else 'FAIL'} {what}: {detail}", flush=True)

    def finish(self):
        for folder in self.folders:
            if not self.failed:
                shutil.rmtree(folder, ignore_errors=True)
        if self.failed:
            print(f"{self.failed} comparisons failed; folders kept: {' '.join(self.folders)}")
        sys.exit(1 if self.failed else 0)
