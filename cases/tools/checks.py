"""What the check scripts share: read the run folder, say PASS or FAIL."""
import sys
from pathlib import Path

from launcher.table import read_columns


def run_folder():
    """The argument of `check RUNFOLDER`."""
    if len(sys.argv) != 2:
        sys.exit("usage: check RUNFOLDER")
    return Path(sys.argv[1])


def table(path):
    """A CSV file as {column: [values]}; a FAIL line and the end if there is none."""
    if not path.is_file():
        print(f"FAIL {path.name}: the run left none (expected in {path.parent})")
        sys.exit(1)
    return read_columns(path)


class Checks:
    """Collects results; `end` leaves with status 1 if one failed."""

    def __init__(self):
        self.failed = 0

    def say(self, passed, name, value, expected):
        """One line."""
        self.failed += not passed
        print(f"{'PASS' if passed else 'FAIL'} {name}: {value} (expected {expected})")

    def near(self, name, value, expected, tolerance, unit=""):
        """|value - expected| <= tolerance."""
        self.say(abs(value - expected) <= tolerance, name, f"{value:.6g} {unit}".strip(),
                 f"{expected:.6g} ± {tolerance:.3g} {unit}".strip())

    def below(self, name, value, limit, unit=""):
        """value <= limit."""
        self.say(value <= limit, name, f"{value:.4g} {unit}".strip(), f"at most {limit:.4g} {unit}".strip())

    def above(self, name, value, limit, unit=""):
        """value > limit."""
        self.say(value > limit, name, f"{value:.4g} {unit}".strip(), f"above {limit:.4g} {unit}".strip())

    def ledger(self, run, limit=1e-8):
        """Every relative error of ledger.csv at every step."""
        columns = {name: values for name, values in table(run / "ledger.csv").items() if "error" in name.lower()}
        self.say(bool(columns), "ledger", f"{len(columns)} columns of relative errors", "at least one")
        for name, values in columns.items():
            self.below(f"ledger {name}, worst of {len(values)} steps", max(map(abs, values), default=1.0), limit)

    def end(self):
        """The exit status."""
        sys.exit(1 if self.failed else 0)


def at(time, times, values):
    """Linear interpolation of a history; its ends are held."""
    for n in range(1, len(times)):
        if times[n] >= time:
            share = (time - times[n - 1]) / (times[n] - times[n - 1]) if times[n] > times[n - 1] else 1.0
            return values[n - 1] + min(max(share, 0.0), 1.0) * (values[n] - values[n - 1])
    return values[-1]
