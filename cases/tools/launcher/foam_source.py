"""OpenFOAM's headers. Debian has no -dev package: they come from its source package, once for all checkouts."""
from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import tarfile
import time
from pathlib import Path

from . import places
from .packages import foam_is_sourced
from .say import clock, Failure, logged, output_of, tail


FOAM_PARTS = ("src", "wmake", "META-INFO", "applications/solvers/multiphase", "tutorials/multiphase")


FOAM_LIBRARIES = (
    "OpenFOAM", "OSspecific/POSIX", "finiteVolume", "meshTools", "sampling", "surfMesh", "fileFormats", "dynamicMesh",
    "dynamicFvMesh", "fvOptions", "waveModels", "TurbulenceModels/turbulenceModels", "TurbulenceModels/incompressible",
    "transportModels/compressible", "transportModels/incompressible", "transportModels/interfaceProperties",
    "transportModels/twoPhaseMixture", "transportModels/twoPhaseProperties",
    "transportModels/immiscibleIncompressibleTwoPhaseMixture")


def foam_folder() -> Path:
    """Where the headers of Debian's OpenFOAM are kept: outside the checkout, shared by all checkouts."""
    if "FRAZIL_OPENFOAM_ROOT" in os.environ:
        return Path(os.environ["FRAZIL_OPENFOAM_ROOT"])
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "frazil" / "openfoam-1912"


def source_lines() -> list[str]:
    """deb-src lines for the archives from which apt would install openfoam, taken from the system's own sources."""
    versions = output_of(["apt-cache", "madison", "openfoam"]).splitlines()
    offers = {line.split("|")[2].split()[0].rstrip("/") for line in versions}
    fields = "$(REPO_URI)|$(RELEASE)|$(COMPONENT)|$(SIGNED_BY)"
    targets = output_of(["apt-get", "indextargets", "--format", fields, "Created-By: Packages"])
    lines = []
    for uri, release, component, key in (line.split("|") for line in targets.splitlines()):
        if uri.rstrip("/") in offers:
            signed = f"[signed-by={key}] " if key.startswith("/") else ""
            lines.append(f"deb-src {signed}{uri} {release} {component}")
    if not lines:
        raise Failure("apt knows no archive that offers the package openfoam; Debian 12's main component does.")
    return lines


def apt_elsewhere(folder: Path) -> list[str]:
    """apt options that keep its lists and sources in our folder, so that the system's configuration is not touched."""
    (folder / "lists/partial").mkdir(parents=True, exist_ok=True)
    (folder / "cache/archives/partial").mkdir(parents=True, exist_ok=True)
    settings = {"Dir::Etc::sourcelist": folder / "src.list", "Dir::Etc::sourceparts": "-",
                "Dir::State::lists": folder / "lists", "Dir::Cache": folder / "cache",
                "Acquire::Retries": 3, "APT::Sandbox::User": "root"}
    return [word for key, value in settings.items() for word in ("-o", f"{key}={value}")]


def upstream_tarball(options: list[str]) -> tuple[str, str]:
    """(sha256, name) of OpenFOAM's original source, from the signed index."""
    index = output_of(["apt-cache", *options, "showsrc", "openfoam"])
    found = re.search(r"^ ([0-9a-f]{64}) \d+ (openfoam_1912\S*\.orig\.tar\.\w+)$", index, re.MULTILINE)
    if not found:
        raise Failure("the archive's source index has no openfoam 1912; source a newer OpenFOAM.")
    return found.group(1), found.group(2)


def sha256(path: Path) -> str:
    """Checksum of a file; empty if it is not there."""
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else ""


def download_foam(folder: Path) -> Path:
    """Fetches the source package with apt, which resumes what an earlier try left; checks the tarball we need.

    Only the original tarball counts: a mirror that lacks the Debian part of the package does no harm."""
    options = apt_elsewhere(folder)
    (folder / "src.list").write_text("\n".join(source_lines()) + "\n")
    for attempt in range(4):
        time.sleep(5 * attempt)
        if logged("source index", ["apt-get", *options, "update"], places.setup_log(), check=False) == 0:
            break
    checksum, name = upstream_tarball(options)
    tarball = folder / name
    fetch = ["apt-get", *options, "source", "--download-only", "openfoam"]
    megabytes = lambda: f"{tarball.stat().st_size / 1e6:.0f} MB" if tarball.is_file() else ""
    for attempt in range(4):
        if sha256(tarball) == checksum:
            return tarball
        time.sleep(5 * attempt)
        logged("OpenFOAM's source package", fetch, places.setup_log(), megabytes, check=False, cwd=folder)
    raise Failure("\n".join([*tail(places.setup_log(), 12), f"{name} is not complete; start ./frazil setup again to resume."]))


def extract_foam(tarball: Path, folder: Path) -> None:
    """Unpacks the parts of OpenFOAM that a build or a test reads."""
    with tarfile.open(tarball) as archive:
        for member in archive:
            member.name = member.name.partition("/")[2]
            if member.name.startswith(tuple(part + "/" for part in FOAM_PARTS)) and ".." not in member.name.split("/"):
                archive.extract(member, folder, set_attrs=not member.issym())


def link_headers(folder: Path) -> None:
    """Makes the lnInclude folders by OpenFOAM's own script."""
    env = dict(os.environ, WM_DIR=str(folder / "wmake"), WM_PROJECT_DIR=str(folder))
    for library in FOAM_LIBRARIES:
        command = [folder / "wmake/wmakeLnInclude", "-s", folder / "src" / library]
        subprocess.run(command, env=env, check=True, capture_output=True)


def fetch_foam_headers() -> None:
    """OpenFOAM's headers: Debian has no -dev package, its source package has them. All or nothing, by a rename."""
    folder, header = foam_folder(), "src/finiteVolume/lnInclude/fvCFD.H"
    if foam_is_sourced() or (folder / header).exists():
        return
    if "FRAZIL_OPENFOAM_ROOT" in os.environ:
        raise Failure(f"FRAZIL_OPENFOAM_ROOT is {folder}, and {header} is not there. Unset it to fetch the headers.")
    download = folder.with_name(folder.name + ".download")
    tarball = download_foam(download)
    start = time.monotonic()
    print("OpenFOAM's headers: unpacking", flush=True)
    partial = folder.with_name(f"{folder.name}.partial-{os.getpid()}")
    shutil.rmtree(partial, ignore_errors=True)
    extract_foam(tarball, partial)
    link_headers(partial)
    shutil.rmtree(folder, ignore_errors=True)
    partial.rename(folder)
    shutil.rmtree(download)
    print(f"OpenFOAM's headers: in {folder} after {clock(time.monotonic() - start)}", flush=True)
