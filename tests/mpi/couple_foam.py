"""fix couple/foam against closed forms: frazilDem with a toy fluid that pushes its particles uniformly.

Three spheres far apart (mass m each), DEM step 1e-4 s, fluid step 1e-3 s. This tests the link and the integration, not
the force laws.
"""
import math
import os
import re
import signal
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import dem_script
import mpirun
import surfaces

MASS = 1000 * 4 / 3 * math.pi * 0.01**3  # [kg]
INERTIA = 0.4 * MASS * 0.01**2           # [kg m2]
DT = 1e-4                                # DEM time step [s]

FRESH = """boundary f f f
region box block 0 0.6 0 0.4 0 0.5 units box
create_box 1 box
create_atoms 1 single 0.1 0.2 0.2 units box
create_atoms 1 single 0.29 0.1 0.3 units box
create_atoms 1 single 0.45 0.3 0.1 units box
set group all density 1000 diameter 0.02"""

MOVE = "fix integr all nve/sphere\n"
COUPLE = "fix foam all couple/foam restart r.*\n"

BODY = """
fix hull all mesh/surface/stress file box.stl type 1
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes hull
fix ball all body/rigid mesh hull density 1000
"""

PRINT = """
compute v all property/atom vx
compute vmin all reduce min c_v
compute vmax all reduce max c_v
compute w all property/atom omegaz
compute wmax all reduce max c_w
thermo_style custom step atoms c_vmin c_vmax c_wmax f_foam[1] f_foam[3]
thermo_modify lost error norm no format float %.15g
thermo 500
"""


def head(start):
    return dem_script.head(start, boundary="", skin=0.01, processors="* 1 1") + f"timestep {DT}\n"


def box(path, size):
    """A cube of this edge around (0.3 0.2 0.25) as STL; returns its volume [m3]."""
    surfaces.write_stl(path, surfaces.cuboid((size,) * 3, (0.3, 0.2, 0.25)))
    return size**3


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_pair(self, script, ranks=(1, 1), start=FRESH, **fluid):
        fluid = {"gravity": 0, "watchdog": 20, "steps": 200, **fluid}
        Path(self.folder.name, "in.test").write_text(head(start) + script)
        return mpirun.run(["-np", ranks[0], f"{BIN}/frazilDem", "-in", "in.test", ":", "-np", ranks[1], f"{BIN}/toy_foam",
                           *(f"{key}={value}" for key, value in fluid.items())], cwd=self.folder.name)

    def final(self, run, step=2000):
        """Last thermo line: {vmin, vmax, wmax, time, force}."""
        self.assertEqual(run.code, 0, run)
        lines = re.findall(rf"^ +{step} +3 (.*)$", run.text, re.MULTILINE)
        self.assertTrue(lines, run)
        return dict(zip(("vmin", "vmax", "wmax", "time", "force"), map(float, lines[-1].split())))

    def near(self, found, expected, tolerance):
        self.assertLess(abs(found / expected - 1), tolerance, f"{found} is not {expected}")


