"""Reading an output directory: case.toml, history.csv, snapshots, summary.json."""

import json
import re
import tomllib
from dataclasses import dataclass, field

import h5py
import numpy as np

HISTORY_COLUMNS = (
    "step", "time_s", "closure_m", "axial_stress_Pa", "reaction_N", "kinetic_energy_J",
    "strain_energy_J", "external_work_J", "damping_work_J", "viscous_work_J",
    "released_energy_J", "failed_tension", "failed_shear")
SNAPSHOT_NAME = re.compile(r"step_(\d{9,})\.vtkhdf")
INTACT, TENSION, SHEAR = 0, 1, 2
USAGE, IO = 2, 4  # exit codes
LONGEST_TITLE = 300  # letters; a picture has room for no more


class OutputError(Exception):
    """Something the user has to know; becomes one line and an exit code."""

    def __init__(self, message, exit_code=IO):
        super().__init__(message)
        self.exit_code = exit_code


@dataclass
class Snapshot:
    """Particles that can be drawn; a run that the physics stopped may have others at its end."""
    step: int
    left_out: int  # particles whose position or stress is not a finite number
    position: np.ndarray  # m, (n, 2) or (n, 3)
    id: np.ndarray  # a particle's is the same in every snapshot
    max_principal_stress: np.ndarray  # Pa
    failed: np.ndarray
    failure_step: np.ndarray  # -1 while intact

    def count(self):
        return len(self.position) + self.left_out


@dataclass
class Result:
    """One output directory; snapshots are read when they are asked for."""
    case: dict
    history: dict  # column -> array
    snapshot_paths: dict  # step -> path, ascending
    summary: dict  # empty while a run has not ended
    read_snapshots: dict = field(default_factory=dict)

    def steps(self):
        return list(self.snapshot_paths)

    def dimension(self):
        return 3 if self.case.get("dimension", 2) == 3 else 2

    def snapshot(self, step):
        if step not in self.snapshot_paths:
            nearest = sorted(sorted(self.steps(), key=lambda other: abs(other - step))[:4])
            raise OutputError(f"no snapshot of step {step}; the nearest are "
                              f"{', '.join(map(str, nearest))}", USAGE)
        if step not in self.read_snapshots:
            self.read_snapshots[step] = read_snapshot(self.snapshot_paths[step], step,
                                                      self.dimension())
        return self.read_snapshots[step]

    def closure(self, step):
        """m, between the rows of the history where it has none of that step."""
        return float(np.interp(step, self.history["step"], self.history["closure_m"]))

    def wanted_steps(self):
        """The snapshots the case lists one by one."""
        return set(map(int, self.case.get("output", {}).get("snapshot_steps", [])))

    def first_failure_step(self):
        """None while nothing failed."""
        if self.summary:
            first = self.summary["first_failure"]
            return int(first["step"]) if first else None
        last = self.snapshot(self.steps()[-1])
        failed = last.failed != INTACT
        return int(last.failure_step[failed].min()) if failed.any() else None

    def title(self):
        title = str(self.case.get("title") or "untitled case")
        return title if len(title) <= LONGEST_TITLE else title[:LONGEST_TITLE] + " ..."

    def local_damping(self):
        return float(self.case.get("damping", {}).get("local", 0.0))


def read(directory):
    """Opens an output directory; everything but the snapshots is read here."""
    if not directory.is_dir():
        raise OutputError(f"no such directory: {directory}", USAGE)
    for name in ("case.toml", "history.csv"):
        if not (directory / name).exists():
            raise OutputError(f"{directory} is not an output directory of `rgimp run`: "
                              f"{name} is missing", USAGE)
        if not (directory / name).is_file():  # a pipe would be waited for
            raise OutputError(f"cannot read {directory / name}: not a regular file")
    case = read_text(directory / "case.toml", tomllib.loads)
    summary_path = directory / "summary.json"
    summary = read_text(summary_path, json.loads) if summary_path.exists() else {}
    history = read_history(directory / "history.csv")
    result = Result(case, history, list_snapshots(directory / "snapshots"), summary)
    for path, value in ((directory / "case.toml", result.local_damping),
                        (directory / "case.toml", result.wanted_steps),
                        (summary_path, result.first_failure_step)):
        try:
            value()
        except (ArithmeticError, AttributeError, KeyError, TypeError, ValueError) as error:
            raise OutputError(f"{path} is damaged: {type(error).__name__} {error}") from None
    return result


