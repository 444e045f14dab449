#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs examples/cluster for real, each launcher where it is installed, and compares with a run in one part.
usage: cluster.py PROGRAM kubernetes|parallel|slurm      77: not here, with the reason
"""
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time

HERE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples", "cluster")
RUN = ["exhaust", "segment_segment", "--grid", "5", "--decisions"]


def skipped(reason):
    print("skipped:", reason)
    sys.exit(77)


def merged(program, files):
    done = subprocess.run([program, "merge", *files], stdout=subprocess.PIPE, check=True, text=True)
    return json.loads(done.stdout)


def without_launchers():
    named = re.compile("SLURM_|OMPI_|PMI_|PARALLEL_|JOB_COMPLETION|TOUCHSTONE_SHARDS")
    return {key: value for key, value in os.environ.items() if not named.match(key)}


def kubernetes(program, folder):
    try:
        import yaml
    except ImportError:
        skipped("python3-yaml is not installed")
    with open(os.path.join(HERE, "kubernetes.yaml"), encoding="utf-8") as file:
        job = yaml.safe_load(file)
    spec = job["spec"]
    pod = spec["template"]["spec"]
    container, = pod["containers"]
    shards = spec["completions"]
    assert (job["apiVersion"], job["kind"], spec["completionMode"]) == ("batch/v1", "Job", "Indexed")
    assert re.fullmatch("[a-z0-9]([-a-z0-9]*[a-z0-9])?", job["metadata"]["name"])
    assert pod["restartPolicy"] in ("OnFailure", "Never") and 0 < spec["parallelism"] <= shards
    assert {mount["name"] for mount in container["volumeMounts"]} <= {volume["name"] for volume in pod["volumes"]}
    assert container["name"] and container["image"]
    known = {"name", "image", "command", "args", "env", "resources", "volumeMounts"}
    assert set(container) <= known and set(spec) <= {"completionMode", "completions", "parallelism", "backoffLimit",
                                                     "template"}
    for entry in container["env"]:
        assert set(entry) == {"name", "value"} and all(isinstance(text, str) for text in entry.values())
    environment = dict(without_launchers(), **{entry["name"]: entry["value"] for entry in container["env"]})
    assert environment["TOUCHSTONE_SHARDS"] == str(shards)
    # Each pod's command here, on the grid of this test.
    os.symlink(program, os.path.join(folder, "touchstone"))
    environment.update(RESULTS=folder, PATH=folder + ":" + environment["PATH"])
    command = container["command"] + [text.replace("--grid 24", "--grid 5") for text in container["args"]]
    for index in range(shards):
        subprocess.run(command, env=dict(environment, JOB_COMPLETION_INDEX=str(index)), check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [f"{folder}/{index}.json" for index in range(shards)]


def parallel(program, folder):
    tool = shutil.which("parallel")
    if not tool or "GNU" not in subprocess.run([tool, "--version"], capture_output=True, text=True).stdout:
        skipped("GNU parallel is not installed")
    environment = dict(without_launchers(), TOUCHSTONE=program, RESULTS=folder, HOME=folder)
    run = [os.path.join(HERE, "parallel.sh"), "7", *RUN]
    subprocess.run(run, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.remove(f"{folder}/3.json")  # as if it had failed
    log = open(f"{folder}/joblog", encoding="utf-8").read().splitlines(keepends=True)
    with open(f"{folder}/joblog", "w", encoding="utf-8") as file:
        file.writelines(line for line in log if not line.startswith("3\t"))
    subprocess.run(run, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [f"{folder}/{shard}.json" for shard in range(1, 8)]


CONFIGURATION = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldPort={port}
SlurmdPort={other}
JobAcctGatherType=jobacct_gather/none
SchedulerParameters=sched_interval=1,batch_sched_delay=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def slurm(program, folder):
    """A cluster of one node, started here and ended here."""
    tools = {name: shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")
             for name in ("slurmctld", "slurmd", "sbatch", "squeue", "munged")}
    missing = [name for name, path in tools.items() if not path]
    if missing:
        skipped("not installed: " + ", ".join(missing) + " (slurm-wlm, munge)")
    if os.geteuid() != 0:
        skipped("only root starts Slurm's daemons")
    host = socket.gethostname().split(".")[0]
    os.makedirs(f"{folder}/state")
    os.makedirs(f"{folder}/spool")
    port, other = free_ports(2)
    with open(f"{folder}/slurm.conf", "w", encoding="utf-8") as file:
        file.write(CONFIGURATION.format(host=host, folder=folder, cpus=os.cpu_count(), port=port, other=other))
    with open(f"{folder}/key", "wb") as file:
        file.write(os.urandom(1024))
    os.chmod(f"{folder}/key", 0o400)
    environment = dict(without_launchers(), SLURM_CONF=f"{folder}/slurm.conf", TOUCHSTONE=program, RESULTS=folder)
    log = open(f"{folder}/log", "w", encoding="utf-8")
    daemons = []

    def start(*words):
        daemons.append(subprocess.Popen(words, env=environment, stdout=log, stderr=log))

    def output(*words):
        return subprocess.run(words, env=environment, capture_output=True, text=True, cwd=folder)

    try:
        start(tools["munged"], "--foreground", "--force", f"--key-file={folder}/key", f"--socket={folder}/munge.socket",
              f"--pid-file={folder}/munge.pid", f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed")
        while not os.path.exists(f"{folder}/munge.socket") and daemons[0].poll() is None:
            time.sleep(0.1)
        start(tools["slurmctld"], "-D", "-i", "-f", f"{folder}/slurm.conf")
        start(tools["slurmd"], "-D", "-f", f"{folder}/slurm.conf", "-N", host)
        end = time.time() + 55
        while True:
            sent = output(tools["sbatch"], "--array=1-3", "--output=/dev/null", f"{HERE}/touchstone.sbatch", *RUN)
            if sent.returncode == 0:
                break
            if time.time() > end or any(one.poll() is not None for one in daemons):
                print(sent.stderr, open(f"{folder}/log", encoding="utf-8").read()[-3000:], sep="\n")
                skipped("Slurm does not start on this machine")
            time.sleep(0.5)
        files = [f"{folder}/{shard}.json" for shard in (1, 2, 3)]
        while not all(map(os.path.exists, files)) and time.time() < end:
            time.sleep(0.3)
        print(output(tools["squeue"]).stdout)
        return files
    finally:
        for one in reversed(daemons):
            one.terminate()
        for one in daemons:
            one.wait(20)


def main():
    program, launcher = os.path.abspath(sys.argv[1]), sys.argv[2]
    whole = json.loads(subprocess.run([program, *RUN], env=without_launchers(), stdout=subprocess.PIPE, check=True,
                                      text=True).stdout)
    with tempfile.TemporaryDirectory() as folder:
        began = time.time()
        files = {"kubernetes": kubernetes, "parallel": parallel, "slurm": slurm}[launcher](program, folder)
        if merged(program, files) != whole:
            sys.exit(f"{launcher}: the shards do not merge to the run in one part")
        print(f"{launcher}: {len(files)} shards in {time.time() - began:.0f} s are the run in one part")


if __name__ == "__main__":
    main()
