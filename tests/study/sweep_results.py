"""What a sweep leaves: table with units in CSV and HDF5, figures, page; from run folders written here, with numbers by hand."""

import csv
import json
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import h5py, jinja2, matplotlib, yaml
except ImportError:
    sys.exit(77)  # CTest: skipped

import diagnostics
from sweep import metrics
from sweep.page import write_results
from sweep.plots import tied
from sweep.points import points
from sweep.reader import read_study
from sweep.study_folder import StudyFolder
from sweep.table import Column, Measured

STUDY = """title: Speeds
case: ice_entry
vary:
  impact_speed: [5, 10]
  layers: [2, 4]
metrics: [end_speed, peak_contact_force, double_speed]
depths: [0.05]
points: [{shielding: off}]
"""
BODY = 'bodies { projectile { surface "constant/triSurface/projectile.stl"; } }\n'
# its lowest corner is 20 mm below the centre of mass
STL = "solid a\nfacet\nvertex 0 -0.02 0\nvertex 0.01 0 0\nvertex 0 0 0.01\nendfacet\nendsolid\n"
HISTORY = "time,x,y,z,vx,vy,vz,wx,wy,wz,contact_fx,contact_fy,contact_fz\n"


class Results(unittest.TestCase):
    def setUp(self):
        scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (scratch / "study.yaml").write_text(STUDY)
        metrics.metric("twice the speed", "m/s")(double_speed)
        self.addCleanup(metrics.OWN.pop, "double_speed")
        self.study = read_study(scratch / "study.yaml")
        self.points, self.folder = points(self.study), StudyFolder(scratch / "out")

    def ran(self, name, speed, state):
        """A run whose body falls evenly from y = 0 to -40 mm, and hits with 3 N across and 4 N up."""
        run = self.folder.run(name)
        (run / "foam/constant/triSurface").mkdir(parents=True)
        (run / "foam/constant/couplingProperties").write_text(BODY)
        (run / "foam/constant/triSurface/projectile.stl").write_text(STL)
        (run / "run.json").write_text("{}")
        rows = f"0,0,0,0,0,-{speed},0,0,0,0,0,0,0\n1,0,-0.04,0,0,-{speed / 2},0,0,0,0,3,4,0\n"
        (run / "history.csv").write_text(HISTORY + rows)
        self.folder.status(name).write_text(json.dumps(state))

    def test_results(self):
        self.ran("impact_speed-5_layers-2", 5, {"status": "done", "check": "passed", "wall_seconds": 60.0})
        self.ran("impact_speed-10_layers-2", 10, {"status": "done", "check": "not passed", "wall_seconds": 80.0})
        self.ran("impact_speed-5_layers-4", 5, {"status": "failed", "why": "ERROR: <Lost> atoms", "wall_seconds": 1.0})
        write_results(self.study, self.points, Measured(self.study, self.folder), going_on=True)
        self.check_csv()
        self.check_hdf5()
        self.check_page()

    def check_csv(self):
        """By hand: the point at 20 mm below the centre passes 50 mm at three quarters of the way, at 62.5 % of the speed."""
        with open(self.folder.path / "results.csv") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["point", "impact_speed [m/s]", "layers", "shielding", "end_speed [m/s]",
                                   "peak_contact_force [N]", "double_speed [m/s]", "speed_at_0.05_m [m/s]", "wall_time [s]",
                                   "check", "status"])
        table = {row[0]: row[1:] for row in rows[1:]}
        self.assertEqual(table["impact_speed-5_layers-2"],
                         ["5", "2", "on", "2.5", "5", "5", "3.125", "60", "passed", "done"])
        self.assertEqual(table["impact_speed-5_layers-4"], ["5", "4", "on", "", "", "", "", "1", "", "failed"])
        self.assertEqual(table["shielding-off"], ["20", "4", "off", "", "", "", "", "", "", "waiting"])

    def check_hdf5(self):
        with h5py.File(self.folder.path / "results.h5") as file:
            self.assertEqual(file["end_speed"][0], 2.5)
            self.assertEqual(file["end_speed"].attrs["unit"], "m/s")
            self.assertEqual(file["status"].asstr()[0], "done")
            self.assertTrue(file["end_speed"][4] != file["end_speed"][4])

    def check_page(self):
        """Self-contained: every figure is in it, nothing is loaded; words of programs are text."""
        page = (self.folder.path / "index.html").read_text()
        files = {path.name for path in (self.folder.path / "plots").iterdir()}
        self.assertIn("end_speed_over_impact_speed.png", files)
        self.assertEqual(page.count('src="data:image/png;base64,'), len(files))
        self.assertNotRegex(page, r'src="(?!data:)|href=|url\(')
        for word in ("2 of 5 points done, 1 failed", "ERROR: &lt;Lost&gt; atoms", 'http-equiv="refresh"', "impact_speed [m/s]"):
            self.assertIn(word, page)

    def test_map(self):
        """Four points of two parameters have a map for each metric; two on a line have none between them, and no error."""
        for name, speed in (("5_layers-2", 5), ("10_layers-2", 10), ("5_layers-4", 6), ("10_layers-4", 9)):
            self.ran(f"impact_speed-{name}", speed, {"status": "done", "wall_seconds": 1.0})
        write_results(self.study, self.points, Measured(self.study, self.folder), going_on=False)
        self.assertTrue((self.folder.path / "plots/end_speed_over_impact_speed_layers.png").stat().st_size > 5000)
        self.assertNotIn("refresh", (self.folder.path / "index.html").read_text())

    def test_tied_parameters(self):
        """Zipped lists are drawn as one parameter, those of a grid or a sample as two."""
        column = lambda *values: Column("", "", "", "parameter", list(values))
        self.assertTrue(tied(column(1, 2, 3), column(9, 5, 4)))
        self.assertFalse(tied(column(1, 1, 2, 2), column(5, 6, 5, 6)))
        self.assertFalse(tied(column(1, 2, 3), column(5, 9, 4)))

    def test_every_usual_metric_is_known(self):
        self.assertLessEqual(set(metrics.DEFAULT), metrics.known().keys())


def double_speed(run):
    """A metric is one function."""
    return 2 * diagnostics.VALUES["end_speed"](run)


if __name__ == "__main__":
    unittest.main()
