"""The launcher as a module: `import frazil_launcher; launcher = frazil_launcher.load()`."""

import importlib.machinery
import importlib.util
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]


def load():
    """The file `frazil`, which has no .py suffix, as the module `frazil`."""
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("frazil", str(TOP / "frazil"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("frazil", loader))
    sys.modules["frazil"] = module
    loader.exec_module(module)
    return module
