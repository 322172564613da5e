"""Opens the snapshots of a run, and its grids if there are any, in ParaView itself:
pvbatch open_in_paraview.py DIRECTORY PICTURE

What engine/docs/data.md tells people to do: the series with its times, the arrays, colours, the cracks
alone, and slices and the rock of the grids.
"""

import sys
from pathlib import Path

from paraview import simple

directory, picture = Path(sys.argv[1]), sys.argv[2]


def opened(path):
    """The files of a series and their times."""
    series = simple.OpenDataFile(str(path))
    assert series is not None, f"ParaView has no reader for {path}"
    times = list(series.TimestepValues)
    files = sorted(path.parent.glob("step_*.vtkhdf"))
    assert len(times) == len(files) > 1, (times, files)
    assert times == sorted(times) and times[0] == 0.0 < times[-1], times
    return series, times


def look_at_grids(path, snapshot_times):
    grids, times = opened(path)
    assert times == snapshot_times, (times, snapshot_times)
    simple.UpdatePipeline(time=times[-1], proxy=grids)
    arrays = {array.Name for array in grids.PointData}
    assert arrays == {"mass", "velocity", "stress", "damage"}, arrays
    nodes = grids.GetDataInformation().GetNumberOfPoints()
    middle = simple.Slice(Input=grids, SliceType="Plane")
    middle.SliceType.Normal = [0.0, 1.0, 0.0]
    rock = simple.Threshold(Input=grids, Scalars=["POINTS", "mass"], LowerThreshold=1e-300,
                            UpperThreshold=1e300)
    for part in (middle, rock):
        simple.UpdatePipeline(time=times[-1], proxy=part)
        assert 0 < part.GetDataInformation().GetNumberOfPoints() < nodes
    print(f"{len(times)} grids of {nodes} nodes, {rock.GetDataInformation().GetNumberOfPoints()} in "
          f"the rock, stress {grids.PointData['stress'].GetRange(1)} Pa")


series, times = opened(directory / "snapshots/snapshots.hdf.series")
simple.UpdatePipeline(time=times[-1], proxy=series)
arrays = {array.Name for array in series.PointData}
assert {"stress", "max_principal_stress", "failed", "damage", "failure_step"} <= arrays, arrays
particles = series.GetDataInformation().GetNumberOfPoints()
assert particles > 1000, particles

failed = simple.Threshold(Input=series, Scalars=["POINTS", "failed"], LowerThreshold=1.0,
                          UpperThreshold=2.0)
simple.UpdatePipeline(time=times[-1], proxy=failed)
cracked = failed.GetDataInformation().GetNumberOfPoints()

view = simple.CreateView("RenderView")
shown = simple.Show(series, view)
shown.SetRepresentationType("Point Gaussian")
shown.GaussianRadius = 1.25e-4
simple.ColorBy(shown, ("POINTS", "max_principal_stress"))
view.ViewTime = times[-1]
simple.ResetCamera(view)
simple.SaveScreenshot(picture, view, ImageResolution=[400, 800])
print(f"ParaView {simple.GetParaViewVersion()}: {len(times)} times to {times[-1]:.6g} s, "
      f"{particles} particles, {cracked} of them failed, arrays {sorted(arrays)}")
if (directory / "grid").is_dir():
    look_at_grids(directory / "grid/grid.hdf.series", times)
