"""Checks of RGIMP against references."""

import sys
from pathlib import Path

# The pictures are drawn with rgimp-plot's own functions.
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "engine/python"))
