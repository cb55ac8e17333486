"""The Python of the pages runs as it stands, page by page from top to bottom."""

import contextlib
import io
import os
import pathlib
import re
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["PUPFLOW_SOURCE_DIR"])


class Docs(unittest.TestCase):
    def test_the_python_of_the_pages_runs(self):
        for page in ("README.md", "docs/python.md"):
            blocks = re.findall(r"^```python\n(.*?)^```", (SOURCE / page).read_text(), re.MULTILINE | re.DOTALL)
            self.assertTrue(blocks, page)
            names = {}
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
                self.addCleanup(os.chdir, os.getcwd())
                os.chdir(folder)
                for block in blocks:
                    exec(compile(block, page, "exec"), names)
                os.chdir("/")
            self.assertTrue(printed.getvalue(), page)
