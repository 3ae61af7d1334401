"""mpirun as the tests need it: more ranks than cores, also as root. Runs its arguments; importable as a module."""
import os
import subprocess
import sys
import time

COMMAND = ["mpirun", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1",
           "--mca", "btl", "self,vader", "--mca", "btl_vader_single_copy_mechanism", "none"]


class Result:
    """What a run left: its exit code, its output (both streams) and its duration [s]."""

    def __init__(self, code, text, seconds):
        self.code, self.text, self.seconds = code, text, seconds

    def __str__(self):
        return f"exit code {self.code} after {self.seconds:.1f} s, output:\n{self.text}"


def environment():
    """Environment in which OpenFOAM's programs find their etc/ and mpirun accepts any user."""
    env = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
               OMPI_MCA_rmaps_base_oversubscribe="1")
    env.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    return env


def run(arguments, cwd=None, timeout=60):
    """Runs mpirun with these arguments; the timeout [s] is a failure that shows the output so far."""
    start = time.time()
    with subprocess.Popen(COMMAND + [str(a) for a in arguments], cwd=cwd, env=environment(), text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        try:
            text, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            process.terminate()
            text, _ = process.communicate()
            raise AssertionError(f"no end after {timeout} s: {' '.join(map(str, arguments))}\n{text}")
    return Result(process.returncode, text, time.time() - start)


if __name__ == "__main__":
    outcome = run(sys.argv[1:])
    print(outcome.text)
    sys.exit(outcome.code)
