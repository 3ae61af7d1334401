"""What `frazil sweep` needs beyond the launcher: too much for every user (Snakemake's packages take 700 MB), so it is
installed when it is first wanted."""
from __future__ import annotations

import shutil

from launcher.packages import install
from launcher.say import Failure, output_of


def need_snakemake() -> None:
    """Snakemake 7, as Debian 12 has it: `--cluster` is gone from version 8 on."""
    if not shutil.which("snakemake"):
        install(["snakemake"])
    version = output_of(["snakemake", "--version"]).strip()
    if version.split(".")[0] != "7":
        raise Failure(f"snakemake {version or 'does not start'}: the sweep is written for version 7, Debian 12's. "
                      "Put a version 7 first in PATH.")
