"""What the command says: cracks of a directory, and this machine."""

import json
import os
import platform
import subprocess

SECONDS = 600  # an answer takes seconds


def measure_cracks(command, directory):
    """The answer of `rgimp cracks`, or {"trouble": why there is none}."""
    return ask(command, "cracks", os.path.abspath(directory), "--json", "-")


def describe_machine(command):
    """Of the page's writing, which need not be the run's."""
    return {"processor": processor(), "system": platform.platform(), "python":
            platform.python_version(), "rgimp": ask(command, "info", "--json").get("version")}


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            for line in lines:
                if line.startswith("model name"):
                    return line.split(":", 1)[1].strip()
    except OSError:
        pass  # only a name is lost
    return platform.machine()


def ask(command, *arguments):
    try:
        done = subprocess.run([command, *arguments], capture_output=True, text=True, check=False,
                              timeout=SECONDS)
    except OSError as error:
        return {"trouble": f"cannot run {command}: {error.strerror}"}
    except subprocess.TimeoutExpired:
        return {"trouble": f"{command} gave no answer within {SECONDS} s"}
    if done.returncode != 0:
        return {"trouble": done.stderr.strip() or f"{command} ended with {done.returncode}"}
    return json.loads(done.stdout)
