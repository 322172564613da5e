"""rgimp grid: fields on the nodes of the grid, and that they are those of the particles."""

import json
import unittest

import h5py
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

from command_test import CASE, FILE_TROUBLE, STEPS, WRONG_REQUEST, CommandTest

IN_SPACE = CASE.replace("dimension = 2", "dimension = 3").replace(
    "center = [0.0, 0.0]", "center = [0.0, 0.0, 0.0]").replace(
    "size = [5e-3, 10e-3]", "size = [5e-3, 10e-3, 3e-3]")
LAST = f"step_{STEPS:09d}.vtkhdf"
CELL = 0.5e-3  # m


def image(path):
    """What VTK's reader makes of a file: itself and its arrays, (z, y, x, component)."""
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.Update()
    assert not errors, errors
    output = reader.GetOutput()
    shape = output.GetDimensions()[::-1]
    data = output.GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
              for i in range(data.GetNumberOfArrays())}
    return output, {name: values.reshape(*shape, -1) for name, values in arrays.items()}


class GridTest(CommandTest):
    def particles(self):
        with h5py.File(self.place / "block" / "snapshots" / LAST) as file:
            data = file["VTKHDF/PointData"]
            return {"position": file["VTKHDF/Points"][:], "velocity": data["velocity"][:],
                    "stress": data["stress"][:], "damage": data["damage"][:]}

    def check_sums(self, fields, mass):
        """Mass, momentum, its moment, stress and damage, all of equal particles, are theirs."""
        grid, (output, particles) = fields, (self.output, self.particles())
        mean = {name: values.mean(axis=0) for name, values in particles.items()}
        self.assertAlmostEqual(grid["mass"].sum() / mass, 1.0, delta=1e-12)
        weight = grid["mass"] / grid["mass"].sum()
        for name in ("velocity", "stress", "damage"):
            scale = numpy.abs(particles[name]).max()
            there = (weight * grid[name]).sum(axis=(0, 1, 2))
            numpy.testing.assert_allclose(there, mean[name], rtol=0, atol=1e-12 * scale)
        # A linear field is kept, so the centre of mass is too.
        axes = [output.GetOrigin()[a]
                + output.GetSpacing()[a] * numpy.arange(output.GetDimensions()[a])
                for a in range(3)]
        centre = [(weight[..., 0] * axes[0]).sum(), (weight[..., 0] * axes[1][:, None]).sum(),
                  (weight[..., 0] * axes[2][:, None, None]).sum()]
        numpy.testing.assert_allclose(centre[:2], mean["position"][:2], rtol=0, atol=1e-15)
        return centre

    def test_fields_of_a_plane(self):
        self.rgimp("run", self.case, "--quiet")
        said = self.rgimp("grid", "block")
        self.assertEqual(said.stderr, "")
        names = self.snapshots()
        self.assertEqual(said.stdout.split(), [f"block/grid/{name}" for name in names])
        self.output, fields = image(self.place / "block" / "grid" / LAST)
        for name, values in fields.items():
            numpy.testing.assert_array_equal(values[0], values[1], name)
        self.check_sums({name: values[:1] for name, values in fields.items()},
                        2600.0 * 5e-3 * 10e-3)
        self.assertGreater(fields["damage"].max(), 0.5)
        self.assertTrue((fields["stress"][fields["mass"][..., 0] == 0.0] == 0.0).all())
        series = json.loads((self.place / "block/grid/grid.hdf.series").read_text(encoding="utf-8"))
        self.assertEqual([file["name"] for file in series["files"]], names)
        self.assertEqual(series["files"][-1]["time"], float(self.history()[-1]["time_s"]))
        with h5py.File(self.place / "block" / "grid" / LAST) as file:
            self.assertEqual(file["VTKHDF"].attrs["step"], STEPS)
            self.assertEqual(file["VTKHDF"].attrs["time_s"], series["files"][-1]["time"])
            self.assertEqual(file["VTKHDF/PointData/stress"].attrs["units"], b"Pa")

    def test_fields_in_space(self):
        self.case.write_text(IN_SPACE, encoding="utf-8")
        self.rgimp("run", self.case, "--quiet")
        self.rgimp("grid", "block")
        self.output, fields = image(self.place / "block" / "grid" / LAST)
        centre = self.check_sums(fields, 2600.0 * 5e-3 * 10e-3 * 3e-3)
        self.assertAlmostEqual(centre[2], self.particles()["position"][:, 2].mean(), delta=1e-15)

    def test_the_grid_follows_the_platens(self):
        self.rgimp("run", self.case, "--quiet")
        self.rgimp("grid", "block")
        first, _ = image(self.place / "block" / "grid" / "step_000000000.vtkhdf")
        last, _ = image(self.place / "block" / "grid" / LAST)
        closure = float(self.history()[-1]["closure_m"])
        self.assertEqual(first.GetSpacing()[1], CELL)
        self.assertAlmostEqual(last.GetSpacing()[1] / CELL, 1.0 - closure / 10e-3, delta=1e-12)
        self.assertEqual(last.GetSpacing()[0], CELL)

    def test_one_step_joins_the_others(self):
        self.rgimp("run", self.case, "--quiet")
        self.rgimp("grid", "block", "--step", 200)
        self.rgimp("grid", "block", "--step", 30)
        names = ["step_000000030.vtkhdf", "step_000000200.vtkhdf"]
        folder = self.place / "block" / "grid"
        self.assertEqual(sorted(path.name for path in folder.glob("*.vtkhdf")), names)
        series = json.loads((folder / "grid.hdf.series").read_text(encoding="utf-8"))
        self.assertEqual([file["name"] for file in series["files"]], names)

    def test_new_results_leave_no_old_fields(self):
        self.rgimp("run", self.case, "--quiet")
        self.rgimp("grid", "block")
        self.rgimp("run", self.case, "--quiet", "--force")
        self.assertEqual(list((self.place / "block" / "grid").glob("*")), [])

    def test_errors(self):
        self.rgimp("run", self.case, "--quiet")
        self.fail_with(WRONG_REQUEST, "grid", "block", "--step", 31,
                       says=["no snapshot of step 31", "0, 30, 200, 250"])
        self.fail_with(WRONG_REQUEST, "grid", self.place, says=["no output directory"])
        (self.place / "elsewhere").mkdir()
        (self.place / "block" / "grid").symlink_to(self.place / "elsewhere")
        self.fail_with(FILE_TROUBLE, "grid", "block", says=["symbolic link"])
        self.assertEqual(list((self.place / "elsewhere").iterdir()), [])


if __name__ == "__main__":
    unittest.main()
