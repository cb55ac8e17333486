"""Makes the files that the recording example reads, and runs it."""

import os
import pathlib
import runpy
import sys
import tempfile

from program import pupflow

with tempfile.TemporaryDirectory() as folder:
    recording, metrics = (str(pathlib.Path(folder) / name) for name in ("litter.h5", "litter.csv"))
    pupflow("run", "critical", "--steps", "120", "--set", "discard=0", "--record", recording,
            "--record-every", "1", "--csv", metrics, "--quiet")
    sys.argv[1:] = [recording, metrics, "--out", sys.argv[1]]
    example = pathlib.Path(os.environ["PUPFLOW_SOURCE_DIR"]) / "docs/examples/recording.py"
    runpy.run_path(str(example), run_name="__main__")
