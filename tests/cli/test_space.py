"""The three-dimensional examples, as coarse as their files say a test of them is: run, read by VTK,
their cracks measured and drawn."""

import json
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkIOHDF import vtkHDFReader

from command_test import CommandTest

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
PLOT = ROOT / "engine/python/rgimp-plot"


def coarse_arguments(name):
    """What the example's head gives behind `rgimp run NAME.toml` as its coarsest run."""
    lines = [line.removeprefix("#").strip()
             for line in (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8").splitlines()]
    start = lines.index("Coarse, as the tests run it:") + 1
    command = ""
    for line in lines[start:]:
        command += line.removesuffix("\\")
        if not line.endswith("\\"):
            break
    words = shlex.split(command)
    assert words[:3] == ["rgimp", "run", f"examples/{name}.toml"], words
    return words[3:]


class ExamplesTest(CommandTest):
    timeout = 600  # s; twenty seconds where no one else computes

    def run_coarse(self, name):
        """Gives the summary and the cracks."""
        self.rgimp("run", EXAMPLES / f"{name}.toml", "-o", "out", "--quiet",
                   *coarse_arguments(name))
        text = self.rgimp("cracks", "out", "--json", "cracks.json").stdout
        cracks = json.loads((self.place / "cracks.json").read_text(encoding="utf-8"))
        summary = self.summary("out")
        failed = summary["failed_tension"] + summary["failed_shear"]
        self.assertEqual(cracks["failed"], failed)
        self.assertIn(f"{failed:,} failed: ", text)
        self.assertEqual(cracks["first_failure"]["step"], summary["first_failure"]["step"])
        self.check_with_vtk(summary)
        done = subprocess.run([sys.executable, "-B", PLOT, self.place / "out", "--dpi", "60"],
                              capture_output=True, text=True, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return summary, cracks

    def check_with_vtk(self, summary):
        """ParaView's reader, and its Threshold on `failed`."""
        reader = vtkHDFReader()
        reader.SetFileName(str(self.place / "out" / "snapshots" / self.snapshots("out")[-1]))
        reader.Update()
        grid = reader.GetOutputDataObject(0)
        self.assertEqual(grid.GetNumberOfPoints(), summary["particles"])
        self.assertEqual(grid.GetPointData().GetArray("stress").GetNumberOfComponents(), 6)
        places = vtk_to_numpy(grid.GetPoints().GetData())
        self.assertTrue((numpy.ptp(places, axis=0) > 15e-3).all())
        threshold = vtkThreshold()
        threshold.SetInputConnection(reader.GetOutputPort())
        threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "failed")
        threshold.SetUpperThreshold(1)  # what THRESHOLD_UPPER compares with
        threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
        threshold.Update()
        self.assertEqual(threshold.GetOutput().GetNumberOfPoints(),
                         summary["failed_tension"] + summary["failed_shear"])

    def check_flawed_block(self, name):
        """What fails first does so in tension, at the flaw."""
        summary, cracks = self.run_coarse(name)
        first = summary["first_failure"]
        self.assertEqual(first["mode"], "tension")
        self.assertEqual(cracks["first_failure"]["flaw"], 0)
        self.assertLess(cracks["first_failure"]["distance_m"], 1.6e-3)  # half a cell
        return cracks

    def test_block_through_flaw(self):
        """Sheets as deep as the block leave the flaw, up and down."""
        cracks = self.check_flawed_block("block_through_flaw")["cracks"]
        farthest = [crack["extent"][-1]["farthest_m"][1] for crack in cracks]
        self.assertGreater(max(farthest), 20e-3)
        self.assertLess(min(farthest), -20e-3)
        for crack in cracks:
            end = crack["extent"][-1]
            self.assertGreater(end["max_m"][2] - end["min_m"][2], 45e-3)  # of 50 mm

    def test_block_penny_flaw(self):
        """At this closure the same block with an embedded flaw has only begun to fail: rock around
        it holds the penny."""
        cracks = self.check_flawed_block("block_penny_flaw")
        self.assertEqual(cracks["elsewhere"], 0)
        self.assertLess(cracks["failed"], 500)

    def test_brazilian_cylinder(self):
        """It splits through its middle from platen to platen, in tension, at 2 P / (pi D t) near its
        strength of 1 MPa: in these cells at 1.05 MPa."""
        summary, cracks = self.run_coarse("brazilian_cylinder")
        self.assertEqual(summary["failed_shear"], 0)
        strength = 2 / numpy.pi * summary["peak_axial_stress_Pa"]
        self.assertGreater(strength, 0.9e6)
        self.assertLess(strength, 1.1e6)
        ends = [crack["extent"][-1] for crack in cracks["cracks"]]
        tallest = max(ends, key=lambda end: end["max_m"][1] - end["min_m"][1])
        self.assertGreater(tallest["max_m"][1] - tallest["min_m"][1], 35e-3)  # of 40 mm
        self.assertLess(tallest["min_m"][0], 0.0)
        self.assertGreater(tallest["max_m"][0], 0.0)


if __name__ == "__main__":
    unittest.main()
