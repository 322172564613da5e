"""Commands of the programs around RGIMP."""

import subprocess


def output_of(*command):
    """The command's standard output; what it wrote is in the error where it fails."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{command} exits {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout
