"""Starts the launcher: `python3 cases/tools/launcher COMMAND`, as `frazil` does, from any folder."""
import os
import sys

# the folder that holds the package, in place of the package's own folder or the user's, whose files may be named as modules
sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from launcher.cli import main

sys.exit(main())
