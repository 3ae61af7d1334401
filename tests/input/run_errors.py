"""What the launcher says to wrong input and to failing programs. The pair is played by two shell scripts here."""

import json
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from launcher import cli, places
from launcher.case import find_case, parameters
from launcher.cli import parser, run_case
from launcher.resume import forget_after, restart_point, resume
from launcher.run import decomposition, free_folder, plan, prepare
from launcher.say import Failure
from launcher.watch import start_programs, watch

PREPARE = """import pathlib, sys
system = pathlib.Path(sys.argv[1], "foam/system")
system.mkdir(parents=True)
(system / "controlDict").write_text("endTime 1;\\n")
"""
HISTORY = """printf 'time,x,y,z,vx,vy,vz,contact_fy,fluid_fy,broken_tension,broken_shear\\n0,0,0,0,0,-3,0,1,2,0,0\\n' >history.csv
printf '0.5,0,-1,0,0,-2,0,1,2,3,4\\n' >>history.csv"""
CASE = {"title": "t", "levels": {"demo": {"speed": 1.5, "name": "a"}}, "np": {"dem": 1, "foam": 1}}


class Launcher(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.case = self.folder / "toy"
        self.case.mkdir()
        (self.case / "case.json").write_text(json.dumps(CASE))
        (self.case / "prepare").write_text(PREPARE)
        places.BUILD = self.folder / "build"
        (places.BUILD / "bin").mkdir(parents=True)

    def arguments(self, *words):
        return parser().parse_args(["run", str(self.case), "--out", str(self.folder / "out"), *words])

    def program(self, name, script):
        path = places.BUILD / "bin" / name
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)

    def run_pair(self, dem, foam):
        """Plays a run with these scripts as the two programs: what the launcher says, and the seconds it took."""
        for name, script in (("blockMesh", ":"), ("frazilDem", dem), ("frazilFoam", foam)):
            self.program(name, script)
        run = plan(self.arguments())
        prepare(run)
        start = time.monotonic()
        try:
            watch(run, start_programs(run))
        except Failure as failure:
            return str(failure), time.monotonic() - start
        return "", time.monotonic() - start

    def refuses(self, words, *texts):
        with self.assertRaises(Failure) as caught:
            plan(self.arguments(*words))
        for text in texts:
            self.assertIn(text, str(caught.exception))

    def test_unknown_parameter(self):
        self.refuses(["--set", "sped=2"], "--set sped=2", "Did you mean speed?", "Known: name, speed.")

    def test_value_of_another_kind(self):
        self.refuses(["--set", "speed=fast"], "speed is like 1.5")

    def test_unknown_level(self):
        self.refuses(["--level", "demi"], "toy has no level demi. Did you mean demo?")

    def test_unknown_case(self):
        with self.assertRaisesRegex(Failure, "there is no case ice_enrty. Did you mean ice_entry.*settling_sphere"):
            find_case("ice_enrty")

    def test_folder_in_use(self):
        (self.folder / "out").mkdir()
        (self.folder / "out/history.csv").touch()
        self.refuses([], "holds something already")

    def test_runs_are_numbered(self):
        (self.folder / "toy-demo").mkdir()
        self.assertEqual(free_folder(self.folder / "toy-demo").name, "toy-demo-2")

    def test_parameters_are_set(self):
        self.assertEqual(plan(self.arguments("--set", "speed=2")).params, {"speed": 2, "name": "a"})

    def test_a_choice_stands_for_several_parameters(self):
        """Those set one by one come after it, whatever the order; what is not among its values is refused."""
        text = {"levels": {"demo": {"ice": "soft", "young": 1.0, "strength": 2.0}},
                "choices": {"ice": {"soft": {}, "hard": {"young": 5.0, "strength": 6.0}}}}
        of = lambda *words: parameters(text, "demo", list(words))
        self.assertEqual(of(), {"ice": "soft", "young": 1.0, "strength": 2.0})
        self.assertEqual(of("ice=hard"), {"ice": "hard", "young": 5.0, "strength": 6.0})
        self.assertEqual(of("young=7", "ice=hard"), {"ice": "hard", "young": 7, "strength": 6.0})
        with self.assertRaisesRegex(Failure, "ice=herd: no such ice. Did you mean hard"):
            of("ice=herd")

    def test_resume_takes_the_last_common_state(self):
        """The fluid wrote 0.1 and was interrupted before it wrote 0.2, whose restart file is there."""
        run = plan(self.arguments())
        for name in ("foam/0/U", "foam/0.1/U", "dem/restart.10", "dem/restart.20"):
            (run.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (run.folder / name).touch()
        history = {"time": [0.0, 0.1, 0.2], "substeps": [10.0, 10.0, 10.0]}
        self.assertEqual(restart_point(run, history), ("dem/restart.10", "0.1", 0.1))
        (run.folder / "dem/restart.10").unlink()
        with self.assertRaisesRegex(Failure, "no state that both programs have written"):
            restart_point(run, history)

    def test_resume_drops_what_will_be_written_again(self):
        table = self.folder / "history.csv"
        table.write_text("time,y\n0,1\n0.1,2\n0.2,3\n")
        forget_after(table, 0.1)
        self.assertEqual(table.read_text(), "time,y\n0,1\n0.1,2\n")
        forget_after(table, 0.1, inclusive=True)
        self.assertEqual(table.read_text(), "time,y\n0,1\n")

    def test_resume_restarts_both_programs(self):
        """The DEM's start becomes read_restart, the fluid's its time; tables lose what will be written again."""
        run = plan(self.arguments())
        files = {"run.json": json.dumps({"case": str(run.case), "level": "demo", "np_dem": 1, "np_foam": 1}),
                 "params.json": "{}", "foam/0.1/U": "", "dem/restart.10": "", "dem/start": "read_data ice\n",
                 "foam/system/controlDict": "startFrom latestTime;\nstartTime 0;\nendTime 1;\n",
                 "history.csv": "time,substeps\n0,10\n0.1,10\n", "ledger.csv": "time\n0\n0.1\n",
                 "dem/bonds.csv": "time,id1\n0.05,1\n0.1,3\n0.15,2\n"}
        for name, text in files.items():
            (run.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (run.folder / name).write_text(text)
        resume(self.arguments("--resume"))
        read = lambda name: (run.folder / name).read_text()
        self.assertEqual(read("dem/start"), "read_restart dem/restart.10\n")
        self.assertIn("startTime 0.1;", read("foam/system/controlDict"))
        self.assertEqual(read("ledger.csv"), "time\n0\n")
        self.assertEqual(read("dem/bonds.csv"), "time,id1\n0.05,1\n0.1,3\n")

    def test_shipped_cases_that_resume(self):
        """Their scripts create particles through dem/start, and write the restart files that resume looks for."""
        for case in ("ice_entry", "free_entry"):
            script = (places.TOP / f"cases/{case}/dem/in.{case}").read_text()
            self.assertRegex(script, r"(?m)^include dem/start$")
            self.assertRegex(script, r"(?m)^fix \S+ \S+ couple/foam .*restart dem/restart\.\*")

    def test_resume_of_nothing(self):
        with self.assertRaisesRegex(Failure, "--resume: no run of toy"):
            resume(self.arguments("--resume"))

    def test_a_case_without_fluid_runs_particles_alone(self):
        (self.case / "case.json").write_text(json.dumps({**CASE, "pair": False}))
        self.program("frazilDem", "echo \"$@\" >arguments")
        run = plan(self.arguments())
        prepare(run)
        watch(run, start_programs(run))
        self.assertIn("-in dem/in.toy", (run.folder / "arguments").read_text())
        with self.assertRaisesRegex(Failure, "toy has no fluid"):
            plan(parser().parse_args(["run", str(self.case), "--np-foam", "2"]))

    def test_decomposition_cuts_the_horizontal_axes(self):
        self.assertIn("n (3 1 2)", decomposition(6))
        self.assertIn("n (5 1 1)", decomposition(5))

    def test_a_good_pair(self):
        self.assertEqual(self.run_pair("exit 0", "exit 0")[0], "")

    def test_results_of_a_run(self):
        """A whole `run`: metrics, curves, the table, and the case's check as exit status."""
        (self.case / "check").write_text("import sys; print('checked', sys.argv[1]); sys.exit(3)\n")
        for name, script in (("blockMesh", ":"), ("frazilDem", HISTORY), ("frazilFoam", ":")):
            self.program(name, script)
        with mock.patch.object(cli, "setup"):
            self.assertEqual(run_case(self.arguments()), 3)
        metrics = json.loads((self.folder / "out/metrics.json").read_text())
        self.assertEqual((metrics["fluid_steps"], metrics["last"]["broken_shear"]), (2, 4))
        self.assertTrue((self.folder / "out/summary.png").stat().st_size > 1000)

    def test_killed_particles(self):
        text, seconds = self.run_pair("sleep 0.5; kill -9 $$", "sleep 60")
        self.assertIn("frazilDem was killed (signal 9)", text)
        self.assertLess(seconds, 20)

    def test_killed_fluid(self):
        text, seconds = self.run_pair("sleep 60", "sleep 0.5; kill -9 $$")
        self.assertIn("frazilFoam was killed (signal 9)", text)
        self.assertLess(seconds, 20)

    def test_failing_fluid_shows_its_error(self):
        text, _ = self.run_pair("sleep 60", "echo '--> FOAM FATAL ERROR: no such patch'; exit 1")
        self.assertIn("FOAM FATAL ERROR: no such patch", text)
        self.assertIn("frazilFoam ended with exit code 1", text)

    def test_interrupt_lets_the_particles_end_the_run(self):
        """Ctrl-C: frazilDem gets SIGTERM and ends the pair; mpirun is not killed over it."""
        end = self.folder / "end"
        dem = f"trap 'touch {end}; exit 0' TERM; touch {end}.started; while :; do sleep 0.1; done"
        timer = threading.Thread(target=self.interrupt_when_there, args=(Path(f"{end}.started"),))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            self.run_pair(dem, f"while [ ! -e {end} ]; do sleep 0.1; done")
        timer.join()
        self.assertTrue(end.exists())

    @staticmethod
    def interrupt_when_there(path):
        while not path.exists():
            time.sleep(0.1)
        os.kill(os.getpid(), signal.SIGINT)

    def test_broken_case_json(self):
        (self.case / "case.json").write_text("{")
        with self.assertRaisesRegex(Failure, "toy/case.json: Expecting property name"):
            plan(self.arguments())

    def test_command_line_of_every_word(self):
        command = [places.TOP / "frazil", "--help"]
        shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        for word in ("setup", "exec", "run", "test"):
            self.assertIn(word, shown)


if __name__ == "__main__":
    unittest.main()
