"""A real sweep on the local cores: killed and resumed, with a failing point, with points added later, and twice at once."""

import os
import signal
import tempfile
import time
import unittest
from pathlib import Path

import small_study

small_study.skip_without_snakemake()


class Local(unittest.TestCase):
    def setUp(self):
        self.scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def wait_for(self, small, count):
        """Until so many points have ended, more are under way."""
        limit = time.monotonic() + 120
        while len(small.ended()) < count:
            self.assertLess(time.monotonic(), limit)
            time.sleep(0.05)

    def interrupted(self, small, kill):
        """Starts a sweep, ends it by `kill(process)` after two of its points, and lets a second one go on."""
        process = small.start()
        self.wait_for(small, 2)
        kill(process)
        process.communicate(timeout=60)
        before = small.ended()
        self.assertLess(len(before), 8)
        code, said = small.run()
        print(said)
        self.assertEqual(code, 0, said)
        self.assertLessEqual(before.items(), small.ended().items())
        self.assertEqual({row["status"] for row in small.table()}, {"done"})
        self.assertEqual(len(small.table()), 8)
        return said

    def test_interrupted_and_resumed(self):
        """As Ctrl-C does: nothing is left running, and the points that had ended are not run again."""
        small = small_study.SmallStudy(self.scratch, (1e6, 2e6, 3e6, 4e6))

        def kill(process):
            process.send_signal(signal.SIGTERM)
            process.wait(60)
            self.assertEqual(self.working_in(small.folder), [])
        self.interrupted(small, kill)

    def test_killed_and_resumed(self):
        """The sweep and Snakemake are killed outright, the points under way are not: they are ended, then run again."""
        small = small_study.SmallStudy(self.scratch, (1e6, 2e6, 3e6, 4e6), rate=1.0)

        def kill(process):
            while not self.named("frazilDem", small.folder):
                time.sleep(0.05)
            for pid in (process.pid, *self.named("snakemake", small.folder)):
                os.kill(pid, signal.SIGKILL)
        self.interrupted(small, kill)
        logs = "".join(path.read_text() for path in small.folder.glob("log/*.txt"))
        self.assertIn("which an interrupted sweep left in", logs)

    @staticmethod
    def working_in(folder):
        """Processes in a folder or below."""
        found = []
        for link in Path("/proc").glob("[0-9]*/cwd"):
            try:
                place = Path(os.readlink(link))
            except OSError:
                continue
            if folder in (place, *place.parents):
                found.append(int(link.parent.name))
        return found

    def named(self, program, folder):
        """Those that run a program; of Snakemake there is a copy per point."""
        return [pid for pid in self.working_in(folder) if program in self.command_line(pid)]

    @staticmethod
    def command_line(pid):
        """Empty for a process that has just ended."""
        try:
            return Path(f"/proc/{pid}/cmdline").read_text()
        except OSError:
            return ""

    def test_failed_point_and_retry(self):
        """A point with a damping that frazilDem refuses: its words stand in table and page, the others have their numbers, and
        --retry-failed runs it and no other."""
        small = small_study.SmallStudy(self.scratch, (1e6,))
        with small.file.open("a") as file:
            file.write("points: [{bond_damping: -1.0}]\n")
        code, said = small.run()
        print(said)
        self.assertEqual(code, 1)
        self.assertIn("failed: bond_damping--1", said)
        rows = {row["point"]: row for row in small.table()}
        bad = rows.pop("bond_damping--1")
        self.assertEqual((bad["status"], bad["strength [Pa]"]), ("failed", ""))
        self.assertTrue(all(row["status"] == "done" and float(row["strength [Pa]"]) > 1e5 for row in rows.values()))
        self.assertIn("bond_damping--1", (small.folder / "index.html").read_text().partition("<h2>Failed</h2>")[2])
        before = small.ended()
        self.assertEqual((small.run()[0], small.ended()), (1, before))
        small.run("--retry-failed")
        attempts = (small.folder / "log/bond_damping--1.txt").read_text().count(" bond_damping--1\n")
        self.assertEqual(attempts, 2)
        self.assertEqual({name for name, moment in small.ended().items() if moment != before[name]}, {"bond_damping--1"})

    def test_added_points(self):
        """Only the new ones are run; other fixed parameters are refused in words; --dry-run runs nothing."""
        small = small_study.SmallStudy(self.scratch, (1e6,))
        self.assertEqual(small.run()[0], 0)
        before = small.ended()
        small.write((1e6, 2e6))
        code, said = small.run("--dry-run")
        self.assertRegex(said, r"4 points in .*; 2 points to run, .* at the same time, .* each \(mean of 2 done\): about \d:")
        self.assertEqual((code, small.ended()), (0, before))
        self.assertEqual(small.run()[0], 0)
        self.assertEqual(len(small.ended()), 4)
        self.assertLessEqual(before.items(), small.ended().items())
        small.write((1e6, 2e6), rate=2.0)
        code, said = small.run()
        self.assertEqual(code, 1)
        self.assertIn("was run with other parameters: strain_rate 3.0 then, 2.0 now", said)

    def test_two_at_once(self):
        """The second sweep of a folder is refused, and told how to end the first one."""
        small = small_study.SmallStudy(self.scratch, (1e6,))
        first = small.start()
        while not (small.folder / "snakemake.log").is_file():
            time.sleep(0.05)
        time.sleep(0.5)
        code, said = small.run()
        self.assertEqual(code, 1)
        self.assertRegex(said, r"a sweep of this study is going on.* with `kill -INT -- -\d+`")
        said, _ = first.communicate(timeout=120)
        self.assertEqual(first.returncode, 0, said)


if __name__ == "__main__":
    unittest.main(verbosity=2)
