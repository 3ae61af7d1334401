"""A real Slurm on this machine, with a configuration of its own: munged, slurmctld and slurmd as root, one node with all cores.

    with Slurm(folder) as slurm: subprocess.run(["sbatch", ...], env=slurm.env)
"""
import os
import secrets
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

DAEMONS = ("munged", "slurmctld", "slurmd")
CONF = """ClusterName=frazil
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """Why there can be no Slurm here; empty if there can."""
    programs = [name for name in (*DAEMONS, "sbatch", "squeue", "scancel") if not shutil.which(name)]
    if programs:
        return f"not installed: {', '.join(programs)} (Debian: slurm-wlm munge)"
    return "" if os.geteuid() == 0 else "the daemons need root"


def free_ports(count):
    """Ports that nobody listens on."""
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Slurm:
    """Starts on entry, ends on exit; `env` makes sbatch and its like find it."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.env = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def __enter__(self):
        for name in ("state", "spool", "munge"):
            (self.folder / name).mkdir(parents=True, mode=0o700)
        key = self.folder / "munge/key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        (self.folder / "slurm.conf").write_text(CONF.format(
            folder=self.folder, host=socket.gethostname(), cores=os.cpu_count(), ports=free_ports(2)))
        munge = self.folder / "munge"
        try:
            self.start("munged", "--force", f"--key-file={key}", f"--socket={munge}/socket", f"--log-file={munge}/log",
                       f"--seed-file={munge}/seed", f"--pid-file={self.folder}/munged.pid")
            self.start("slurmctld")
            self.start("slurmd")
            self.wait_until_idle()
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self, *command):
        """A daemon, which goes to the background by itself."""
        subprocess.run(command, env=self.env, check=True, timeout=60)

    def wait_until_idle(self):
        """Until the node takes jobs."""
        limit = time.monotonic() + 60
        while "idle" not in self.ask("sinfo", "--noheader", "--format=%T"):
            if time.monotonic() > limit:
                raise TimeoutError((self.folder / "slurmctld.log").read_text() + (self.folder / "slurmd.log").read_text())
            time.sleep(0.5)

    def ask(self, *command):
        """What a command of Slurm prints."""
        return subprocess.run(command, env=self.env, capture_output=True, text=True, timeout=60).stdout

    def __exit__(self, *_):
        """Cancels what is left and ends the daemons, by the process ids that they wrote."""
        if self.ask("squeue", "--noheader"):
            self.ask("scancel", "--user=root")
            time.sleep(2)
        for daemon in reversed(DAEMONS):
            path = self.folder / f"{daemon}.pid"
            if path.is_file():
                self.end(int(path.read_text()))

    @staticmethod
    def end(pid):
        """Ends a daemon; waits until it is gone."""
        try:
            os.kill(pid, signal.SIGTERM)
            for _ in range(100):
                os.kill(pid, 0)
                if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
                    return
                time.sleep(0.1)
        except (ProcessLookupError, FileNotFoundError):
            return
