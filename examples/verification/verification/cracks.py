"""What `rgimp cracks` measures, as checks ask for it."""

import json
import subprocess

from .study import StudyError


class Cracks:
    """The cracks of a finished run; wings by name."""

    def __init__(self, study, run):
        path = run.directory.parent / f"{run.directory.name}_cracks.json"
        done = subprocess.run([study.build / "bin/rgimp", "cracks", run.directory, "--json", path],
                              capture_output=True, text=True, check=False)
        if done.returncode:
            raise StudyError(f"rgimp cracks {run.directory} failed: {done.stderr.strip()}")
        found = json.loads(path.read_text(encoding="utf-8"))
        self.failed, self.outline, self.elsewhere = (
            found[key] for key in ("failed", "outline", "elsewhere"))
        self.wings = {wing["name"]: wing for wing in found["wings"] if wing["failed"]}
        self.events = found["events"]

    def tips(self):
        """Tips of slots with a crack, "A, B"; second cracks of a tip are not told apart."""
        return ", ".join(sorted({name[0] for name in self.wings if not name.startswith("flaw")}))

    def second_cracks(self):
        """Those that leave a tip after its first one, by name."""
        return [name for name in self.wings if name[-1].isdigit() and not name.startswith("flaw")]

    def first_step(self, name):
        return self.wings[name]["front"][0]["step"] if name in self.wings else None

    def sides(self, *names):
        """Sides of the bodies that wings reach: "bottom, top"; "none"."""
        return ", ".join(sorted({event["side"] for event in self.events
                                 if event["side"] and event["wing"] in names})) or "none"

    def arrival(self, name, side):
        """Step, or None."""
        return next((event["step"] for event in self.events
                     if event["side"] == side and event["wing"] == name), None)

    def meeting(self, one, other):
        """Step, or None."""
        return next((event["step"] for event in self.events
                     if {event["wing"], event["other_wing"]} == {one, other}), None)

    def step_at_height(self, name, height):
        """The first at which a wing's front is `height` m from the middle, up or down; or None."""
        return next((front["step"] for front in self.wings.get(name, {"front": []})["front"]
                     if abs(front["position_m"][1]) >= height), None)

    def height_at(self, name, step):
        """y (m) of a wing's front at a step; None before it starts."""
        heights = [front["position_m"][1] for front in self.wings[name]["front"]
                   if front["step"] <= step] if name in self.wings else []
        return heights[-1] if heights else None

    def angle_to_load(self, name, span):
        """Degrees, or None where the wing is shorter than `span` (m)."""
        return next((angle["to_load_deg"] for angle in self.wings[name]["angles"]
                     if angle["span_m"] == span), None) if name in self.wings else None
