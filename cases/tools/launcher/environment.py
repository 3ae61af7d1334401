"""The environment in which the pair, OpenFOAM's tools and the scripts of the cases run."""
from __future__ import annotations

import os

from . import places
from .foam_source import foam_folder


def environment() -> dict[str, str]:
    """The environment in which the pair and the host programs run.

    Open MPI: more ranks than cores are allowed, and then a waiting rank must leave the core to the other side. The
    single-copy mechanism of its shared memory needs ptrace rights that containers lack, and only costs a warning."""
    env = dict(os.environ)
    for key, folder in (("PATH", "bin"), ("LD_LIBRARY_PATH", "lib")):
        env[key] = f"{places.BUILD / folder}{os.pathsep + env[key] if env.get(key) else ''}"
    env.update(PYTHONPATH=places.python_path(), PYTHONDONTWRITEBYTECODE="1")  # no __pycache__ in the checkout
    env.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    env.update(OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_mpi_yield_when_idle="1",
               OMPI_MCA_btl_vader_single_copy_mechanism="none", FRAZIL_OPENFOAM_ROOT=str(foam_folder()))
    if os.geteuid() == 0:
        env.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return env
