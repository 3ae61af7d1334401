"""`python3 -m launcher`, as `frazil` starts it."""
import sys

from .cli import main

sys.exit(main())
