"""What is made once and kept under runs/validate/: runs of scenes, studies, and tables of cargo's tests and benches.

Each kind says what it stands for (`stamp`), by which file it is known to be done (`RESULT`) and how it is made (`make`). What
stands for something else than it did is made anew, and what was interrupted goes on where it was.
"""

import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import threading
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = ROOT / "runs" / "validate"
COSTS = ROOT / "tests" / "validation" / "costs.json"
"""Core-seconds of everything when it was last made; these predict the next time."""


@dataclasses.dataclass
class Kept:
    """Something by its name, in a folder of that name."""

    name: str

    @property
    def folder(self):
        return RUNS / self.name

    def stamp_file(self):
        return RUNS / "stamps" / f"{self.name.replace('/', '_')}.json"

    def is_current(self):
        """Whether the folder, if it is there, stands for what is asked now."""
        stamp = self.stamp_file()
        return stamp.exists() and stamp.read_text() == self.stamp()

    def is_there(self):
        return self.is_current() and (self.folder / self.RESULT).exists()

    def perform(self):
        """Makes it, or goes on with it, unless it is there."""
        if not self.is_current():
            shutil.rmtree(self.folder, ignore_errors=True)
        if not self.is_there():
            self.stamp_file().parent.mkdir(parents=True, exist_ok=True)
            self.stamp_file().write_text(self.stamp())
            self.make()
            remember(self.name, self.core_seconds())
            print(f"{self.name}: {self.core_seconds():.1f} core-s", flush=True)


@dataclasses.dataclass
class Run(Kept):
    """A scene of inputs/ and what is set over it."""

    scene: str
    settings: list = dataclasses.field(default_factory=list)
    ranks: int = 1
    threads: int = 1
    guess: float = None
    """Core-seconds, where it was never made."""

    RESULT = "summary.json"

    def result(self):
        return json.loads((self.folder / self.RESULT).read_text())

    def core_seconds(self):
        return self.result()["core_seconds"]

    def stamp(self):
        """Scene and settings, comments apart."""
        return json.dumps([tomllib.loads((ROOT / "inputs" / self.scene).read_text()), self.settings])

    def make(self):
        resume = ["--resume"] if (self.folder / "checkpoint.h5").exists() else []
        if not resume:
            shutil.rmtree(self.folder, ignore_errors=True)
        settings = [word for setting in self.settings for word in ("--set", setting)]
        sph_mpi(self.ranks, self.threads, [ROOT / "inputs" / self.scene, "--quiet", "--out", self.folder, *settings, *resume])


@dataclasses.dataclass
class Study(Kept):
    """A file of inputs/ with a `[study]`: on RANKS ranks, which change no result."""

    file: str
    guess: float = None

    RESULT = "study.json"

    def result(self):
        return json.loads((self.folder / self.RESULT).read_text())

    def is_there(self):
        """A study of searches writes its table after each of them."""
        return super().is_there() and all((self.point(point["number"]) / "point.json").exists() for point in self.result()["points"])

    def core_seconds(self):
        return sum(point["core_seconds"] or 0.0 for point in self.result()["points"])

    def stamp(self):
        """The study and its scene, comments apart."""
        file = ROOT / "inputs" / self.file
        study = tomllib.loads(file.read_text())
        return json.dumps([study, tomllib.loads((file.parent / study["study"]["scene"]).read_text())])

    def make(self):
        resume = ["--resume"] if self.folder.exists() else []
        sph_mpi(int(os.environ.get("RANKS", "1")), 1, [ROOT / "inputs" / self.file, "--quiet", "--out", self.folder, *resume])

    def point(self, number):
        return self.folder / f"point_{number:03}"

    def points(self):
        """(setting's name, row of the study, summary) of each point that has come to its end."""
        found = self.result()
        names = [setting["name"] for setting in found["settings"]]
        for row in found["points"]:
            summary = self.point(row["number"]) / "summary.json"
            if not row["failed"] and summary.exists():
                yield names[row["setting"]], row, json.loads(summary.read_text())


@dataclasses.dataclass
class Tables(Kept):
    """What a command of cargo prints (output.txt) and leaves; made anew when a file that it depends on has changed."""

    command: list
    sources: list
    """Patterns of files, from the repository's root."""
    variable: str = None
    """Of the environment, which tells the command its folder."""
    guess: float = None

    RESULT = "output.txt"

    def result(self):
        return (self.folder / self.RESULT).read_text()

    def core_seconds(self):
        return float((self.folder / "seconds").read_text())

    def stamp(self):
        files = [path for pattern in self.sources for path in sorted(ROOT.glob(pattern))]
        digest = hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()
        return json.dumps([self.command, digest])

    def make(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        environment = os.environ | ({self.variable: str(self.folder)} if self.variable else {})
        start = time.monotonic()
        done = subprocess.run(self.command, check=True, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True)
        (self.folder / "seconds").write_text(f"{time.monotonic() - start:.1f}")
        (self.folder / self.RESULT).write_text(done.stdout)


def sph_mpi(ranks, threads, arguments):
    launch = ["mpirun", "-n", str(ranks), "--bind-to", "none"] if ranks > 1 else []
    command = [*launch, os.environ["SPH_MPI_BIN"], "--threads", str(threads), *map(str, arguments)]
    subprocess.run(command, check=True, cwd=ROOT)


def costs():
    return json.loads(COSTS.read_text()) if COSTS.exists() else {}


LOCK = threading.Lock()


def remember(name, core_seconds):
    with LOCK:
        COSTS.write_text(json.dumps(dict(sorted((costs() | {name: round(core_seconds, 1)}).items())), indent=1) + "\n")


def expected(run, known=None):
    """Core-seconds that a run takes: as the last time, or by its guess; None where neither is known."""
    return (costs() if known is None else known).get(run.name, run.guess)


def missing(runs):
    """(how many are not there, core-seconds that they take, how many of them nobody has measured)."""
    known = costs()
    prices = [expected(run, known) for run in runs if not run.is_there()]
    return len(prices), sum(price or 0.0 for price in prices), prices.count(None)


def show(runs):
    """A line for each."""
    known = costs()
    for run in runs:
        price = expected(run, known)
        state = "there" if run.is_there() else "never measured" if price is None else f"{price:.0f} core-s"
        print(f"  {run.name:52} {state}")


def perform(runs):
    """Makes what is not there, JOBS side by side."""
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool:
        list(pool.map(lambda run: run.perform(), runs))
