"""A shipped case as a test: prepares it as `./frazil run` does, runs the pair, asserts what its `check` asserts.

usage: case.py CASE [KEY=VALUE ...]     over the `test` parameters of its case.json; FRAZIL_BUILD names the build folder
"""
import json
import sys
import tempfile

from launcher.case import find_case, read
from launcher.cli import parser
from launcher.results import check
from launcher.run import plan, prepare
from launcher.say import Failure
from launcher.watch import start_programs, watch


def planned(case, folder, settings=(), np_foam=1):
    """The Run of a case in `folder`, not prepared yet."""
    ranks = ["--np-foam", str(np_foam)] if np_foam > 1 else []
    words = ["run", case, "--out", str(folder), *ranks] + [word for setting in settings for word in ("--set", setting)]
    return plan(parser().parse_args(words))


def run(case, folder, settings=()):
    """Runs a case in `folder`; returns its Run."""
    one = planned(case, folder, settings)
    prepare(one)
    watch(one, start_programs(one))
    return one


def main():
    case, *settings = sys.argv[1:]
    quick = [f"{key}={json.dumps(value)}" for key, value in read(find_case(case)).get("test", {}).items()]
    with tempfile.TemporaryDirectory() as folder:
        try:
            sys.exit(check(run(case, folder, [*quick, *settings])))
        except Failure as failure:
            sys.exit(str(failure))


if __name__ == "__main__":
    main()
