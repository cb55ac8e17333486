"""The stubs are those of the tables, and they name all that there is."""

import ast
import os
import pathlib
import subprocess
import sys
import unittest

import pupflow

SOURCE = pathlib.Path(os.environ["PUPFLOW_SOURCE_DIR"])


class Stubs(unittest.TestCase):
    def test_are_those_of_the_script(self):
        made = subprocess.run([sys.executable, SOURCE / "scripts/stubs.py"], check=True, capture_output=True, text=True)
        stubs = (SOURCE / "python/pupflow/__init__.pyi").read_text()
        self.assertEqual(stubs, made.stdout,
                         "scripts/stubs.py > python/pupflow/__init__.pyi writes them anew")

    def test_name_all_that_there_is(self):
        tree = ast.parse((SOURCE / "python/pupflow/__init__.pyi").read_text())
        names = {node.name: node for node in tree.body if hasattr(node, "name")}
        for name in pupflow.__all__:
            self.assertIn(name, names)
        inside = {node.name for node in names["Litter"].body if hasattr(node, "name")}
        public = {name for name in dir(pupflow.Litter) if not name.startswith("_")}
        self.assertEqual(inside - {"__init__"}, public)
