"""How a Slurm job is, for Snakemake's --cluster-status: `slurm_status.py JOBID` prints running, success or failed.

squeue knows a job for some minutes after its end, without Slurm's accounting; a job that it has forgotten is one whose end
was not asked for in time, and then sacct is asked."""
import subprocess
import sys

GOING_ON = {"PENDING", "RUNNING", "CONFIGURING", "COMPLETING", "SUSPENDED", "REQUEUED", "RESIZING", "SIGNALING", "STAGE_OUT",
            "STOPPED"}


def answer(*command: str) -> str:
    """First word that a command prints; empty if it fails."""
    done = subprocess.run(command, capture_output=True, text=True)
    words = done.stdout.split()
    return words[0].rstrip("+") if done.returncode == 0 and words else ""


def main() -> None:
    """Says one of Snakemake's three words. Where nobody answers now, the job counts as going on."""
    job = sys.argv[1].split(";")[0]
    state = (answer("squeue", "--noheader", "--states=all", "--format=%T", f"--jobs={job}")
             or answer("sacct", "--noheader", "--allocations", "--format=State", f"--jobs={job}"))
    print("running" if not state or state in GOING_ON else "success" if state == "COMPLETED" else "failed")


main()
