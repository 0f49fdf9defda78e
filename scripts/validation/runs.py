"""Runs of scenes with settings over them, kept under runs/validate/."""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import threading
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = ROOT / "runs" / "validate"
COSTS = ROOT / "tests" / "validation" / "costs.json"
"""Core-seconds of every run when it was last made; these predict the next time."""


@dataclasses.dataclass
class Run:
    """A scene of inputs/ and what is set over it."""

    name: str
    scene: str
    settings: list = dataclasses.field(default_factory=list)

    @property
    def folder(self):
        return RUNS / self.name

    def summary(self):
        return json.loads((self.folder / "summary.json").read_text())

    def stamp(self):
        """What the run stands for, comments apart; a folder with another one is stale."""
        return json.dumps([tomllib.loads((ROOT / "inputs" / self.scene).read_text()), self.settings])

    def stamped(self):
        return RUNS / "stamps" / f"{self.name.replace('/', '_')}.json"

    def is_there(self):
        stamp = self.stamped()
        return stamp.exists() and stamp.read_text() == self.stamp() and (self.folder / "summary.json").exists()

    def perform(self):
        """Runs it, or goes on with it, unless it is there."""
        stamp = self.stamped()
        if not (stamp.exists() and stamp.read_text() == self.stamp()):
            shutil.rmtree(self.folder, ignore_errors=True)
        if not (self.folder / "summary.json").exists():
            stamp.parent.mkdir(parents=True, exist_ok=True)
            stamp.write_text(self.stamp())
            command = [os.environ["SPH_MPI_BIN"], str(ROOT / "inputs" / self.scene), "--threads", "1", "--quiet"]
            command += ["--out", str(self.folder)]
            for setting in self.settings:
                command += ["--set", setting]
            if (self.folder / "checkpoint.h5").exists():
                command.append("--resume")
            else:
                shutil.rmtree(self.folder, ignore_errors=True)
            subprocess.run(command, check=True, cwd=ROOT)
            found = self.summary()
            remember(self.name, found["core_seconds"])
            print(f"{self.name}: {found['particles']} particles, {found['core_seconds']:.1f} core-s", flush=True)
        return self.summary()


def costs():
    return json.loads(COSTS.read_text()) if COSTS.exists() else {}


LOCK = threading.Lock()


def remember(name, core_seconds):
    with LOCK:
        COSTS.write_text(json.dumps(dict(sorted((costs() | {name: round(core_seconds, 1)}).items())), indent=1) + "\n")


def show(runs, guess=lambda run: None):
    """What is there, and what the rest will cost: as the last time, or by `guess`. The sum of the latter, core-seconds."""
    known, missing, unknown = costs(), 0.0, 0
    for run in runs:
        cost = known.get(run.name, guess(run))
        if run.is_there():
            state = "there"
        elif cost is None:
            state, unknown = "never measured", unknown + 1
        else:
            state, missing = f"{cost:.0f} core-s", missing + cost
        print(f"{run.name:52} {state}")
    print(f"missing: {missing:.0f} core-s" + (f" and {unknown} runs of unknown cost" if unknown else ""))


def perform(runs):
    """Summaries of all runs by name."""
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        return dict(zip([run.name for run in runs], pool.map(Run.perform, runs)))
