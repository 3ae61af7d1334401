"""A case is a folder with a case.json: help and README must show every one, with its question."""

import re
import subprocess
import unittest

from launcher.case import find_case, read, shipped
from launcher.places import TOP


UNITS = {"sphere_diameter": "m", "impact_speed": "m/s", "end_time": "s", "ice_density": "kg/m3", "bond_young": "Pa",
         "tensile_strength": "Pa", "shear_strength": "Pa"}  # what several cases have


class ShippedCases(unittest.TestCase):
    def test_table_of_the_readme(self):
        """A row each and no other: question, levels, and whether frazilDem runs alone, as case.json has them."""
        rows = re.findall(r"^\| \[\w+\]\(cases/\w+/README\.md\) \|.*$", (TOP / "README.md").read_text(), re.MULTILINE)
        self.assertEqual(sorted(rows), sorted(map(self.row, shipped())))

    @staticmethod
    def row(name):
        text = read(find_case(name))
        fluid = "" if text["pair"] else " (no fluid)"
        return f"| [{name}](cases/{name}/README.md) | {text['question']}{fluid} | {', '.join(text['levels'])} |"

    def test_help_of_run(self):
        shown = subprocess.run([TOP / "frazil", "run", "--help"], capture_output=True, text=True, check=True).stdout
        for name in shipped():
            self.assertRegex(shown, rf"(?m)^  {name} +{re.escape(read(find_case(name))['question'])}$")

    def test_parameters_of_tests(self):
        """`test` overrides parameters of the default level."""
        for name in shipped():
            text = read(find_case(name))
            self.assertLessEqual(text.get("test", {}).keys(), text["levels"][text["default_level"]].keys())

    def test_units(self):
        """Of parameters that there are, and the same ones in all cases."""
        for name in shipped():
            text = read(find_case(name))
            parameters = set().union(*text["levels"].values())
            self.assertLessEqual(text["units"].keys(), parameters)
            self.assertLessEqual(parameters & UNITS.keys(), text["units"].keys())
            for parameter in text["units"].keys() & UNITS.keys():
                self.assertEqual(text["units"][parameter], UNITS[parameter], f"{name}: {parameter}")


if __name__ == "__main__":
    unittest.main()
