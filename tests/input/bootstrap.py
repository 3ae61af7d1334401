"""The file `frazil` on machines without Python: what it says, what it installs, and that it starts the launcher then.

apt-get, id and python3 are played by shell scripts; /usr/bin/python3, which this machine has, is a folder of the test in a
copy of the file.
"""

import subprocess
import tempfile
import unittest
from pathlib import Path

from launcher.packages import needed_packages
from launcher.places import TOP

TOOLS = ("cat", "chmod", "dirname", "mktemp", "readlink", "rm", "tail")  # all that a bare Debian needs to have
INSTALL = """case "$*" in
*install*) printf '#!/bin/sh\\nfor word; do echo "<$word>"; done\\n' >"{python}"; chmod +x "{python}" ;;
esac"""


class Bootstrap(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="with blanks ")))
        self.bin, self.python = self.folder / "bin", self.folder / "python3"
        self.bin.mkdir()
        for tool in TOOLS:
            (self.bin / tool).symlink_to(f"/usr/bin/{tool}")
        self.frazil = self.folder / "frazil"
        self.frazil.write_text((TOP / "frazil").read_text().replace("/usr/bin/python3", f'"{self.python}"'))
        self.frazil.chmod(0o755)

    def program(self, name, script):
        path = self.bin / name
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)

    def start(self, *words, file=None):
        """(exit code, standard output, errors) of `frazil WORDS`."""
        done = subprocess.run(["/bin/sh", file or self.frazil, *words], capture_output=True, text=True, cwd="/",
                              env={"PATH": str(self.bin), "TMPDIR": str(self.folder)})
        return done.returncode, done.stdout, done.stderr

    def test_another_system_is_told_to_install_python(self):
        code, _, errors = self.start("setup")
        self.assertEqual((code, errors), (1, "frazil: needs python3 (3.8 or newer); install it and start again\n"))

    def test_a_user_is_told_what_to_type(self):
        self.program("apt-get", "exit 9")
        self.program("id", "echo 1000")
        code, _, errors = self.start("setup")
        self.assertEqual(code, 1)
        for package in needed_packages():
            self.assertIn(f" {package}", errors)

    def test_root_gets_python_and_goes_on(self):
        """With every word of the command line as it was, and no log left."""
        self.program("apt-get", INSTALL.format(python=self.python))
        self.program("id", "echo 0")
        code, out, errors = self.start("run", "a b", "--set", "c=d e")
        launcher = self.folder / "cases/tools/launcher"
        words = "".join(f"<{word}>\n" for word in ("-B", launcher, "run", "a b", "--set", "c=d e"))
        self.assertEqual((code, out, errors), (0, f"python3: not installed, installing it\n{words}", ""))
        self.assertEqual(list(self.folder.glob("tmp.*")), [])

    def test_installation_that_fails(self):
        self.program("apt-get", "echo no network; exit 100")
        self.program("id", "echo 0")
        code, _, errors = self.start("setup")
        self.assertEqual(code, 1)
        self.assertRegex(errors, r"no network\nfrazil: python3 could not be installed; the whole output is in .*/tmp\.")

    def test_through_a_link(self):
        """The launcher is looked for beside the file itself, from any folder."""
        self.program("python3", 'echo "$2"')
        link = self.folder / "link"
        link.symlink_to("frazil")
        self.assertEqual(self.start(file=link), (0, f"{self.folder / 'cases/tools/launcher'}\n", ""))

    def test_modules_of_the_users_folder(self):
        """Files of the folder in which the launcher is started are not taken for modules of the same name."""
        for name in ("launcher", "json", "csv"):
            (self.folder / f"{name}.py").write_text("raise SystemExit('the wrong module')\n")
        done = subprocess.run([TOP / "frazil", "--help"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
