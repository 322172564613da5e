"""What the tests of interrupted runs share: a run to interrupt, and comparing its results."""

import json
import re
import signal
import subprocess
import time

from command_test import CASE, COMMAND, DONE, CommandTest

STEPS = 3000
CHECKPOINTS = ("checkpoint_a.rgimp", "checkpoint_b.rgimp")
# What may differ between a run and one that was interrupted: what tells of the process.
OF_THE_PROCESS = ("wall_s", "particle_steps_per_second", "threads")


def hear_signals():
    """In the child: a test that runs in the background or under nohup hands down ignored signals,
    which a run would go on to ignore."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


class ResumeTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.case.write_text(
            CASE.replace("steps = 250", f"steps = {STEPS}")
            .replace("history_every = 100", "history_every = 10\ncheckpoint_every = 25")
            .replace("snapshot_every = 200", "snapshot_every = 300"), encoding="utf-8")

    def results(self, directory):
        """Name and bytes of all that a run leaves, without what tells of the process."""
        directory = self.place / directory
        files = {str(path.relative_to(directory)): path.read_bytes()
                 for path in directory.rglob("*") if path.is_file()}
        summary = json.loads(files.pop("summary.json"))
        files["summary.json"] = {key: value for key, value in summary.items()
                                 if key not in OF_THE_PROCESS}
        files["case.toml"] = re.sub(rb"(?m)^threads = .*$", b"", files["case.toml"])
        for name in CHECKPOINTS:
            files.pop(name, None)
        return files

    def check_same_results(self, directory, reference="whole"):
        ours, theirs = self.results(directory), self.results(reference)
        self.assertEqual(sorted(ours), sorted(theirs))
        for name, content in theirs.items():
            self.assertTrue(ours[name] == content, f"{directory}/{name} differs")

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [COMMAND, "run", str(self.case), "-o", "cut", *map(str, arguments)], cwd=self.place,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **options)

    def resume(self, *arguments, directory="cut", code=DONE):
        return self.rgimp("run", self.case, "-o", directory, "--quiet", "--resume", *arguments,
                          code=code)

    def run_whole(self, *arguments):
        start = time.monotonic()
        self.rgimp("run", self.case, "-o", "whole", "--quiet", *arguments)
        return time.monotonic() - start

    def interrupt_at(self, step, directory="cut"):
        """Leaves a run that has come to `step` or further and was killed."""
        process = self.start("--quiet") if directory == "cut" else None
        history = self.place / directory / "history.csv"
        while process.poll() is None:
            if history.exists() and history.read_bytes().count(b"\n") > step // 10 + 1:
                process.kill()
                process.wait()
                break
        process.stderr.close()
        self.assertEqual(process.returncode, -signal.SIGKILL)
