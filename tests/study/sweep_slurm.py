"""The small sweep on a real Slurm, started and stopped here: run to its end, interrupted and resumed, a job that Slurm cancels.
Exit code 77 where Slurm is not installed or this is not root."""

import os
import sys
import tempfile
import time
import unittest
from pathlib import Path

import small_study
from slurm import missing, Slurm

small_study.skip_without_snakemake()
if missing():
    print(f"skipped: {missing()}")
    sys.exit(77)


class OnSlurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.slurm = cls.enterClassContext(Slurm(scratch))
        os.environ.update(cls.slurm.env)

    def setUp(self):
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def jobs(self):
        """Names of the jobs that wait or run."""
        return self.slurm.ask("squeue", "--noheader", "--format=%j").split()

    def start(self, small):
        """A sweep under way; ended with the test, should it fail."""
        process = small.start("--slurm")
        self.addCleanup(process.wait)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.terminate)
        return process

    def wait_for(self, condition):
        limit = time.monotonic() + 120
        while not condition():
            self.assertLess(time.monotonic(), limit, self.slurm.ask("squeue"))
            time.sleep(0.1)

    def test_whole_sweep(self):
        """Each point is one job of as many tasks as ranks; all are done and nothing stays in the queue."""
        small = small_study.SmallStudy(self.scratch, (1e6, 2e6))
        begin = time.monotonic()
        code, said = small.run("--slurm", "--sbatch", "time=10")
        print(f"{said}{time.monotonic() - begin:.0f} s")
        self.assertEqual(code, 0, said)
        self.assertEqual([row["status"] for row in small.table()], ["done"] * 4)
        self.assertEqual(len(list(small.folder.glob("log/slurm-*.txt"))), 4)
        self.assertEqual(self.jobs(), [])

    def test_interrupted_and_resumed(self):
        """Ctrl-C cancels the jobs; the second call runs what had not ended."""
        small = small_study.SmallStudy(self.scratch, (1e6, 2e6, 4e6))
        process = self.start(small)
        self.wait_for(lambda: len(small.ended()) >= 2)
        process.terminate()
        process.communicate(timeout=120)
        self.wait_for(lambda: self.jobs() == [])
        before = small.ended()
        self.assertLess(len(before), 6)
        code, said = small.run("--slurm")
        print(said)
        self.assertEqual((code, len(small.ended())), (0, 6), said)
        self.assertLessEqual(before.items(), small.ended().items())

    def test_cancelled_job(self):
        """A job that Slurm ends, as at its time limit, is no failed point: the others go on, the next call runs it."""
        small = small_study.SmallStudy(self.scratch, (1e6,), rate=0.3)
        process = self.start(small)
        victim = "frazil-tensile_strength-1000000_weibull_seed-1"
        self.wait_for(lambda: list(small.folder.glob("points/*seed-1/log.dem")))
        self.slurm.ask("scancel", f"--name={victim}")
        said, _ = process.communicate(timeout=300)
        print(said)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(said, r"not ended:\n  tensile_strength-1000000_weibull_seed-1\n")
        self.assertIn("Start the same command again to go on.", said)
        self.assertEqual({row["weibull_seed"]: row["status"] for row in small.table()}, {"1": "unfinished", "2": "done"})
        self.assertEqual(small.run("--slurm")[0], 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
