"""The study file and its points: numbers worked out by hand, names that stay, and words for every mistake."""

import math
import re
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

try:
    import scipy, yaml
except ImportError:
    sys.exit(77)  # CTest: skipped

from launcher import packages
from launcher.places import TOP
from launcher.say import Failure
from sweep import needs
from sweep.points import point_name, points
from sweep.reader import read_study

HEAD = "case: ice_entry\nset: {end_time: 4e-3}\n"


class Study(unittest.TestCase):
    def study(self, text, head=HEAD):
        path = Path(self.enterContext(tempfile.TemporaryDirectory())) / "study.yaml"
        path.write_text(head + text)
        return read_study(path)

    def values(self, text):
        return list(points(self.study(text)).values())

    def refuses(self, text, *words, head=HEAD):
        with self.assertRaises(Failure) as caught:
            points(self.study(text, head))
        for word in ("study.yaml: ", *words):
            self.assertIn(word, str(caught.exception))


class Points(Study):
    def test_product(self):
        """2 x 2, the last parameter fastest."""
        found = self.values("vary: {impact_speed: [5, 10], layers: [2, 4]}")
        self.assertEqual(found, [{"impact_speed": 5, "layers": 2}, {"impact_speed": 5, "layers": 4},
                                 {"impact_speed": 10, "layers": 2}, {"impact_speed": 10, "layers": 4}])

    def test_ranges(self):
        """Both ends; steps of 0.3 from 1 to 2 end at 1.9; three values of a log range have the geometric mean in the middle."""
        one = lambda text: [next(iter(point.values())) for point in self.values(f"vary: {{{text}}}")]
        self.assertEqual(one("impact_speed: {from: 5, to: 40, count: 8}"), [5, 10, 15, 20, 25, 30, 35, 40])
        self.assertEqual(one("stiffness_ratio: {from: 1, to: 2, step: 0.3}"), [1, 1.3, 1.6, 1.9])
        self.assertEqual(one("bond_young: {from: 1e8, to: 1e10, count: 3, scale: log}"), [1e8, 1e9, 1e10])
        self.assertTrue(all(type(value) is int for value in one("layers: {from: 2, to: 6, count: 3}")))

    def test_zip(self):
        found = self.values("combine: zip\nvary: {impact_speed: [5, 10], layers: [2, 4]}")
        self.assertEqual(found, [{"impact_speed": 5, "layers": 2}, {"impact_speed": 10, "layers": 4}])

    def test_explicit_points_come_last_and_once(self):
        found = self.values("vary: {impact_speed: [5, 10]}\npoints: [{impact_speed: 10.0}, {gap: 0.01}]")
        self.assertEqual(found, [{"impact_speed": 5}, {"impact_speed": 10}, {"gap": 0.01}])

    def test_repeats(self):
        found = self.values("vary: {impact_speed: [5]}\nrepeats: 2\npoints: [{weibull_modulus: 9}]")
        self.assertEqual(found, [{"impact_speed": 5, "weibull_seed": 1}, {"impact_speed": 5, "weibull_seed": 2},
                                 {"weibull_modulus": 9, "weibull_seed": 1}, {"weibull_modulus": 9, "weibull_seed": 2}])

    def test_latin_hypercube(self):
        """Every tenth of each parameter is met once; whole numbers from 2 to 6, twice each; the seed decides."""
        text = ("combine: latin_hypercube\ncount: 10\nseed: {}\n"
                "vary: {{impact_speed: {{from: 10, to: 20}}, layers: {{from: 2, to: 6}}}}")
        found = self.values(text.format(1))
        self.assertEqual(sorted(math.floor(point["impact_speed"] - 10) for point in found), list(range(10)))
        self.assertEqual(sorted(point["layers"] for point in found), [2, 2, 3, 3, 4, 4, 5, 5, 6, 6])
        self.assertEqual(found, self.values(text.format(1)))
        self.assertNotEqual(found, self.values(text.format(2)))

    def test_sobol_grows(self):
        """Eight points: one in each eighth; sixteen contain them."""
        text = "combine: sobol\ncount: {}\nvary: {{impact_speed: {{from: 0, to: 8}}, gap: {{from: 1e-3, to: 1, scale: log}}}}"
        eight, sixteen = self.values(text.format(8)), self.values(text.format(16))
        self.assertEqual(sorted(math.floor(point["impact_speed"]) for point in eight), list(range(8)))
        self.assertEqual(sixteen[:8], eight)

    def test_names(self):
        """Readable, without the order of the file, equal for equal values; a checksum where words do not fit."""
        self.assertEqual(point_name({"layers": 4, "impact_speed": 10.0}), "impact_speed-10_layers-4")
        self.assertEqual(point_name({"impact_speed": 10, "layers": 4}), "impact_speed-10_layers-4")
        self.assertEqual(point_name({"stiffness_ratios": [1, 2.66]}), "stiffness_ratios-1+2.66")
        self.assertRegex(point_name({"shielding": "a/b"}), r"^shielding-a-b_[0-9a-f]{8}$")
        self.assertLess(len(point_name({f"parameter_{n}": n for n in range(40)})), 120)

    def test_added_points_leave_the_names(self):
        few = points(self.study("vary: {impact_speed: [5, 10]}"))
        more = points(self.study("vary: {impact_speed: [3, 5, 7, 10]}"))
        self.assertLessEqual(few.items(), more.items())

    def test_words_of_yaml(self):
        """on is a word and 4e-3 a number, as in the JSON of the cases."""
        study = self.study("vary: {shielding: [on, off], bond_damping: [5e-2]}")
        self.assertEqual((study.vary["shielding"], study.set), (["on", "off"], {"end_time": 0.004}))


