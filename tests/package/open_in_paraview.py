"""Opens the snapshots of a run in ParaView itself: pvbatch open_in_paraview.py DIRECTORY PICTURE

What engine/docs/data.md tells people to do: the series with its times, the arrays, colours, the cracks
alone.
"""

import sys
from pathlib import Path

from paraview import simple

directory, picture = Path(sys.argv[1]), sys.argv[2]
series = simple.OpenDataFile(str(directory / "snapshots/snapshots.hdf.series"))
assert series is not None, "ParaView has no reader for the series"
times = list(series.TimestepValues)
snapshots = sorted((directory / "snapshots").glob("step_*.vtkhdf"))
assert len(times) == len(snapshots) > 1, (times, snapshots)
assert times == sorted(times) and times[0] == 0.0 < times[-1], times

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
