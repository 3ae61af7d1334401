"""The links and the shim with two toy programs: every ratio of ranks, every way to end and to fail."""
import sys
import unittest

import mpirun

RATIOS = [(1, 1), (2, 1), (1, 2), (2, 4), (4, 3)]


def pair(dem_ranks, foam_ranks, dem=(), foam=()):
    return mpirun.run(["-np", dem_ranks, f"{BIN}/toy_dem", *dem, ":",
                       "-np", foam_ranks, f"{BIN}/toy_foam", "echo=1", "watchdog=20", *foam])


class Pair(unittest.TestCase):
    def test_every_ratio_of_ranks(self):
        """500 particles that change rank and place at each of 20 exchanges: toy_dem checks each reply."""
        for dem_ranks, foam_ranks in RATIOS:
            with self.subTest(ratio=f"{dem_ranks}:{foam_ranks}"):
                run = pair(dem_ranks, foam_ranks)
                self.assertEqual(run.code, 0, run)
                self.assertEqual(run.text.count("toy_dem ends"), dem_ranks, run)
                self.assertIn(f"impulse of the records {20 * 500 * 501 // 2},", run.text, run)

    def test_dem_ends_first(self):
        run = pair(2, 2, dem=["steps=7"])
        self.assertEqual(run.code, 0, run)
        self.assertIn("toy_foam ends at 0.007", run.text, run)

    def test_no_particles_at_all(self):
        self.assertEqual(pair(2, 2, dem=["particles=0"]).code, 0)


class Failure(unittest.TestCase):
    def ends(self, run, *words, within=10):
        self.assertNotEqual(run.code, 0, run)
        self.assertLess(run.seconds, within, run)
        for word in words:
            self.assertIn(word, run.text, run)

    def test_each_way_to_leave_early(self):
        """The leaver says how, and the other one says who left."""
        for how, words in {"exit": "it called exit()", "finalize": "it called MPI_Finalize",
                           "abort": "it called MPI_Abort", "throw": "the toy was told to throw"}.items():
            with self.subTest(how=how):
                self.ends(pair(2, 2, foam=[f"fails={how}", "at=3"]), f"frazilFoam failed (fluid time 0.002 s, fluid step 2): {words}",
                          "frazilDem ends (fluid time 0.002 s, fluid step 2) because frazilFoam failed")

    def test_kill(self):
        """Nobody can speak after SIGABRT; mpirun ends the rest."""
        self.ends(pair(2, 2, foam=["fails=kill", "at=3"]), "signal 6")

    def test_watchdog_names_who_waits_for_what(self):
        self.ends(pair(2, 2, foam=["watchdog=1", "fails=hang", "at=3"]),
                  "frazilDem failed (fluid time 0.002 s, fluid step 2): it has waited 1 s for frazilFoam to",
                  "frazilFoam is stuck")
        self.ends(pair(2, 2, dem=["hang=3"], foam=["watchdog=1"]),
                  "frazilFoam failed (fluid time 0.003 s, fluid step 3): it has waited 1 s for frazilDem to",
                  "frazilDem is stuck")

    def test_refusal_is_the_same_on_both_sides(self):
        run = pair(1, 2, dem=["gravity=-9.8"])
        self.ends(run)
        words = "gravity: frazilDem has (0 -9.8 0) m/s2 (fix gravity), frazilFoam (0 -9.81 0) m/s2 (constant/g). Make them equal."
        self.assertGreaterEqual(run.text.count(words), 2, run)

    def test_no_partner(self):
        run = mpirun.run(["-np", 2, f"{BIN}/toy_foam"])
        self.ends(run, "frazilFoam has no partner", "mpirun -np 1 frazilDem -in SCRIPT : -np 1 frazilFoam -case CASE")


if __name__ == "__main__":
    BIN = sys.argv.pop(1)
    unittest.main(verbosity=2)
