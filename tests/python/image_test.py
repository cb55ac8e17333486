"""Pictures as arrays are those of `pupflow render`."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from matplotlib.image import imread

import pupflow
from program import pupflow as program, python


class Image(unittest.TestCase):
    def rendered(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.png"
            program("render", "cold", "--at", "30", "--size", "320x240", "--quiet", "--out", str(path), *options)
            return np.round(255 * imread(path)[:, :, :3]).astype(np.uint8)

    def setUp(self):
        self.litter = pupflow.Litter("cold")
        self.litter.step(30)

    def test_is_what_render_draws(self):
        image = self.litter.image(320, 240)
        self.assertEqual((image.shape, image.dtype), ((240, 320, 3), np.uint8))
        np.testing.assert_array_equal(image, self.rendered())
        other = self.litter.image(320, 240, color_by="exposed", colormap="cividis", scale=(0.5, 1),
                                  camera="top", bar=False)
        np.testing.assert_array_equal(other, self.rendered(
            "--color-by", "exposed", "--colormap", "cividis", "--scale", "0.5,1", "--camera", "top", "--no-bar"))
        self.assertFalse(np.array_equal(image, other))

    def test_only_a_picture_loads_graphics_libraries(self):
        code = """if True:
            import re, pupflow
            def graphics(): return re.findall("pupflow_graphics|libGL|libEGL|libglfw", open("/proc/self/maps").read())
            litter = pupflow.Litter("cold"); litter.step(); litter.observe(); litter.hash
            assert not graphics(), graphics()
            litter.image(64, 64, bar=False)
            assert "pupflow_graphics" in graphics()"""
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_without_the_graphics_module_only_pictures_fail(self):
        package = pathlib.Path(pupflow.__file__).parent
        code = "import pupflow; litter = pupflow.Litter('cold'); litter.step(); litter.image(64, 64, bar=False)"
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(package, pathlib.Path(folder) / "pupflow")
            child = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": folder},
                                   capture_output=True, text=True)
        self.assertRegex(child.stderr, "RuntimeError: no graphics: the module is neither .*libpupflow_graphics.so nor "
                         ".*apt install")

    def test_a_forked_process_draws_only_where_its_parent_has_not(self):
        code = """if True:
            import os, signal, sys, pupflow
            litter = pupflow.Litter("cold")
            {first}
            child = os.fork()
            if child == 0:
                signal.alarm(20)
                try:
                    litter.image(64, 64, bar=False)
                except RuntimeError as error:
                    print(error)
                sys.exit()
            sys.exit(os.waitpid(child, 0)[1])"""
        child = python(code.format(first="litter.image(64, 64, bar=False)"))
        self.assertEqual((child.returncode, child.stderr), (0, ""))
        self.assertRegex(child.stdout, "^a forked process cannot draw where its parent has drawn; start it with "
                         "multiprocessing's 'spawn'$")
        child = python(code.format(first=""))
        self.assertEqual((child.returncode, child.stdout, child.stderr), (0, "", ""))

    def test_changes_no_bit(self):
        other = self.litter.copy()
        self.litter.image(64, 64, bar=False)
        self.litter.step(5), other.step(5)
        self.assertEqual(self.litter.hash, other.hash)

    def test_wrong_looks_are_refused(self):
        for words, look in {"color_by: unknown field 'tbb'; did you mean 'tb'": {"color_by": "tbb"},
                            "did not record strain": {"color_by": "strain"},
                            "camera": {"camera": "sideways"},
                            "scale": {"scale": (1, 0)},
                            "map": {"colormap": "rainbow"},
                            "sides": {"width": 1}}.items():
            with self.assertRaisesRegex((ValueError, RuntimeError), words):
                self.litter.image(**look)
