"""`frazil report`: what stands on the page, that nothing is fetched from elsewhere, and what it says to wrong input. The
figures' numbers are those of diagnostics_of_run.py."""
import contextlib
import html.parser
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

try:
    import made_run
    from diagnostics import Missing, Run
    from report import figure, scene, tables
    from report.curves import Curve, lines
    from report.page import page
    import jinja2
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)  # CTest: skipped

from launcher.places import TOP

SECTIONS = ["What was run", "Body", "Body in the study's units", "Ice", "Cracks", "Cuts through the axis", "In space", "Ledger",
            "Wall time", "Definitions"]


class Page(html.parser.HTMLParser):
    """Headings, table cells, images and open elements of a page."""

    def __init__(self, text):
        super().__init__()
        self.open, self.headings, self.cells, self.images = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.images.append(dict(attributes))
        elif tag not in ("meta", "link"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, f"</{tag}> closes another element"

    def handle_data(self, data):
        if self.open and self.open[-1] in ("h2", "th", "td"):
            (self.headings if self.open[-1] == "h2" else self.cells).append(data)


def shown(*folders, figures=False):
    """The page about these runs, without the figures' data, which nobody wants to see in a failure, and which take time."""
    with contextlib.nullcontext() if figures else mock.patch("matplotlib.figure.Figure.savefig"):
        return re.sub(r"base64,[^\"]*", "base64,", page([str(folder) for folder in folders]))


class Report(unittest.TestCase):
    def setUp(self):
        self.place = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.folder = made_run.make(self.place / "toy")
        self.enterContext(mock.patch.object(scene, "rendered", lambda run: None))  # matplotlib, wherever this test runs

    def test_one_run(self):
        """Every section, the tables' numbers in readable units, and figures that are in the file itself."""
        text = shown(self.folder, figures=True)
        found = Page(text)
        self.assertEqual(found.headings, SECTIONS)
        self.assertEqual(found.open, [])
        rows = dict(zip(found.cells, found.cells[1:]))
        self.assertEqual(rows["largest contact force [N]"], "5")
        self.assertEqual(rows["first contact with a sphere [ms]"], "1")
        self.assertEqual(rows["impulse of the contacts, upwards [mN s]"], "5")
        self.assertEqual(rows["loss of the ice, 1 - η"], "0.5")
        self.assertEqual(rows["state"], "complete: 2 ms")
        self.assertGreater(len(found.images), 20)
        for image in found.images:
            self.assertIn(image["src"], ("data:image/png;base64,", "data:image/svg+xml;base64,"))
            self.assertTrue(image["alt"])
        self.assertNotRegex(text, r"https?:|<link|<script|@import|url\(")

    def test_two_runs(self):
        """A column and a colour each; parameters that differ are marked."""
        other = made_run.make(self.place / "other")
        made_run.write(other / "params.json", '{"bond_young": 1e9, "ice_density": 900.0, "depth": 2}')
        text = shown(self.folder, other)
        self.assertIn("<title>toy and other</title>", text)
        self.assertRegex(text, r'<tr class="marked"><th scope="row">bond_young</th><td>900000000</td><td>1000000000</td>')
        self.assertRegex(text, r'<tr class="marked"><th scope="row">depth</th><td>–</td><td>2</td>')
        self.assertRegex(text, r'<tr><th scope="row">ice_density</th><td>900</td><td>900</td>')
        for colour in figure.PALETTE[:2]:
            self.assertIn(f"background: {colour}", text)

    def test_runs_of_the_same_name(self):
        other = made_run.make(self.place / "elsewhere/toy")
        self.assertIn(f"<title>{self.folder} and {other}</title>", shown(self.folder, other))

    def test_names_are_escaped(self):
        other = made_run.make(self.place / "a<b&c")
        self.assertIn("<title>a&lt;b&amp;c</title>", shown(other))

    def test_run_without_most_files(self):
        """Only a history, cut off in its last line: the rest is named with its reason."""
        bare = self.place / "bare"
        made_run.write(bare / "history.csv", made_run.csv(made_run.HISTORY)[:-4])
        text = shown(bare)
        self.assertEqual(Page(text).headings[:2], ["What was run", "Body"])
        self.assertIn("Not available", text)
        for section, file in (("Cracks", "dem/bonds.csv"), ("In space", "particles.h5"), ("Ledger", "ledger.csv")):
            self.assertIn(f"<b>{section}</b>: {bare}/{file}: does not exist", text)

    def test_run_that_has_just_begun(self):
        begun = self.place / "begun"
        made_run.write(begun / "params.json", "{}")
        self.assertIn("Not available", shown(begun))

    def test_curve_of_two_runs(self):
        """A run without the quantity leaves out its line, not the figure."""
        other = made_run.make(self.place / "other")
        (other / "ledger.csv").unlink()
        found = lines([Run(other), Run(self.folder)], Curve(("clipped_share",)))
        self.assertEqual([number for number, *_ in found.found], [1])
        self.assertEqual(len(found.missing), 1)

    def test_scaled_time_begins_with_the_touch(self):
        """1 ms after the start; D0/c = 16 µs."""
        (_, _, x, _), = lines([Run(self.folder)], Curve(("speed",), over="scaled time")).found
        self.assertEqual([round(value, 9) for value in x], [-62.5, 0, 62.5])

    def test_curve_of_zeros(self):
        made_run.write(self.folder / "ledger.csv", made_run.csv({**made_run.LEDGER, "dryParticles": (0, 0, 0)}))
        self.assertRaisesRegex(Missing, "dry particles: zero throughout", lines, [Run(self.folder)], Curve(("dry_particles",)))

    def test_numbers(self):
        for value, text in ((3.0, "3"), (12345.0, "12345"), (0.000123456, "0.0001235"), (-0.0, "0"), (2.5, "2.5")):
            self.assertEqual(tables.number(value), text)


class Vtk(unittest.TestCase):
    def setUp(self):
        self.folder = made_run.make(Path(self.enterContext(tempfile.TemporaryDirectory())) / "toy")

    @unittest.skipUnless(scene.screen() is not None, "neither VTK nor a screen for it")
    def test_image(self):
        self.assertEqual(scene.rendered(Run(self.folder))[:4], b"\x89PNG")

    def test_fails_quietly(self):
        """No VTK, or one that aborts: matplotlib draws."""
        for command in (None, ["false"]):
            with mock.patch.object(scene, "screen", lambda: command):
                self.assertIsNone(scene.rendered(Run(self.folder)))
        with mock.patch.object(scene, "screen", lambda: ["false"]):
            self.assertTrue(scene.draw(Run(self.folder), "wide").source.startswith("data:image/png"))


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.place = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_without_snapshots(self, name):
        """Has no view in space, which takes time where VTK is installed."""
        folder = made_run.make(self.place / name)
        (folder / "particles.h5").unlink()
        return folder

    def report(self, *words, **env):
        command = [sys.executable, "-B", str(TOP / "cases/tools/launcher"), "report", *map(str, words)]
        return subprocess.run(command, capture_output=True, text=True, env={**os.environ, **env})

    def test_page_is_in_the_first_run(self):
        folders = [self.run_without_snapshots(name) for name in ("one", "two")]
        done = self.report(*folders)
        self.assertEqual((done.stdout, done.returncode), (f"report: {folders[0]}/report.html\n", 0), done.stderr)
        self.assertIn("<title>one and two</title>", (folders[0] / "report.html").read_text())

    def test_output(self):
        done = self.report(self.run_without_snapshots("one"), "--output", self.place / "page.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.place / "page.html").is_file())

    def test_bad_folder(self):
        for words, said in ((["no"], "no: there is no such folder; name one that ./frazil run has made."),
                            ([self.place], f"{self.place}: is no run folder, it has none of run.json, "),
                            ([], "the following arguments are required: RUN")):
            done = self.report(*words)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(said, done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_package_missing(self):
        (self.place / "jinja2.py").write_text("raise ModuleNotFoundError('not here', name='jinja2')\n")
        done = self.report(made_run.make(self.place / "one"), PYTHONPATH=str(self.place))
        self.assertEqual(done.returncode, 1)
        self.assertIn("report needs Python's jinja2; install python3-jinja2", done.stderr)


if __name__ == "__main__":
    unittest.main()
