"""A real calibration with frazilDem: ice of three layers, which must have the modulus, Poisson's ratio and strengths asked for.

The specimens are measured again from their curves, so that the table is no tautology; the script's lines hold what was measured.
A second one asks for what bonds cannot have together: it says so and ends with status 1, both errors equal and opposite.
"""
import argparse
import contextlib
import io
import json
import tempfile
from pathlib import Path

import checks
from calibrate.command import calibrate
from calibrate.options import add_options
from specimen import Curve


def search(folder, *words):
    """(status, what was said, calibration.json) of a calibration."""
    parser = argparse.ArgumentParser()
    add_options(parser)
    with contextlib.redirect_stdout(io.StringIO()) as said:
        status = calibrate(parser.parse_args(["--layers", "3", "--out", str(folder), *words]))
    return status, said.getvalue(), json.loads((folder / "calibration.json").read_text())


def met(result, folder):
    """Modulus, Poisson's ratio and strengths within 3 %."""
    status, said, found = search(folder, "--young", "0.7e9", "--bending", "0.81e6", "--compression", "2.56e6", "--poisson", "0.25")
    last, ratio = folder / f"round-{len(found['rounds'])}", found["bonds"]["stiffness_ratio"]
    result.near("status", status, 0, 0)
    pulled, bent = Curve(last / "tension-1", ratio), Curve(last / "bending-1", ratio)
    pressed = Curve(last / "compression-1", ratio, -1)
    result.near("E in tension [MPa]", pulled.modulus() / 1e6, 700, 21)
    result.near("Poisson's ratio", pulled.poisson(), 0.25, 0.0075)
    result.say(f"stiffness_ratio {ratio:g}" in said and ratio > 2.66, "κ found", f"{ratio:g}", "in the script's lines, above 2.66")
    result.near("strength in bending [MPa]", bent.strength()[0] / 1e6, 0.81, 0.0243)
    result.near("strength in compression [MPa]", pressed.strength()[0] / 1e6, 2.56, 0.0768)
    script = (last / "tension-1/dem/parameters").read_text()
    result.say(f"young {found['bonds']['young']:.4g}" in said and f"{found['bonds']['young']:.10g}" in script, "bonds",
               said.strip().splitlines()[-4], "those of the last specimens")


def compromise(result, folder):
    """Bending 1.3 times tension, where the lattice has 0.9 times."""
    status, said, found = search(folder, "--young", "0.7e9", "--bending", "1.3e6", "--tension", "1e6", "--compression", "2.56e6",
                                 "--rounds", "2")
    errors = found["rounds"][-1]["errors"]
    result.near("status", status, 1, 0)
    result.say("cannot be met together: bending and tension" in said, "said before", said.splitlines()[0][:60], "the conflict")
    result.near("errors of bending and tension are opposite", errors["bending"] + errors["tension"], 0, 0.03)


result = checks.Checks()
with tempfile.TemporaryDirectory() as scratch:
    met(result, Path(scratch, "met"))
    compromise(result, Path(scratch, "compromise"))
result.end()
