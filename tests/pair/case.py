"""A shipped case as a test: prepares it as `./frazil run` does, runs the pair, asserts what its `check` asserts.

usage: case.py CASE [KEY=VALUE ...]     FRAZIL_BUILD names the build folder
"""

import os
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "input_errors"))
import frazil_launcher

launcher = frazil_launcher.load()
if "FRAZIL_BUILD" in os.environ:
    launcher.BUILD = Path(os.environ["FRAZIL_BUILD"])


def run(case, folder, settings=()):
    """Runs a case in `folder`; returns its Run."""
    words = ["run", case, "--out", str(folder)] + [word for setting in settings for word in ("--set", setting)]
    planned = launcher.plan(launcher.parser().parse_args(words))
    launcher.prepare(planned)
    launcher.watch(planned, launcher.start_programs(planned))
    return planned


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        try:
            sys.exit(launcher.check(run(sys.argv[1], folder, sys.argv[2:])))
        except launcher.Failure as failure:
            sys.exit(str(failure))
