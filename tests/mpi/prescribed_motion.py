"""fix couple/foam on particles that no force moves: towed, shaken, drifting, frozen. Closed forms as in couple_foam.py.

The fluid's force on a sphere is P + K (u - v) + ma (Du/Dt - a) with the a that it really performs, and the fluid
receives the impulse of all but P with opposite sign. Every case on 1 and 2 ranks of frazilDem.
"""
import math
import re
import sys
import unittest

import couple_foam
from couple_foam import COUPLE, DT, MASS, MOVE, PRINT

RANKS = ((1, 1), (2, 1))
T = 0.2  # end of all runs [s]
V = 0.1  # towing speed [m/s]
FLUID = {"K": 0.02, "u": 1.5, "ma": 0.5 * MASS, "dudt": 2, "passive": 0.01}  # ma: ½ρV of water
TOWED = f"velocity all set {V} 0 0 units box\n"
HELD = 3 * (FLUID["K"] * FLUID["u"] + FLUID["ma"] * FLUID["dudt"] + FLUID["passive"])  # force at rest [N]
TORQUE = "compute t all reduce sum f_foam[6]\n" + PRINT.replace("f_foam[1]", "c_t")  # its sum in place of the time


class Case(couple_foam.Case):
    def impulse(self, run):
        """What the fluid was told [N s]."""
        return float(re.search(r"of the reports (\S+)", run.text).group(1))

    def each(self, script, start=couple_foam.FRESH, **fluid):
        """(last thermo line, run) on each number of ranks, which must agree to the last digit."""
        runs = [self.run_pair(script, ranks, start=start, **fluid) for ranks in RANKS]
        ends = [self.final(run) for run in runs]
        for key in ends[0]:
            self.assertLessEqual(abs(ends[0][key] - ends[1][key]), 1e-14 * abs(ends[0][key]), key)
        return zip(ends, runs)


class ConstantVelocity(Case):
    def towed(self, motion):
        """a = 0: P + K (u - v) + ma Du/Dt; neither mass nor added mass takes part in it."""
        reaction = 3 * (FLUID["K"] * (FLUID["u"] - V) + FLUID["ma"] * FLUID["dudt"])
        for end, run in self.each(TOWED + motion + COUPLE + PRINT + "run 2000\n", **FLUID):
            self.near(end["force"], reaction + 3 * FLUID["passive"], 1e-12)
            self.near(self.impulse(run), reaction * T, 1e-12)

    def test_move_linear(self):
        self.towed(f"fix tow all move linear {V} 0 0\n")

    def test_nve_noforce(self):
        self.towed("fix drift all nve/noforce\n")

    def test_a_group_both_free_and_prescribed_is_prescribed(self):
        self.towed(MOVE + f"fix tow all move linear {V} 0 0\n")

    def test_the_jump_into_the_motion_is_no_acceleration(self):
        """At rest in the script, at speed from the first step on: the fluid learns of no kick."""
        for _, run in self.each(f"fix tow all move linear {V} 0 0\n" + COUPLE + PRINT + "run 2000\n", ma=MASS, K=0):
            self.assertEqual(self.impulse(run), 0)

    def test_free_along_one_axis(self):
        """NULL leaves that axis to the force: there a = (P + ma Du/Dt)/(m + ma), exactly."""
        a = (FLUID["passive"] + FLUID["ma"] * FLUID["dudt"]) / (MASS + FLUID["ma"])
        script = f"fix tow all move linear NULL 0 {V}\n" + COUPLE + PRINT + "run 2000\n"
        for end, _ in self.each(script, **{**FLUID, "K": 0}):
            self.near(end["vmax"], a * T, 1e-11)
            self.near(end["force"], 3 * MASS * a, 1e-11)

    def test_some_towed_some_free(self):
        """Each by its own law, side by side."""
        groups = f"group one id 1\ngroup rest subtract all one\nfix tow one move linear {V} 0 0\nfix free rest nve/sphere\n"
        a = (FLUID["passive"] + FLUID["ma"] * FLUID["dudt"]) / (MASS + FLUID["ma"])
        for end, _ in self.each(groups + COUPLE + PRINT + "run 2000\n", **{**FLUID, "K": 0}):
            self.near(end["vmin"], V, 1e-14)
            self.near(end["vmax"], a * T, 1e-11)
            self.near(end["force"], 2 * MASS * a + FLUID["ma"] * FLUID["dudt"] + FLUID["passive"], 1e-11)


