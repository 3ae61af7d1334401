"""The real pair in a folder: frazilDem with in.two, frazilFoam with foam/. FRAZIL_BUILD names the build folder."""
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("FRAZIL_BUILD", ROOT / "build"))
SECONDS = 600  # a pair that takes longer hangs


def mesh(folder, tools=("blockMesh",)):
    """Runs OpenFOAM's tools in folder/foam."""
    for tool in tools:
        subprocess.run([ROOT / "frazil", "exec", tool], cwd=folder / "foam", check=True, stdout=subprocess.DEVNULL)


def launch(folder, dem_ranks=1, foam_ranks=1, script="in.two"):
    """Runs the pair to its end; a failure ends the test with what the programs said."""
    parallel = ["-parallel"] if foam_ranks > 1 else []
    with open(folder / "log.pair", "a") as log:
        code = subprocess.run(
            [ROOT / "frazil", "exec", "mpirun", "--oversubscribe", "-np", str(dem_ranks), BUILD / "bin/frazilDem", "-in",
             script, "-log", "log.dem", "-screen", "/dev/null", ":", "-np", str(foam_ranks), BUILD / "bin/frazilFoam",
             "-case", "foam", *parallel], cwd=folder, stdout=log, stderr=log, timeout=SECONDS).returncode
    if code:
        logs = "".join((folder / name).read_text(errors="replace")[-2000:] for name in ("log.dem", "log.pair"))
        sys.exit(f"{folder.name} on {dem_ranks}:{foam_ranks} ranks ended with {code}:\n{logs}")


def replace(path, *pairs):
    """Exact replacements in a file; each must be there."""
    text = path.read_text()
    for old, new in pairs:
        if old not in text:
            sys.exit(f"{path}: no '{old}' to replace")
        text = text.replace(old, new)
    path.write_text(text)


def say(passed, text):
    """One line of a test's output; returns whether it passed."""
    print("PASS" if passed else "FAIL", text, flush=True)
    return bool(passed)
