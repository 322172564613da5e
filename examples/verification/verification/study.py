"""Running cases for a check, and reading what they wrote."""

import hashlib
import json
import shutil
import subprocess
import tomllib
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np
from rgimp_plot import output

EXAMPLES = Path(__file__).resolve().parents[2]
REFERENCES = Path(__file__).resolve().parents[1] / "reference"


class StudyError(Exception):
    """A run that failed where it must not; becomes one line."""


class Run:
    """The output directory of a finished run."""

    def __init__(self, directory):
        self.directory = directory

    @cached_property
    def summary(self):
        return json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))

    @cached_property
    def case(self):
        return tomllib.loads((self.directory / "case.toml").read_text(encoding="utf-8"))

    @cached_property
    def history(self):
        """Column name -> array."""
        return output.read_history(self.directory / "history.csv")

    @cached_property
    def result(self):
        """The run as rgimp-plot's functions take it."""
        return output.read(self.directory)

    def steps(self):
        """Of the snapshots, ascending."""
        return list(output.list_snapshots(self.directory / "snapshots"))

    def snapshot(self, step=None):
        """Columns of the particles by name, `position` (m) among them; None: the last."""
        paths = output.list_snapshots(self.directory / "snapshots")
        path = paths[max(paths) if step is None else step]
        with h5py.File(path) as file:
            data = file["VTKHDF/PointData"]
            columns = {name: np.asarray(data[name]) for name in data}
            return {"position": np.asarray(file["VTKHDF/Points"]), **columns}

    def at_closure(self, column, closure):
        """A column of the history at a closure (m), between its rows."""
        return float(np.interp(closure, self.history["closure_m"], self.history[column]))


class Study:
    """What a check works with: runs, programs, places for pictures."""

    def __init__(self, name, build, runs, output_directory, threads):
        self.name = name
        self.build = build
        self.runs = runs
        self.pictures = output_directory / "pictures"
        self.threads = threads
        self.used = []  # summaries of the runs, for the report

    def run(self, name, case, *overrides):
        """Runs a case, a path or TOML text, with --set overrides; one run a name in a check."""
        text = case.read_text(encoding="utf-8") if isinstance(case, Path) else case
        directory = self.runs / self.name / name
        program = self.build / "bin/rgimp"
        stamp = self._stamp(program, text, *overrides)
        stamp_file = directory / "verified.sha256"  # written last: the run is whole
        if not (stamp_file.exists() and stamp_file.read_text(encoding="utf-8") == stamp):
            self._compute(program, directory, text, overrides)
            stamp_file.write_text(stamp, encoding="utf-8")
        run = Run(directory)
        self.used.append(run.summary)
        return run

    def lines(self, program, *arguments):
        """JSON lines that a program of the build prints, one dictionary a line."""
        path = self.build / program
        stamp = self._stamp(path, *map(str, arguments))
        kept = self.runs / self.name / f"{path.name}-{stamp[:16]}.jsonl"
        if not kept.exists():
            print(f"   {path.name} {' '.join(map(str, arguments))}", flush=True)
            done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True,
                                  check=False)
            if done.returncode:
                raise StudyError(f"{path.name} failed: {done.stderr.strip()}")
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(done.stdout, encoding="utf-8")
        return [json.loads(line) for line in kept.read_text(encoding="utf-8").splitlines()]

    def picture(self, suffix=""):
        """Where a picture of this check goes; `suffix` tells several apart."""
        self.pictures.mkdir(parents=True, exist_ok=True)
        return self.pictures / f"{self.name}{'_' + suffix if suffix else ''}.png"

    def _stamp(self, program, *texts):
        if not program.exists():
            raise StudyError(f"{program} is missing; build first, or name the place with --build")
        digest = hashlib.sha256(program.read_bytes())
        for text in texts:
            digest.update(b"\0" + text.encode())
        return digest.hexdigest()

    def _compute(self, program, directory, text, overrides):
        print(f"   run {directory.name}", flush=True)
        done = self._start(program, directory, text, overrides)
        if done.returncode:
            raise StudyError(f"run {directory.name} failed: {done.stderr.strip()}")

    def _start(self, program, directory, text, overrides):
        directory.parent.mkdir(parents=True, exist_ok=True)
        case_file = directory.parent / f"{directory.name}.toml"
        case_file.write_text(text, encoding="utf-8")
        shutil.rmtree(directory, ignore_errors=True)
        command = [program, "run", case_file, "-o", directory, "--quiet", "--threads",
                   str(self.threads)]
        for override in overrides:
            command += ["--set", override]
        return subprocess.run(command, capture_output=True, text=True, check=False)
