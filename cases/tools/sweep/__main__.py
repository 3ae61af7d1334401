"""Runs one point of a study: `python3 cases/tools/sweep FOLDER POINT`, as the Snakefile does."""
import os
import sys

# as the launcher's own __main__: the folder that holds the package, not the package's own
sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from sweep.point import main

sys.exit(main())