class ClosedForms(Case):
    def test_relaxation_to_the_flow(self):
        """v = u (1 - exp(-K t/m)), w likewise; the same digits for every ratio of ranks."""
        K, u, C, spin = 0.02, 1.0, 1e-6, 2.0
        seen = []
        for ranks in ((1, 1), (2, 1), (1, 2)):
            end = self.final(self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", ranks, K=K, u=u, C=C, spin=spin))
            self.near(end["vmin"], u * (1 - math.exp(-K * 0.2 / MASS)), K * DT / MASS)
            self.near(end["wmax"], spin * (1 - math.exp(-C * 0.2 / INERTIA)), C * DT / INERTIA)
            self.assertEqual(end["vmin"], end["vmax"])
            seen.append((end["vmax"], end["wmax"]))
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(seen[0], seen[2])

    def test_stiff_drag_is_stable(self):
        """K dt/m = 2400: explicit drag would explode."""
        end = self.final(self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", K=1e5, u=0.1))
        self.near(end["vmax"], 0.1, 1e-3)

    def test_added_mass_of_a_light_sphere(self):
        """(m + ma) dv/dt = passive + ma Du/Dt, exactly, with ma > m."""
        ma, passive, dudt = 3 * MASS, 0.005, 0.2
        end = self.final(self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", ma=ma, passive=passive, dudt=dudt))
        self.near(end["vmax"], (passive + ma * dudt) / (MASS + ma) * 0.2, 1e-11)

    def test_the_fluid_learns_the_impulse_that_was_received(self):
        run = self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", (2, 2), K=0.02, u=1, ma=0.003)
        reported = float(re.search(r"of the reports (\S+)", run.text).group(1))
        self.near(reported, 3 * MASS * self.final(run)["vmax"], 1e-12)

    def test_bonded_spheres_are_shielded(self):
        """Two spheres touch and are bonded: no exposure, no drag. The third one never had a bond: full drag."""
        start = FRESH.replace("single 0.29 0.1 0.3", "single 0.12 0.2 0.2")
        bonds = "fix bonds all bond/parallel young 1e5 stiffness_ratio 2 tensile_strength 1e6 shear_strength 1e6\n"
        script = MOVE + bonds + COUPLE.replace("restart", "shielding bonds restart") + PRINT + "run 2000\n"
        for ranks in ((1, 1), (2, 2)):
            end = self.final(self.run_pair(script, ranks, start=start, K=0.02, u=1))
            self.assertLess(abs(end["vmin"]), 1e-12)
            self.near(end["vmax"], 1 - math.exp(-0.02 * 0.2 / MASS), 0.02 * DT / MASS)

    def test_particles_that_left_the_box_are_not_sent(self):
        """Boundary f: LIGGGHTS deletes them at its next neighbour list; the exchange before it must not stumble."""
        run = self.run_pair(MOVE + COUPLE + PRINT.replace("lost error", "lost ignore") + "run 2000\n", (2, 2), K=1, u=1)
        self.assertEqual(run.code, 0, run)
        self.assertRegex(run.text, r"\n +2000 +2 ")

    def test_held_particles_feel_the_fluid_at_rest(self):
        """Not integrated, or frozen: no acceleration, so the force is K u + passive + ma Du/Dt."""
        freeze = "fix stop all freeze\n"
        for script in (COUPLE, MOVE + COUPLE + freeze):
            run = self.run_pair(script + PRINT + "run 2000\n", K=0.02, u=1.5, ma=0.003, dudt=2, passive=0.1)
            self.near(self.final(run)["force"], 3 * (0.02 * 1.5 + 0.003 * 2 + 0.1), 1e-12)


class Runs(Case):
    FLUID = {"K": 0.02, "u": 1, "C": 1e-6, "spin": 2, "ma": 0.003}

    def test_split_runs_continue_without_a_jump(self):
        whole = self.final(self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", **self.FLUID))
        split = "run 0\nrun 333 stop 2000\nrun 1\nrun 0\nreset_timestep 7\nreset_timestep 334\nrun 3000\n"
        run = self.run_pair(MOVE + COUPLE + PRINT + split + "print 'never reached'\n", **self.FLUID)
        self.assertEqual(self.final(run), whole)
        self.assertIn("frazilFoam has reached its end", run.text)
        self.assertEqual(run.text.count("never reached"), 0, run)

    def test_restart_continues_without_a_jump(self):
        """The restart file is written when the fluid writes its fields."""
        whole = self.final(self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", (2, 1), written=100, **self.FLUID))
        again = MOVE + COUPLE + PRINT + "run 1000\n"
        run = self.run_pair(again, start="read_restart r.1000", start_time=0.1, steps=100, **self.FLUID)
        self.assertEqual(self.final(run), whole)
        late = self.run_pair(again, start="read_restart r.1000", start_time=0.11, steps=90, **self.FLUID)
        self.assertIn("restart file belongs to fluid time 0.1 s, frazilFoam starts at 0.11 s", late.text)
        times = [line.split(",")[0] for line in Path(self.folder.name, "history.csv").read_text().splitlines()[1:]]
        self.assertEqual(len(times), len(set(times)), "a continued history has each time once")

    def test_a_body_keeps_its_load_over_a_restart(self):
        """The fluid has no load to send at its first exchange: none at a fresh start, that of the restart file later.

        v = F/m (0.2 s - the first fluid step); without the load of the file one step less."""
        volume, load = box(Path(self.folder.name, "box.stl"), 0.02), 0.004
        show = PRINT.replace("f_foam[1] f_foam[3]", "f_ball[4] f_ball[20]")
        fluid = {"body": "ball", "volume": volume, "load": load}
        whole = self.final(self.run_pair(BODY + MOVE + COUPLE + show + "run 2000\n", written=100, **fluid))
        self.near(whole["time"], load / (1000 * volume) * 0.199, 1e-2 * DT)
        run = self.run_pair(BODY + MOVE + COUPLE + show + "run 1000\n", start="read_restart r.1000", start_time=0.1,
                            steps=100, **fluid)
        self.near(self.final(run)["time"], whole["time"], 1e-12)

    def test_the_script_may_end_first(self):
        run = self.run_pair(MOVE + COUPLE + PRINT + "run 1005 stop 2000\n", (2, 2), **self.FLUID)
        self.assertEqual(run.code, 0, run)
        self.assertIn("toy_foam ends at 0.101", run.text)

    def test_timing_and_vtk_use_the_world_and_do_not_hang(self):
        dumps = ("modify_timing on\ndump a all custom/vtk 500 a*.vtk id type x y z\n"
                 "dump b all custom/vtm 500 b*.vtm particle_properties id type x y z\n")
        run = self.run_pair(MOVE + COUPLE + PRINT + dumps + "run 2000\n", (2, 2), **self.FLUID)
        self.final(run)
        self.assertIn("Fix foam couple/foam time", run.text)
        self.assertTrue(Path(self.folder.name, "b2000.vtm").exists())

    def test_history_and_timers(self):
        run = self.run_pair(MOVE + COUPLE + PRINT + "run 2000\n", **self.FLUID)
        lines = Path(self.folder.name, "history.csv").read_text().splitlines()
        self.assertEqual(len(lines), 202)
        self.assertEqual({line.count(",") for line in lines}, {lines[0].count(",")})
        self.assertRegex(run.text, r"FRAZIL_TIMERS side=dem wall=\S+ waiting=\S+ exchange=\S+ force=\S+")


class Errors(Case):
    def refused(self, script, *words, **fluid):
        run = self.run_pair(script, **fluid)
        self.assertNotEqual(run.code, 0, run)
        self.assertLess(run.seconds, 10)
        for word in words:
            self.assertIn(word, run.text, run)

    def test_a_force_after_the_coupling(self):
        self.refused(MOVE + COUPLE + "fix g all gravity 9.81 vector 0 -1 0\nrun 10\n",
                     "fix g (gravity) comes later and changes forces", "Write fix couple/foam after it")

    def test_wrong_words(self):
        for words, said in (("sheilding bonds", 'sheilding: unknown keyword (did you mean "shielding"?). Known: shielding, history'),
                            ("ramp nan", "ramp nan: is not a number"), ("ramp inf", "ramp inf: is not a number"),
                            ("ramp -1", "ramp -1: must not be negative"), ("ramp", "ramp: needs 1 value"),
                            ("fragment_every 0", "fragment_every 0: must be above zero"),
                            ("fragment_every 1.5", "fragment_every 1.5: is not a whole number"),
                            ("ramp 1 ramp 2", "ramp: stands twice")):
            self.refused(f"fix foam all couple/foam {words}\n", said)

    def test_shielding_without_bonds(self):
        self.refused(MOVE + "fix foam all couple/foam shielding nobody\nrun 10\n", "no fix bond/parallel of this ID")

    def test_run_too_short(self):
        self.refused(MOVE + COUPLE + "run 100\n", "frazilDem's run ends 0.01 s after the start of the coupling (100 steps",
                     "Lengthen `run` to 2000 steps")

    def test_the_wait_for_the_handshake(self):
        """A fluid that reads a large mesh is late; the environment says how late it may be."""
        self.addCleanup(os.environ.pop, "FRAZIL_HANDSHAKE_SECONDS")
        os.environ["FRAZIL_HANDSHAKE_SECONDS"] = "1"
        self.refused(MOVE + COUPLE + "run 2000\n", "waited 1 s for frazilFoam to greet",
                     "FRAZIL_HANDSHAKE_SECONDS in the environment allows", late=5)
        os.environ["FRAZIL_HANDSHAKE_SECONDS"] = "long"
        self.refused(MOVE + COUPLE + "run 2000\n", "FRAZIL_HANDSHAKE_SECONDS", "is not a number above zero")

    def test_no_coupling_in_the_script(self):
        self.refused(MOVE + "run 10\n", "its input script has no fix couple/foam", "frazilFoam ends")

    def test_error_of_liggghts_during_the_run(self):
        """A particle is lost: error->all, which ends in MPI_Finalize and exit."""
        self.refused(MOVE + COUPLE + PRINT + "run 2000\n", "ERROR: Lost atoms", "frazilDem failed (fluid time",
                     "frazilFoam ends", u=100, K=1)

    def test_the_load_of_another_body(self):
        """Loads go to bodies by name, whatever their order; one that fits none is not given to another."""
        volume = box(Path(self.folder.name, "box.stl"), 0.02)
        self.refused(BODY + MOVE + COUPLE + "run 2000\n", "sent the load of a body cone, which the script does not have",
                     body="ball", volume=volume, load_of="cone")

    def test_no_partner(self):
        Path(self.folder.name, "in.test").write_text(head(FRESH) + COUPLE)
        run = mpirun.run(["-np", 2, f"{BIN}/frazilDem", "-in", "in.test"], cwd=self.folder.name)
        self.assertNotEqual(run.code, 0)
        self.assertIn("frazilDem has no partner", run.text)
        self.assertIn("mpirun -np 1 frazilDem -in SCRIPT : -np 1 frazilFoam -case CASE", run.text)

    def test_kill_9_of_either_side(self):
        for program in ("frazilDem", "toy_foam"):
            with self.subTest(program=program):
                killer = threading.Timer(1.5, self.kill, [program])
                killer.start()
                # the fluid hangs, so that both are alive when the signal comes
                self.refused(MOVE + COUPLE + PRINT + "run 2000\n", "signal 9", fails="hang", at=3, watchdog=100)

    def kill(self, program):
        """The process of this name whose working folder is the test's."""
        for entry in Path("/proc").iterdir():
            try:
                if (entry / "comm").read_text().strip() == program and os.readlink(entry / "cwd") == self.folder.name:
                    os.kill(int(entry.name), signal.SIGKILL)
            except (OSError, ValueError):
                continue


if __name__ == "__main__":
    BIN = sys.argv.pop(1)
    unittest.main(verbosity=2)
