"""RGIMP: rock fracture with the generalized interpolation material point method.

The C++ library in Python, with the same names; help(rgimp.Simulation) and so on say units and errors.

    import rgimp

    case = rgimp.read_case("single_flaw.toml", ["flaw[0].angle=30"])
    simulation = rgimp.Simulation(case)
    simulation.run_until(1000)
    print(simulation.history().axial_stress, "Pa")
"""

from . import _rgimp
from ._rgimp import *  # noqa: F403
from ._rgimp import __version__

__all__ = [name for name in vars(_rgimp) if not name.startswith("_")] + ["__version__"]
