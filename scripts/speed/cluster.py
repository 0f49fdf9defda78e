"""Under Slurm: how an impact scales on one node, by srun and by mpirun, and how far off --check was."""

import os
import re
import shutil
import subprocess
import sys
import time

from common.page import FOLDER
from common.runs import ROOT
from speed.benches import processor

OUT = ROOT / "runs" / "scaling"
SLURM = "/run/slurm_here/slurm.conf"


def output(*command):
    return subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout


def job(cores, **environment):
    """One job of runs, which says how far it is."""
    log = OUT / "job.log"
    told = len(log.read_text()) if log.exists() else 0
    command = ["sbatch", "--wait", "--quiet", f"--output={log}", "--open-mode=append", f"--ntasks-per-node={cores}", "cluster/scaling.sh", str(OUT), "inputs/impact.toml"]
    process = subprocess.Popen(command, cwd=ROOT, env=os.environ | environment)
    while process.poll() is None:
        time.sleep(1)
        text = log.read_text() if log.exists() else ""
        print(*(line for line in text[told:].splitlines() if " ranks x " in line), sep="\n", end="\n" if text[told:] else "", file=sys.stderr)
        told = len(text)
    if process.returncode:
        sys.exit("error: bench: " + "\n".join(log.read_text().splitlines()[-3:]))


def sweeps():
    """Strong and weak scaling and layouts, into OUT."""
    cores = os.cpu_count()
    os.environ.update(SPH_MPI=os.environ["SPH_MPI_BIN"], CORES=str(cores))
    counts = [2**k for k in range(7) if 2**k <= max(1, 2 * cores)]
    layouts = f"1x1 {cores}x1 1x{cores} {2 * cores}x1"
    job(cores, LAUNCHER="srun", COUNTS=" ".join(map(str, counts)), LAYOUTS=layouts)
    job(cores, LAUNCHER="mpirun", COUNTS="", LAYOUTS=layouts)


def page(load):
    model, cores = processor().rsplit(", ", 1)
    return f"""# Scaling, and what was predicted

{model}, {cores}, under Slurm {output("sinfo", "--version").split()[1]}. The first {os.environ.get("STEPS", "100")} steps of inputs/impact.toml, every
rank and thread on a core of its own but where marked. By `scripts/bench cluster`, with a load of {load} of others at its start:
wall times and waits are reliable only with a load near 0.

{output(sys.executable, "cluster/scaling.py", str(OUT))}
![Speed-up against ranks](scaling.png)
"""


def measure():
    """The page, which is kept unless it was made for a quick look. Takes down the Slurm that it has set up."""
    load = f"{os.getloadavg()[0]:.2f}"
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    os.environ["SLURM_CONF"] = SLURM
    up = subprocess.run(["scontrol", "ping"], capture_output=True).returncode == 0 if shutil.which("scontrol") else False
    if not up:
        output("cluster/slurm_here", "up")
    try:
        sweeps()
        text = re.sub(r"\n{3,}", "\n\n", page(load))
    finally:
        if not up:
            output("cluster/slurm_here", "down")
    if not any(os.environ.get(name) for name in ("STRONG", "WEAK", "STEPS")):
        (FOLDER / "cluster.md").write_text(text)
        shutil.copy(OUT / "scaling.png", FOLDER)
    return text