class Shipped(unittest.TestCase):
    def test_studies(self):
        """Each can be read, has points, and is in README's table."""
        rows = re.findall(r"^\| \[.*?\]\((cases/.*?\.yaml)\) \|", (TOP / "README.md").read_text(), re.MULTILINE)
        files = sorted(str(path.relative_to(TOP)) for path in TOP.glob("cases/*/studies/*.yaml"))
        self.assertEqual(sorted(rows), files)
        for file in files:
            self.assertGreater(len(points(read_study(TOP / file))), 1)


class Needs(unittest.TestCase):
    def test_missing_packages_are_asked_for(self):
        with mock.patch("os.geteuid", return_value=1000), self.assertRaisesRegex(Failure, "apt-get install .* python3-nosuch"):
            packages.need("nosuch", "json")

    def test_another_snakemake(self):
        """--cluster is gone in version 8: said before anything runs."""
        self.enterContext(mock.patch("shutil.which", return_value="snakemake"))
        self.enterContext(mock.patch.object(needs, "output_of", return_value="8.4.1\n"))
        with self.assertRaisesRegex(Failure, "snakemake 8.4.1: .* version 7"):
            needs.need_snakemake()


class Mistakes(Study):
    def test_keys(self):
        self.refuses("vry: {gap: [1]}", "vry", "Did you mean vary?")
        self.refuses("vary: {impact_sped: [5]}", "vary.impact_sped", "Did you mean impact_speed?")
        self.refuses("vary: {gap: {from: 1, to: 2, cont: 3}}", "vary.gap.cont 3", "Did you mean count?")
        self.refuses("vary: {gap: [1]}\nvary: {gap: [2]}", "vary stands twice", "line 4")
        self.refuses("metrics: [peak_contact_forse]\nvary: {gap: [1]}", "Did you mean peak_contact_force?")

    def test_case_and_level(self):
        self.refuses("", "case: is missing", head="level: demo\n")
        self.refuses("level: demi\nvary: {gap: [1]}", 'level "demi"', "Did you mean demo?")

    def test_kinds(self):
        self.refuses("vary: {gap: [wide]}", 'vary.gap "wide"', "gap is like 0.012")
        self.refuses("vary: {layers: [2.5]}", "layers is a whole number")
        self.refuses("vary: {layers: {from: 2, to: 5, count: 3}}", "vary.layers 3.5", "layers is a whole number")
        self.refuses("np: {den: 1}\nvary: {gap: [1]}", "np.den 1", "dem: 1, foam: 1")
        self.refuses("repeats: two\nvary: {gap: [1]}", 'repeats "two": is no int')

    def test_ranges(self):
        self.refuses("vary: {gap: 1}", "neither a list nor a range", "count: 8")
        self.refuses("vary: {gap: {from: 2, to: 1, count: 3}}", "does not rise")
        self.refuses("vary: {gap: {from: 1, to: 2}}", "needs `count` or `step`")
        self.refuses("vary: {gap: {from: 1, to: 2, count: 1}}", "a count is at least 2")
        self.refuses("vary: {gap: {from: 0, to: 2, count: 3, scale: log}}", "log needs from > 0")

    def test_combinations(self):
        self.refuses("combine: zap\nvary: {gap: [1]}", "Did you mean zip?")
        self.refuses("combine: zip\nvary: {gap: [1], layers: [2, 4]}", "different numbers of values")
        self.refuses("combine: sobol\ncount: 12\nvary: {gap: {from: 1, to: 2}}", "powers of two", "Give 8 or 16.")
        self.refuses("combine: sobol\ncount: 8\nvary: {gap: [1, 2]}", "is no range")
        self.refuses("combine: sobol\nvary: {gap: {from: 1, to: 2}}", "needs the number of points")
        self.refuses("", "nothing varies")

    def test_repeats_of_equal_bonds(self):
        self.refuses("repeats: 3\nvary: {gap: [1]}", "repeats 3: all bonds are equally strong", "Set weibull_modulus.")
        self.refuses("repeats: 3\nvary: {gap: [1]}", "weibull_seed, which free_entry does not have", head="case: free_entry\n")


if __name__ == "__main__":
    unittest.main()