def read_text(path, parse):
    try:
        return parse(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise OutputError(f"cannot read {path}: {error.strerror}") from None
    except (ValueError, RecursionError) as error:  # broken UTF-8, TOML or JSON
        raise OutputError(f"{path} is damaged: {error}") from None


def read_history(path):
    lines = read_text(path, str.splitlines)
    header = lines[0].split(",") if lines else []
    missing = [name for name in HISTORY_COLUMNS if name not in header]
    if missing:
        raise OutputError(f"{path}: column {missing[0]} is missing from the header in line 1")
    if len(lines) == 1:
        raise OutputError(f"{path} has no rows")
    rows = []
    for number, line in enumerate(lines[1:], start=2):
        values = line.split(",")
        if len(values) != len(header):
            raise OutputError(f"{path}, line {number}: {len(values)} of {len(header)} columns; "
                              "was the file cut off?")
        try:
            rows.append([float(value) for value in values])
        except ValueError as error:
            raise OutputError(f"{path}, line {number}: {error}") from None
    return dict(zip(header, np.array(rows).T))


def list_snapshots(folder):
    steps = {}
    if folder.is_dir():
        for path in folder.iterdir():
            match = SNAPSHOT_NAME.fullmatch(path.name)
            if match:
                steps[int(match[1])] = path
    if not steps:
        raise OutputError(f"no snapshots (step_*.vtkhdf) in {folder}")
    return dict(sorted(steps.items()))


def read_snapshot(path, step, dimension):
    if not path.is_file():  # a pipe would be waited for
        raise OutputError(f"cannot read {path}: not a regular file")
    try:
        with h5py.File(path) as file:
            position = read_numbers(file, "VTKHDF/Points").astype(float)
            data = {name: read_numbers(file, f"VTKHDF/PointData/{name}")
                    for name in ("id", "max_principal_stress", "failed", "failure_step")}
    except KeyError as error:
        raise OutputError(f"{path} is not a snapshot: {error.args[0]}") from None
    except (OSError, RuntimeError, TypeError, ValueError, AttributeError) as error:
        raise OutputError(f"cannot read {path}: {error}") from None
    if position.ndim != 2 or position.shape[1] != 3 or len(position) == 0:
        raise OutputError(f"{path}: Points has shape {position.shape}, expected (n, 3), n > 0")
    for name, column in data.items():
        if column.shape != (len(position),):
            raise OutputError(f"{path}: {name} has shape {column.shape}, "
                              f"expected ({len(position)},)")
    drawable = np.isfinite(position).all(axis=1) & np.isfinite(data["max_principal_stress"])
    return Snapshot(step, int(np.count_nonzero(~drawable)), position[drawable, :dimension],
                    **{name: column[drawable] for name, column in data.items()})


def read_numbers(file, name):
    """A dataset as rgimp writes it. Links and outside storage lead to other files, filters load
    plug-ins, and what is stored in chunks may grow beyond all memory."""
    place = file
    for part in name.split("/"):
        if not isinstance(place.get(part, getlink=True), h5py.HardLink):
            raise KeyError(f"{name} is missing, or a link")
        place = place[part]
    if not isinstance(place, h5py.Dataset) or place.dtype.kind not in "iuf":
        raise TypeError(f"{name} does not hold numbers")
    if place.chunks or place.external or place.is_virtual or \
            place.id.get_storage_size() != place.size * place.dtype.itemsize:
        raise TypeError(f"{name} is not stored as plain numbers in one piece")
    return place[()]


def printable(text):
    """Without what a terminal would obey: cases and files may hold anything."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode()
                   for c in str(text))


def save_picture(figure, path, dpi):
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path, dpi=dpi, metadata={"Software": "rgimp-plot"})
    except OSError as error:
        raise OutputError(f"cannot write {path}: {error.strerror or error}") from None
