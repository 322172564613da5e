"""Writes output directories as `rgimp run` does, from arrays."""

import json

import h5py
import numpy as np

HEADER = ("step,time_s,closure_m,axial_stress_Pa,reaction_N,kinetic_energy_J,strain_energy_J,"
          "external_work_J,damping_work_J,viscous_work_J,released_energy_J,failed_tension,"
          "failed_shear")
PITCH = 0.25e-3  # m


def lattice(width=10e-3, height=20e-3):
    """Particles of a block with a hole in the middle, (n, 2)."""
    x = np.arange(-width / 2 + PITCH / 2, width / 2, PITCH)
    y = np.arange(-height / 2 + PITCH / 2, height / 2, PITCH)
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    return points[np.hypot(*points.T) > 2e-3]


BLOCK = (5e-3, 10e-3, 5e-3)  # m


def block(size=BLOCK):
    """Particles of a whole block in space, (n, 3)."""
    axes = [np.arange(-edge / 2 + PITCH / 2, edge / 2, PITCH) for edge in size]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def write_case_in_space(directory, size=BLOCK, bodies=None, flaws="", damping=0.0):
    """A block, or other bodies and flaws, as TOML."""
    directory.mkdir(parents=True, exist_ok=True)
    box = f'[[body]]\nshape = "box"\ncenter = [0.0, 0.0, 0.0]\nsize = {list(size)}\n'
    (directory / "case.toml").write_text(
        f'title = "synthetic block"\ndimension = 3\n[grid]\ncell_size = {2 * PITCH}\n'
        f'{bodies or box}{flaws}[damping]\nlocal = {damping}\n', encoding="utf-8")


def write_case(directory, title="synthetic block", dimension=2, damping=0.0, snapshot_steps=()):
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "case.toml").write_text(
        f'title = "{title}"\ndimension = {dimension}\n[grid]\ncell_size = 0.5e-3\n'
        f'[[body]]\nparticles_per_cell = 2\n[damping]\nlocal = {damping}\n'
        f'[output]\nsnapshot_steps = {list(snapshot_steps)}\n', encoding="utf-8")


def write_history(directory, steps, failed_tension=0, failed_shear=0):
    """A load that rises, then falls; the failures all come with the last row."""
    rows = [HEADER]
    for step in steps:
        closure = 1e-9 * step
        stress = 1.7e10 * closure / 20e-3 * (1 - 0.5 * step / max(steps[-1], 1))
        energy = 0.5 * stress * closure * 10e-3
        failed = (failed_tension, failed_shear) if step == steps[-1] else (0, 0)
        numbers = (1e-8 * step, closure, stress, stress * 10e-3, 0.01 * energy, 0.9 * energy,
                   energy, 0.05 * energy, 0.01 * energy, 0.02 * energy)
        rows.append(",".join([str(step), *(f"{number:.17g}" for number in numbers),
                              *map(str, failed)]))
    (directory / "history.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


def write_snapshot(directory, step, position, failed=None, failure_step=None, stress=None):
    n = len(position)
    failed = np.zeros(n, np.uint8) if failed is None else np.asarray(failed, np.uint8)
    if failure_step is None:
        failure_step = np.where(failed > 0, step, -1)
    stress = np.zeros(n) if stress is None else np.asarray(stress, float)
    tensor = np.zeros((n, 6))
    tensor[:, 0] = stress
    (directory / "snapshots").mkdir(parents=True, exist_ok=True)
    path = directory / "snapshots" / f"step_{step:09d}.vtkhdf"
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root.attrs["Version"] = np.array([1, 0], np.int64)
        root.attrs["Type"] = np.bytes_("UnstructuredGrid")
        root["NumberOfPoints"] = np.array([n], np.int64)
        root["NumberOfCells"] = np.array([n], np.int64)
        root["NumberOfConnectivityIds"] = np.array([n], np.int64)
        root["Points"] = np.column_stack([position, np.zeros((n, 3 - position.shape[1]))])
        root["Connectivity"] = np.arange(n)
        root["Offsets"] = np.arange(n + 1)
        root["Types"] = np.ones(n, np.uint8)
        data = root.create_group("PointData")
        data["id"] = np.arange(n, dtype=np.uint32)
        data["velocity"] = np.zeros((n, 3))
        data["stress"] = tensor
        data["max_principal_stress"] = stress
        data["failed"] = failed
        data["failure_step"] = np.asarray(failure_step, np.int32)
    return path


def write_summary(directory, first_failure=None, **values):
    summary = {"particles": 1, "steps": 1, "version": "0.1.0", "first_failure": first_failure}
    (directory / "summary.json").write_text(json.dumps(summary | values), encoding="utf-8")
