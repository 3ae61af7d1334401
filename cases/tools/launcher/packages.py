"""Debian's packages: what this system lacks of them, and their installation."""
from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
from pathlib import Path

from . import places
from .say import Failure, logged

FOAM_PACKAGES = {"openfoam", "libopenfoam"}
LIGGGHTS_PACKAGES = {"liggghts", "libliggghts-dev"}


def foam_is_sourced() -> bool:
    """True where the user has sourced an OpenFOAM environment with headers, which is then used instead of Debian's."""
    source = os.environ.get("FOAM_SRC")
    return bool(source and os.environ.get("FOAM_LIBBIN") and Path(source, "OpenFOAM/lnInclude").is_dir())


def needed_packages() -> list[str]:
    """Debian packages that this system needs: the list in the file `frazil`, less what the user brings."""
    text = re.search(r"packages='([^']*)'", (places.TOP / "frazil").read_text()).group(1)
    brought = FOAM_PACKAGES if foam_is_sourced() else set()
    brought = brought | LIGGGHTS_PACKAGES if "LIGGGHTS_ROOT" in os.environ else brought
    return [name for name in text.split() if name not in brought]


def missing_packages() -> list[str]:
    """Those not installed. Without dpkg the dependencies are the user's business and CMake names what it misses."""
    if not shutil.which("dpkg-query"):
        return []
    query = ["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status}\n", *needed_packages()]
    known = subprocess.run(query, capture_output=True, text=True).stdout.split("\n")
    installed = {line.split()[0] for line in known if line.endswith(" installed")}
    return [name for name in needed_packages() if name not in installed]


def install_packages() -> None:
    """Installs what a set-up misses."""
    missing = missing_packages()
    if missing:
        install(missing)


def install(packages: list[str]) -> None:
    """Installs packages as root; tells anyone else the line to type."""
    if os.geteuid() != 0 or not shutil.which("apt-get"):
        raise Failure("packages are missing. Install them and start again:\n  sudo apt-get update && "
                      f"sudo apt-get install --no-install-recommends {' '.join(packages)}")
    quiet = dict(os.environ, DEBIAN_FRONTEND="noninteractive")
    apt = ["apt-get", "-o", "Acquire::Retries=3", "-o", "DPkg::Lock::Timeout=120"]
    logged("package lists", [*apt, "update"], places.setup_log(), check=False, env=quiet)
    command = [*apt, "install", "-y", "--no-install-recommends", *packages]
    logged(f"{len(packages)} packages", command, places.setup_log(), env=quiet)


def need(*modules: str) -> None:
    """Installs Debian's packages of Python modules that only some commands want, where they are not there."""
    missing = [f"python3-{module}" for module in modules if not importlib.util.find_spec(module)]
    if missing:
        install(missing)
        importlib.invalidate_caches()