class Acceleration(Case):
    A, PERIOD = 0.002, 0.13  # [m] [s]; the run ends at none of its zeros
    W = 2 * math.pi / PERIOD

    def shaken(self, script, **fluid):
        """x = A sin wt: a = -A w² sin wt, so the fluid pushes with +ma A w² sin wt, half a DEM step late; it is told the
        impulse -ma (v(T) - v(0)). The first step has no step before it to take an acceleration from."""
        ma, A, W = FLUID["ma"], self.A, self.W
        speed = 2 * A / DT * math.sin(W * DT / 2)  # of the difference quotient of sin
        for end, run in self.each(script, ma=ma, **fluid):
            self.near(end["force"], 3 * ma * speed * W * math.sin(W * (T - DT / 2)), 1e-6)
            mean = A * W * (math.cos(W * T) + math.cos(W * (T - DT))) / 2  # trapezoid of two steps
            self.near(self.impulse(run), 3 * ma * (A * W * math.cos(W * DT) - mean), 1e-9)

    def test_wiggle(self):
        self.shaken(f"fix shake all move wiggle {self.A} NULL 0 {self.PERIOD}\n" + COUPLE + PRINT + "run 2000\n")

    def test_split_runs_leave_no_trace(self):
        self.shaken(f"fix shake all move wiggle {self.A} 0 0 {self.PERIOD}\n" + COUPLE + PRINT +
                    "run 333 stop 2000\nrun 1\nrun 0\nrun 3000\n")

    def test_variable(self):
        """The velocity counts; x is free to be what it likes."""
        motion = (f"variable x equal {self.A}*sin({self.W:.17g}*step*dt)\n"
                  f"variable v equal {self.A * self.W:.17g}*cos({self.W:.17g}*step*dt)\n"
                  "fix shake all move variable v_x NULL NULL v_v NULL NULL\n")
        self.shaken(motion + COUPLE + PRINT + "run 2000\n")

    def test_rotate(self):
        """About z through (0.3 0.2): a = -w² r, so the fluid pushes with +ma w² r; its x-components of three spheres."""
        ma, W = FLUID["ma"], self.W
        start = couple_foam.FRESH.replace("0.1 0.2 0.2", "0.2 0.2 0.2")  # inside of the box all the way round
        x, y = 0.2 + 0.29 + 0.45 - 3 * 0.3, 0.2 + 0.1 + 0.3 - 3 * 0.2    # sums of r at the start
        angle = W * (T - DT / 2)
        script = f"fix turn all move rotate 0.3 0.2 0 0 0 1 {self.PERIOD}\n" + COUPLE + PRINT + "run 2000\n"
        for end, _ in self.each(script, start=start, ma=ma):
            self.near(end["force"], ma * W * W * (x * math.cos(angle) - y * math.sin(angle)), 1e-5)

    def test_restart(self):
        """The step after the restart file knows the velocity before it."""
        motion = f"fix shake all move wiggle {self.A} 0 0 {self.PERIOD}\n"
        for ranks in RANKS:
            whole = self.run_pair(motion + COUPLE + PRINT + "run 2000\n", ranks, ma=FLUID["ma"], written=100)
            again = self.run_pair(motion + COUPLE + PRINT.replace("500", "1") + "run 1000\n", ranks, ma=FLUID["ma"],
                                  start="read_restart r.1000", start_time=0.1, steps=100)
            self.near(self.final(again)["force"], self.final(whole)["force"], 1e-12)
            first = 3 * FLUID["ma"] * self.A * self.W**2 * math.sin(self.W * (0.1001 - DT / 2))
            self.near(self.final(again, 1001)["force"], first, 1e-6)


class Held(Case):
    def frozen(self, script, runs="", **fluid):
        for end, run in self.each(script + PRINT + runs + "run 2000\n", **{**FLUID, **fluid}):
            self.assertEqual((end["vmin"], end["vmax"], end["wmax"]), (0, 0, 0))
            self.near(end["force"], HELD, 1e-12)
            self.near(self.impulse(run), (HELD - 3 * FLUID["passive"]) * T, 1e-12)

    def test_freeze_before(self):
        self.frozen("fix stop all freeze\n" + MOVE + COUPLE, C=1e-6, spin=2)

    def test_freeze_between(self):
        self.frozen(MOVE + "fix stop all freeze\n" + COUPLE, C=1e-6, spin=2)

    def test_freeze_after(self):
        self.frozen(MOVE + COUPLE + "fix stop all freeze\n", C=1e-6, spin=2)

    def test_freeze_in_split_runs(self):
        self.frozen("fix stop all freeze\n" + MOVE + COUPLE, "run 333 stop 2000\nrun 0\n", C=1e-6, spin=2)

    def test_nobody_integrates(self):
        self.frozen(COUPLE)

    def test_nve_turns_nothing(self):
        """fix nve moves the centre only: the torque is that of a sphere that does not spin up."""
        C, spin = 1e-6, 2.0
        for end, _ in self.each("fix integr all nve\n" + COUPLE + TORQUE + "run 2000\n", C=C, spin=spin):
            self.near(end["time"], 3 * C * spin, 1e-12)


class Refused(Case):
    def refused(self, script, *words):
        run = self.run_pair(script + COUPLE + "run 2000\n")
        self.assertNotEqual(run.code, 0, run)
        for word in words:
            self.assertIn(word, run.text, run)

    def test_an_integrator_with_added_mass_of_its_own(self):
        self.refused("fix integr all nve/sphere update CAddRhoFluid 0.5\n", "fix integr (nve/sphere) has CAddRhoFluid",
                     "added mass twice")

    def test_a_displacement_without_velocity(self):
        self.refused("variable x equal 0.001*step\nfix shake all move variable v_x NULL NULL NULL NULL NULL\n",
                     "fix shake (move) gives a displacement without a velocity", "Give the variable of the velocity too")

    def test_clumps(self):
        self.refused("fix clumps all rigid single\n", "fix clumps (rigid) moves clumps of spheres")


if __name__ == "__main__":
    couple_foam.BIN = sys.argv.pop(1)
    unittest.main(verbosity=2)
