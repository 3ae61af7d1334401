"""Helpers of the scripts in foam/: tutorial copies, runs and fields of OpenFOAM, standard library only."""

import os
import pathlib
import re
import shutil
import subprocess

import mpirun

MPIRUN = mpirun.COMMAND


def openfoam_root():
    """Folder that holds src/, applications/ and tutorials/ of OpenFOAM, chosen as FindOpenFOAM.cmake does: a sourced
    environment first (the launcher sets FRAZIL_OPENFOAM_ROOT beside it)."""
    env = os.environ
    if env.get("FOAM_SRC") and env.get("FOAM_LIBBIN"):
        return pathlib.Path(env["WM_PROJECT_DIR"])
    if env.get("FRAZIL_OPENFOAM_ROOT"):
        return pathlib.Path(env["FRAZIL_OPENFOAM_ROOT"])
    cache = env.get("XDG_CACHE_HOME") or os.path.join(env["HOME"], ".cache")
    return pathlib.Path(cache) / "frazil" / "openfoam-1912"


def copy_case(source, target):
    """A fresh copy of a case."""
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target)
    return pathlib.Path(target)


def set_entry(path, key, value):
    """Replace `key ...;` in a dictionary."""
    text = pathlib.Path(path).read_text()
    text, count = re.subn(rf"(?m)^(\s*){key}\b[^;]*;", rf"\g<1>{key} {value};", text)
    if count == 0:
        raise SystemExit(f"{path}: no entry {key} to replace")
    pathlib.Path(path).write_text(text)


def run(command, folder, log):
    """Run a program in a folder; stop with the end of its log if it fails."""
    with open(pathlib.Path(folder) / log, "w") as out:
        code = subprocess.run([str(c) for c in command], cwd=folder, stdout=out, stderr=out, env=mpirun.environment()).returncode
    text = (pathlib.Path(folder) / log).read_text()
    if code != 0:
        raise SystemExit(f"{command} failed in {folder} (code {code}):\n" + text[-3000:])
    return text


def lists(path):
    """All nonuniform scalar and vector lists of a field file, each flat."""
    text = pathlib.Path(path).read_text()
    found = re.findall(r"List<(?:scalar|vector)>\s*\d+\s*\((.*?)\n\)", text, re.S)
    return [[float(x) for x in block.replace("(", " ").replace(")", " ").split()] for block in found]


def last_time(folder):
    """Name of the last time folder."""
    names = [p.name for p in pathlib.Path(folder).iterdir() if re.fullmatch(r"[0-9.e+-]+", p.name)]
    return max(names, key=float)
