"""Turns a case's dem/ and foam/ into a run folder with the level's numbers in it."""
import json
import re
import shutil
import sys
from pathlib import Path

COMMON = Path(__file__).resolve().parent / "foam"  # what cases have alike: water and air, gravity, time, schemes, solvers
STOCK = {"tolerance": 1e-8, "write_interval": 0.1}  # of the linear solvers; of the fluid's output [s]


def arguments():
    """(run folder, parameters) of `prepare RUNFOLDER PARAMS.json`."""
    if len(sys.argv) != 3:
        sys.exit("usage: prepare RUNFOLDER PARAMS.json")
    return Path(sys.argv[1]), json.loads(Path(sys.argv[2]).read_text())


def copy_foam(source, run, numbers):
    """The common files, then those of the case's foam/, which may replace them, with 0.orig as 0. In all of them $name,
    OpenFOAM's own notation for a macro, becomes the number, given or stock, so that the run folder shows every value in its
    place."""
    foam, numbers = run / "foam", {**STOCK, **numbers}
    for files in (COMMON, source):
        shutil.copytree(files, foam, dirs_exist_ok=True)
    (foam / "0.orig").rename(foam / "0")
    pattern = re.compile(r"\$(" + "|".join(numbers) + r")\b")
    for path in [path for folder in ("0", "constant", "system") for path in (foam / folder).rglob("*") if path.is_file()]:
        path.write_text(pattern.sub(lambda match: text(numbers[match.group(1)]), path.read_text()))
    (foam / "constant/triSurface").mkdir(exist_ok=True)


def copy_dem(script, run, numbers, start=None, name=None):
    """dem/in.<case>, and dem/parameters, which it includes: one LIGGGHTS variable per number, a list as an index variable,
    whose values the script takes in turn.

    start: the commands that create box and particles, as dem/start, which the script includes; `--resume` puts
    read_restart in their place. name: of the case, where it is not the script's."""
    (run / "dem").mkdir(parents=True, exist_ok=True)
    shutil.copy(script, run / "dem" / (f"in.{name}" if name else script.name))
    lines = [f"variable {key} {'index' if isinstance(value, list) else 'string'} {words(value)}\n"
             for key, value in numbers.items()]
    (run / "dem/parameters").write_text("".join(lines))
    if start:
        (run / "dem/start").write_text(start)


def words(value):
    """A number, several, or words of a command: in quotes, because there may be none."""
    if isinstance(value, str):
        return f'"{value}"'
    return " ".join(map(text, value)) if isinstance(value, list) else text(value)


def text(value):
    """A number with all digits that matter; triples as OpenFOAM writes them."""
    if isinstance(value, (tuple, list)):
        return "(" + " ".join(map(text, value)) + ")"
    return f"{value:.10g}" if isinstance(value, float) else str(value)
