"""`frazil setup`: packages, headers, build."""
from __future__ import annotations

import argparse
import os
import re
import shlex
import sys
import time

from . import places
from .foam_source import fetch_foam_headers, foam_folder
from .packages import foam_is_sourced, install_packages
from .say import clock, logged, tail


def build() -> None:
    """Configures if that was never done, then builds what changed. FRAZIL_CMAKE_ARGS adds options for cmake."""
    arguments = shlex.split(os.environ.get("FRAZIL_CMAKE_ARGS", ""))
    cache = places.BUILD / "CMakeCache.txt"
    configured = cache.is_file() and any((places.BUILD / name).is_file() for name in ("build.ninja", "Makefile"))
    if arguments or not configured:
        fresh = [] if cache.is_file() else ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        found = [f"-DPython3_EXECUTABLE={sys.executable}"]
        found += [] if foam_is_sourced() else [f"-DFRAZIL_OPENFOAM_ROOT={foam_folder()}"]
        logged("configure", ["cmake", "-S", str(places.TOP), "-B", str(places.BUILD), *fresh, *found, *arguments], places.setup_log())
    logged("build", ["cmake", "--build", str(places.BUILD), "--parallel"], places.setup_log(), build_progress)


def build_progress() -> str:
    """Ninja's [done/all], or make's percentage."""
    found = re.findall(r"^\[ *[\d/]+%?\]", "\n".join(tail(places.setup_log(), 200)), re.MULTILINE)
    return found[-1] if found else ""


def setup(_: argparse.Namespace | None = None) -> int:
    """Brings the system to the point where cases and tests run. Quick when there is nothing to do."""
    start = time.monotonic()
    places.BUILD.mkdir(exist_ok=True)
    places.setup_log().write_bytes(b"")
    install_packages()
    fetch_foam_headers()
    build()
    print(f"set up: {places.BUILD / 'bin'} is ready ({clock(time.monotonic() - start)})", flush=True)
    return 0
