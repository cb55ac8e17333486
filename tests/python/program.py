"""The executable, for tests that hold the module against it."""

import os
import subprocess
import sys


def pupflow(*arguments):
    """What the program prints."""
    program = os.environ["PUPFLOW_PROGRAM"]
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def summary(text):
    """The lines of a run's summary by their labels."""
    lines = [line.strip().rsplit("  ", 1) for line in text.splitlines() if "  " in line.strip()]
    return {label.strip(): value.strip() for label, value in lines}


def python(code):
    """A process of Python that runs this code: its exit code and what it prints."""
    return subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, timeout=60)
