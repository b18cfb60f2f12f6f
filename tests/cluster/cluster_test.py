#!/usr/bin/python3
"""cluster_test.py MDM CHECK SOURCE: the scripts of examples/cluster give what one process gives, whatever is lost on the way.

MDM and CHECK are the programs, SOURCE the top folder of the project. Starts daemons of its own: munged, slurmctld and a
slurmd for each of two nodes, on free ports, and ends them. Exits with 77 where Debian's slurm-wlm, munge or parallel is
missing, unless MDM_REQUIRE_TOOLS is set in the environment.
"""

import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

MDM, CHECK, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SCRIPTS = SOURCE / "examples/cluster"
SHARDS = 8
NODES = ["n1", "n2"]

failures = []


def check(condition, message):
    if not condition:
        failures.append(message)
        print("failed:", message)


def wait_until(condition, what, seconds=300):
    """What the condition gives as soon as it is true."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if result := condition():
            return result
        time.sleep(0.02)
    raise RuntimeError(f"not within {seconds} s: {what}")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def run(*command, code=0):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=600)
    check(result.returncode == code, f"{' '.join(map(str, command))}: exit {result.returncode}: {result.stderr}")
    return result.stdout


def processes(word):
    """The processes whose environment has this word: number and command line."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and word.encode() in (entry / "environ").read_bytes():
                found[int(entry.name)] = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
        except OSError:
            pass  # it has ended, or is another user's
    return found


def kill(pid, number=signal.SIGKILL):
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass


def command_of(pid):
    return pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().decode(errors="replace")


def ancestors(pid):
    """The process's parent, its parent, and so on."""
    while pid > 1:
        pid = int(pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[1])
        yield pid


class Cluster:
    """Two nodes, both this machine."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}
        self.run_munged()
        control, *ports = free_ports(1 + len(NODES))
        user = pwd.getpwuid(os.geteuid()).pw_name
        nodes = "\n".join(f"NodeName={node} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs=1"
                          for node, port in zip(NODES, ports))
        (folder / "state").mkdir()
        for node in NODES:
            (folder / f"spool-{node}").mkdir()
        self.configuration = folder / "slurm.conf"
        self.configuration.write_text(f"""ClusterName=test
SlurmctldHost=localhost
SlurmctldPort={control}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=30
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=15
KillWait=2
SchedulerParameters=sched_interval=1,bf_interval=1
{nodes}
PartitionName=all Nodes={",".join(NODES)} Default=YES MaxTime=5
""")
        os.environ["SLURM_CONF"] = str(self.configuration)
        self.start("slurmctld", "slurmctld", "-D", "-f", self.configuration)
        for node in NODES:
            self.start_node(node)
        wait_until(lambda: all(self.state(node) == "idle" for node in NODES), "two idle nodes")

    def run_munged(self):
        keys = self.folder / "munge"
        keys.mkdir(mode=0o755)
        key = keys / "key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.start("munged", "munged", "--foreground", "--force", f"--key-file={key}", f"--socket={keys}/socket",
                   f"--pid-file={keys}/pid", f"--log-file={keys}/log", f"--seed-file={keys}/seed")
        wait_until((keys / "socket").exists, "munged")

    def start(self, name, *command):
        log = open(self.folder / f"{name}.log", "ab")
        self.daemons[name] = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=log,
                                              stderr=log)

    def start_node(self, node):
        self.start(node, "slurmd", "-N", node, "-D", "-f", self.configuration)

    def lose_node(self, node, task):
        """Ends the node's daemon, the task that it runs, and before it what would tell of its end."""
        self.daemons[node].kill()
        self.daemons[node].wait()
        kill(next(pid for pid in ancestors(task) if command_of(pid).startswith("slurmstepd")))
        kill(task)

    @staticmethod
    def state(node):
        """Such as idle, mixed or down*."""
        return subprocess.run(["sinfo", "-h", "-n", node, "-o", "%t"], capture_output=True, text=True).stdout.strip()

    @staticmethod
    def queue():
        return subprocess.run(["squeue", "-h", "-o", "%i %T"], capture_output=True, text=True).stdout

    def end(self):
        for name in reversed(self.daemons):
            self.daemons[name].terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
        for pid in processes(str(self.configuration)):
            if pid != os.getpid():
                kill(pid)


