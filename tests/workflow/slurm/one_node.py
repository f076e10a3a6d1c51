"""A Slurm cluster of one node, this machine, in a folder of its own: munged, slurmctld, slurmd."""

import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from socket import gethostname

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")
_PATH = f"{os.environ['PATH']}:/usr/sbin"
_PATIENCE = 60  # seconds for the node to come up
# The executor takes all SLURM_ variables out of a job, which finds Slurm at its usual place only.
USUAL = Path("/etc/slurm/slurm.conf")


@dataclass(frozen=True)
class Cluster:
    """A running cluster."""

    folder: Path
    cpus: int

    @property
    def environment(self) -> dict[str, str]:
        """The environment in which the commands of Slurm find it."""
        return {**os.environ, "PATH": _PATH, "SLURM_CONF": str(self.folder / "slurm.conf")}

    def command(self, *words: str) -> str:
        """Run a command of Slurm and return what it prints."""
        run = subprocess.run(
            words, env=self.environment, capture_output=True, text=True, check=True
        )
        return run.stdout

    def jobs(self) -> list[tuple[str, str, str]]:
        """Return number, name and state of the jobs, finished ones too."""
        text = self.command("squeue", "--all", "--states=all", "--noheader", "--format=%i|%j|%T")
        return [tuple(line.split("|")) for line in text.splitlines()]

    def drain(self, drained: bool) -> None:
        """Take the node out of service for new jobs, or back."""
        state = ["State=DRAIN", "Reason=test"] if drained else ["State=RESUME"]
        self.command("scontrol", "update", f"NodeName={gethostname()}", *state)


def hindrance() -> str:
    """Return why no cluster can be started here, or nothing."""
    missing = [name for name in PROGRAMS if shutil.which(name, path=_PATH) is None]
    if missing:
        return f"no {', '.join(missing)} (Debian: slurm-wlm and munge)"
    if os.geteuid() != 0:
        return "slurmd must be started by root"
    return f"there is a {USUAL} already" if os.path.lexists(USUAL) else ""


@contextmanager
def running(folder: Path, cpus: int = 2, memory: int = 4000) -> Iterator[Cluster]:
    """Start a cluster and end it with all that it runs.

    Parameters
    ----------
    folder : Path
        For its configuration, key, state and logs; `USUAL` links there for as long as it runs.
    cpus, memory : int
        What the node offers to jobs; memory in MB.
    """
    cluster = Cluster(folder, cpus)
    for name in ("state", "spool"):
        (folder / name).mkdir()
    folder.chmod(0o755)
    (folder / "slurm.conf").write_text(_configuration(folder, cpus, memory))
    USUAL.parent.mkdir(exist_ok=True)
    USUAL.symlink_to(folder / "slurm.conf")
    key, socket = folder / "munge.key", folder / "munge.socket"
    key.write_bytes(os.urandom(128))
    key.chmod(0o400)
    own = [f"--{name}-file={folder / name}" for name in ("log", "pid", "seed")]
    daemons = [
        ["munged", "--foreground", "--force", f"--key-file={key}", f"--socket={socket}", *own],
        ["slurmctld", "-D"],
        ["slurmd", "-D"],
    ]
    processes = []
    try:
        for daemon in daemons:
            with open(folder / f"{daemon[0]}.out", "w") as out:
                processes.append(
                    subprocess.Popen(daemon, env=cluster.environment, stdout=out, stderr=out)
                )
            time.sleep(1.0)
        _wait(cluster)
        yield cluster
    finally:
        subprocess.run(["scancel", "--user=root"], env=cluster.environment, check=False)
        time.sleep(1.0)
        for process in reversed(processes):
            process.terminate()
            process.wait(30)
        USUAL.unlink()


def _wait(cluster: Cluster) -> None:
    for _ in range(_PATIENCE):
        run = subprocess.run(
            ["sinfo", "--noheader", "--format=%T"],
            env=cluster.environment,
            capture_output=True,
            text=True,
            check=False,
        )
        if run.stdout.strip() == "idle":
            return
        time.sleep(1.0)
    logs = [path.read_text()[-2000:] for path in cluster.folder.glob("*.out")]
    raise RuntimeError(f"the node did not come up: {run.stdout}{run.stderr}\n" + "\n".join(logs))


def _configuration(folder: Path, cpus: int, memory: int) -> str:
    """Return slurm.conf: no accounting, so that finished jobs stay in squeue for as long."""
    host = gethostname()
    settings = {
        "ClusterName": "wrinkles",
        "SlurmctldHost": host,
        "SlurmUser": "root",
        "AuthType": "auth/munge",
        "AuthInfo": f"socket={folder / 'munge.socket'}",
        "CredType": "cred/munge",
        "StateSaveLocation": folder / "state",
        "SlurmdSpoolDir": folder / "spool",
        "SlurmctldPidFile": folder / "slurmctld.pid",
        "SlurmdPidFile": folder / "slurmd.pid",
        "ProctrackType": "proctrack/linuxproc",
        "TaskPlugin": "task/none",
        "JobAcctGatherType": "jobacct_gather/none",
        "SelectType": "select/cons_tres",
        "SelectTypeParameters": "CR_CPU_Memory",
        "ReturnToService": 2,
        "MinJobAge": 86400,
        "KillWait": 5,
        "SchedulerParameters": "sched_min_interval=100000,bf_interval=5",
        "MailProg": "/bin/true",
        "SlurmctldPort": 16817,
        "SlurmdPort": 16818,
    }
    lines = [f"{name}={value}" for name, value in settings.items()]
    lines += [
        f"NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory} State=UNKNOWN",
        f"PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO",
    ]
    return "\n".join(lines) + "\n"
