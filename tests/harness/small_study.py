"""A small real study, seconds per point: specimens of 336 spheres, frazilDem alone on one rank. FRAZIL_BUILD names the build
folder, which is used as it is."""
import csv
import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

STUDY = """case: ice_tension
set: {{columns: 14, rows: 8, layers: 3, stiffness_ratios: [2.66], weibull_modulus: 8, strain_rate: {rate}}}
np: {{dem: 1}}
vary:
  tensile_strength: {strengths}
  weibull_seed: [1, 2]
"""
# `frazil sweep` without the set-up: the tests run in a built tree
START = "import sys; import sweep.run; sweep.run.setup = lambda: 0; from launcher.cli import main; sys.exit(main())"


def skip_without_snakemake():
    """Exit code 77, CTest's skip, where the packages of a sweep are not installed."""
    missing = [name for name in ("yaml", "jinja2", "h5py", "matplotlib") if not importlib.util.find_spec(name)]
    if missing or not shutil.which("snakemake"):
        print(f"skipped: needs snakemake and {', '.join(missing) or 'nothing else'}")
        sys.exit(77)


class SmallStudy:
    """A study file and its folder in a scratch folder; two points for each strength [Pa]."""

    def __init__(self, scratch, strengths=(1e6, 2e6, 4e6), rate=3.0):
        self.file, self.folder = Path(scratch) / "small.yaml", Path(scratch) / "study"
        self.write(strengths, rate)

    def write(self, strengths, rate=3.0):
        """The study file."""
        self.file.write_text(STUDY.format(strengths=list(strengths), rate=rate))

    def start(self, *words):
        """`frazil sweep` as a process in a session of its own."""
        command = [sys.executable, "-B", "-c", START, "sweep", str(self.file), "--out", str(self.folder), *words]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
                                env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})

    def run(self, *words):
        """(exit status, what it said) of a sweep that is let to its end."""
        process = self.start(*words)
        said, _ = process.communicate(timeout=600)
        return process.returncode, said

    def ended(self):
        """When each point ended, by name: a point that is run again gets a newer time [ns]."""
        return {path.parent.name: path.stat().st_mtime_ns for path in self.folder.glob("points/*/point.json")}

    def table(self):
        """results.csv as a list of rows by header."""
        with open(self.folder / "results.csv") as file:
            return list(csv.DictReader(file))
