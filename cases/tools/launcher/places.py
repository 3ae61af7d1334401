"""Where things are: the checkout, and the build folder, which FRAZIL_BUILD moves elsewhere."""
from __future__ import annotations

import os
from pathlib import Path

TOP = Path(__file__).resolve().parents[3]
BUILD = Path(os.environ.get("FRAZIL_BUILD", TOP / "build"))


def setup_log() -> Path:
    """What the commands of a set-up printed."""
    return BUILD / "setup.log"


def python_path() -> str:
    """PYTHONPATH of prepare, check and test scripts: the modules that they share."""
    own = [str(TOP / "cases/tools"), str(TOP / "tests/harness"), os.environ.get("PYTHONPATH", "")]
    return os.pathsep.join(dict.fromkeys(filter(None, os.pathsep.join(own).split(os.pathsep))))