class Results:
    """A folder of shards."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir()

    def incomplete(self):
        return [int(number) for number in run(SCRIPTS / "incomplete", self.folder, SHARDS).split()]

    def times(self):
        return {path.name: path.stat().st_mtime_ns for path in self.folder.glob("shard-*")}

    def check_merged(self, suite, whole):
        """The merged shards are what one process wrote, and proved."""
        check(self.incomplete() == [], f"{self.folder}: shards are missing")
        check(len(self.times()) == 4 * SHARDS, f"{self.folder}: {sorted(self.times())}")
        answers, proofs = self.folder / "answers.jsonl.zst", self.folder / "all.proofs.zst"
        run(MDM, "merge", *self.folder.glob("shard-*.answers.jsonl.zst"), "-o", answers, "--proofs", proofs)
        for path in (answers, proofs, pathlib.Path(f"{proofs}.index")):
            check(path.read_bytes() == (whole / path.name).read_bytes(), f"{path} is not that of one process")
        run(CHECK, "--suite", suite, proofs, "-j", "2")


def tasks_of(results):
    """The running programs by shard: number of the process."""
    found = {}
    for pid, command in processes("SLURM_ARRAY_TASK_ID=").items():
        if command[0].endswith("mdm") and any(str(results.folder) in word for word in command):
            found[int(command[command.index("--shard") + 1].split("/")[0])] = pid
    return found


def is_stopped(pid):
    """Whether a process that was sent SIGSTOP has stopped, not ended before."""
    def state():
        try:
            return pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return "X"
    return wait_until(lambda: (found := state()) in "TZX" and found, "a process that stops or ends") == "T"


def stopped_task(results, but=()):
    """A shard whose program is in the middle of its work, and stays there; and its process."""
    def find():
        for shard, pid in tasks_of(results).items():
            def is_written():
                return list(results.folder.glob(f"shard-{shard:07}.*.tmp"))
            if shard not in but and is_written():
                kill(pid, signal.SIGSTOP)
                if is_stopped(pid) and is_written():
                    return shard, pid
                kill(pid, signal.SIGCONT)
        return None
    return wait_until(find, "a task")


def node_of(pid):
    environment = pathlib.Path(f"/proc/{pid}/environ").read_bytes().decode(errors="replace").split("\0")
    return next(word.partition("=")[2] for word in environment if word.startswith("SLURMD_NODENAME="))


def test_slurm(folder, suite, whole):
    """A task is requeued, a node is lost, a program is killed: the last alone has to be submitted again."""
    results = Results(folder / "slurm")
    cluster = Cluster(folder)
    try:
        job = run(SCRIPTS / "slurm", suite, results.folder, SHARDS).split()[-1]

        killed, pid = stopped_task(results)
        kill(pid)
        requeued, pid = stopped_task(results, [killed])
        run("scontrol", "requeue", f"{job}_{requeued}")
        lost, pid = stopped_task(results, [killed, requeued])
        node = node_of(pid)
        cluster.lose_node(node, pid)
        wait_until(lambda: cluster.state(node).startswith("down"), "the lost node is down")
        check({lost, killed} <= set(results.incomplete()), "a task that was ended looks complete")
        cluster.start_node(node)

        wait_until(lambda: not cluster.queue(), "the end of the job")
        check(results.incomplete() == [killed], f"incomplete are {results.incomplete()}, not {killed} alone")
        before = results.times()
        run(SCRIPTS / "slurm", suite, results.folder, SHARDS)
        wait_until(lambda: not cluster.queue(), "the end of the second job")
        after = results.times()
        check(all(after[name] == at for name, at in before.items() if f"{killed:07}" not in name),
              "a complete shard was solved again")
        check("complete" in run(SCRIPTS / "slurm", suite, results.folder, SHARDS), "complete shards are submitted")
        results.check_merged(suite, whole)
    finally:
        cluster.end()
        if failures or sys.exc_info()[0]:
            for log in folder.glob("*.log"):
                print(f"--- {log.name}", log.read_text(errors="replace")[-3000:], sep="\n")


def test_hosts(folder, suite, whole):
    """Two names of hosts, of which the one is gone at first; ssh is replaced by a program that runs on this machine.

    Like sshd it gives the commands the environment of a login, whatever that of the test is."""
    results = Results(folder / "hosts")
    hosts = folder / "hosts.txt"
    hosts.write_text("1/one\n1/two\n")
    ssh = folder / "ssh"
    ssh.write_text(f"""#!/bin/sh
host=$1
shift
[ "$1" = -- ] && shift
if [ "$host" = two ] && mkdir {folder}/gone 2>/dev/null; then exit 255; fi
exec env -i SHELL=/bin/sh HOME="$HOME" PATH="$PATH" sh -c "$*"
""")
    ssh.chmod(0o755)
    os.environ["PARALLEL_SSH"] = str(ssh)
    os.environ["PARALLEL_HOME"] = str(folder / "parallel")
    (folder / "parallel").mkdir()
    run(SCRIPTS / "hosts", suite, results.folder, SHARDS, hosts)
    results.check_merged(suite, whole)

    # Commands that succeed without having been run, such as those of an account that may not log in.
    idle = Results(folder / "idle")
    ssh.write_text("#!/bin/sh\nexit 0\n")
    run(SCRIPTS / "hosts", suite, idle.folder, SHARDS, hosts, code=1)
    check(idle.incomplete() == list(range(1, SHARDS + 1)), "shards without a file look complete")


def test_machine(folder, suite, whole):
    results = Results(folder / "machine")
    run(SCRIPTS / "machine", suite, results.folder, SHARDS)
    results.check_merged(suite, whole)
    before = results.times()
    run(SCRIPTS / "machine", suite, results.folder, SHARDS)
    check(results.times() == before, "complete shards were solved again")


def main():
    missing = [tool for tool in ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "sinfo", "parallel")
               if not shutil.which(tool)]
    if missing:
        print("not tested:", *missing, "(Debian: slurm-wlm munge parallel)")
        return 1 if "MDM_REQUIRE_TOOLS" in os.environ else 77
    os.environ["PATH"] = f"{MDM.parent}:{os.environ['PATH']}"
    with tempfile.TemporaryDirectory(prefix="mdm-cluster-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        suite, whole = folder / "suite.jsonl", folder / "whole"
        suite.write_bytes(12 * (SOURCE / "examples/reference/average/suite-2750.jsonl").read_bytes())
        whole.mkdir()
        run(MDM, "batch", suite, "-o", whole / "answers.jsonl.zst", "--proofs", whole / "all.proofs.zst")
        for test in (test_machine, test_hosts, test_slurm):
            begin = time.monotonic()
            test(folder, suite, whole)
            print(f"{test.__name__}: {time.monotonic() - begin:.0f} s")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


os.environ["PATH"] += ":/usr/sbin:/sbin"
sys.exit(main())
