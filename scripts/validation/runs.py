"""Runs of scenes with settings over them, kept under runs/validate/."""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = ROOT / "runs" / "validate"


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
        """What the run stands for; a folder with another one is stale."""
        return json.dumps([(ROOT / "inputs" / self.scene).read_text(), self.settings])

    def perform(self):
        """Runs it, or goes on with it, unless it is there."""
        stamp = RUNS / "stamps" / f"{self.name.replace('/', '_')}.json"
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
            print(f"{self.name}: {found['particles']} particles, {found['core_seconds']:.1f} core-s", flush=True)
        return self.summary()


def perform(runs):
    """Summaries of all runs by name."""
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        return dict(zip([run.name for run in runs], pool.map(Run.perform, runs)))
