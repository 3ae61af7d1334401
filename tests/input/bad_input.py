"""Mistakes that users make, with the real programs: each must be told in words, and both programs must end at once.

Every test prepares a shipped case at its coarsest level, spoils one thing, and runs the pair as `./frazil run` does.
FRAZIL_BUILD names the build folder.
"""

import os
import re
import signal
import tempfile
import threading
import time
import unittest
from pathlib import Path

from launcher.cli import parser
from launcher.run import plan, prepare
from launcher.say import Failure
from launcher.table import History
from launcher.watch import pids_of, start_programs, watch

SECONDS = 20  # from the start of mpirun to its end, start of both programs included


class BadInput(unittest.TestCase):
    def prepared(self, case):
        """A run folder of the case, ready to run."""
        folder = self.enterContext(tempfile.TemporaryDirectory())
        run = plan(parser().parse_args(["run", case, "--out", folder]))
        prepare(run)
        return run

    def fails(self, run, *texts, seconds=SECONDS):
        """Runs the pair: it must fail within seconds and say all texts."""
        self.ends(run, start_programs(run), *texts, seconds=seconds)

    def ends(self, run, process, *texts, seconds):
        """As fails, for a pair under way."""
        start = time.monotonic()
        with self.assertRaises(Failure) as caught:
            watch(run, process)
        self.assertLess(time.monotonic() - start, seconds)
        print(f"\n{caught.exception}\n", flush=True)
        for text in texts:
            self.assertIn(text, str(caught.exception))

    @staticmethod
    def edit(path, pattern, replacement):
        """Replaces a pattern that must be there."""
        text, count = re.subn(pattern, replacement, path.read_text(), flags=re.MULTILINE)
        assert count, f"{path} has no {pattern}"
        path.write_text(text)

    @staticmethod
    def coupling(run):
        return run.folder / "foam/constant/couplingProperties"

    @staticmethod
    def script(run):
        return run.folder / f"dem/in.{run.case.name}"

    def test_misspelt_key(self):
        run = self.prepared("settling_sphere")
        with self.coupling(run).open("a") as stream:
            stream.write("\nmomentumExchnge on;\n")
        self.fails(run, "momentumExchnge", "momentumExchange")

    def test_coarse_grid_too_small(self):
        run = self.prepared("settling_sphere")
        text = self.coupling(run).read_text()
        low = [float(word) for word in re.search(r"\bmin\s+\(([^)]*)\)", text).group(1).split()]
        cell = float(re.search(r"\bcellSize\s+([^;]+);", text).group(1))
        high = " ".join(str(value + 2 * cell) for value in low)
        self.edit(self.coupling(run), r"\bmax\s+\([^)]*\)", f"max ({high})")
        self.fails(run, "coarseGrid", "Widen coarseGrid min and max")

    def test_particles_end_first(self):
        run = self.prepared("settling_sphere")
        self.edit(self.script(run), r"^run\s+.*$", "run 10")
        self.fails(run, "end time", "Lengthen `run`")

    def test_surface_with_a_hole(self):
        run = self.prepared("free_entry")
        for path in run.folder.rglob("*.stl"):
            facets = path.read_text().split("endfacet")
            path.write_text("endfacet".join(facets[:1] + facets[2:]))
        self.fails(run, "the surface is not closed; open edges")

    def test_body_without_surface(self):
        run = self.prepared("free_entry")
        for path in (run.folder / "foam/constant/triSurface").glob("*.stl"):
            path.unlink()
        self.fails(run, "projectile.stl", "cannot be opened")

    def test_body_on_one_side_only(self):
        run = self.prepared("free_entry")
        self.edit(self.coupling(run), r"bodies\s*\{(?:[^{}]|\{[^{}]*\})*\}", "bodies {}")
        self.fails(run, "bodies: frazilDem has a body", "Add it to bodies")

    def test_body_without_mesh(self):
        run = self.prepared("free_entry")
        self.edit(self.script(run), r"(body/rigid.*\bmesh\s+)\S+", r"\1nosuch")
        self.fails(run, "there is no fix 'nosuch', so the body has no mesh")

    def test_bonds_without_a_pair(self):
        run = self.prepared("settling_sphere")
        bonds = "fix lonely all bond/parallel young 1e8 stiffness_ratio 2 tensile_strength 1e6 shear_strength 1e6\n"
        self.edit(self.script(run), r"^fix fluid\b", bonds + "fix fluid")
        self.fails(run, "bond/parallel", "no pair of the group is in reach")

    def killed(self, program):
        """Kills the program with signal 9 in the middle of a run."""
        run = self.prepared("settling_sphere")
        process, history, killed = start_programs(run), History(run.folder / "history.csv"), []

        def kill():
            while not history.read():
                time.sleep(0.1)
            os.kill(pids_of(program, process.pid)[0], signal.SIGKILL)
            killed.append(time.monotonic())

        threading.Thread(target=kill, daemon=True).start()
        self.ends(run, process, f"{program} was killed (signal 9)", seconds=120)
        self.assertLess(time.monotonic() - killed[0], 10)

    def test_killed_particles(self):
        self.killed("frazilDem")

    def test_killed_fluid(self):
        self.killed("frazilFoam")


if __name__ == "__main__":
    unittest.main(verbosity=2)
