"""Checkpoints, and scenes from files."""

import os
import pathlib
import tempfile
import unittest

import pupflow
from program import pupflow as program, summary


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = self.folder / "x.h5"

    def test_a_loaded_litter_goes_on_alike(self):
        litter = pupflow.Litter("cold", seed=4)
        litter.step(30)
        litter.save(self.path)
        loaded = pupflow.load(str(self.path))
        self.assertEqual(loaded.hash, litter.hash)
        self.assertEqual(loaded.observe()["huddling"], litter.observe()["huddling"])
        with self.assertRaisesRegex(RuntimeError, "did not record t_left"):
            loaded.t_left
        loaded.step(10), litter.step(10)
        self.assertEqual(loaded.hash, litter.hash)
        self.assertEqual(loaded.t_left.tolist(), litter.t_left.tolist())

    def test_the_program_goes_on_from_it_and_back(self):
        litter = pupflow.Litter("cold")
        litter.step(20)
        litter.save(self.path)
        again = self.folder / "y.h5"
        text = program("run", "--from", str(self.path), "--steps", "40", "--checkpoint", str(again))
        litter.step(20)
        self.assertEqual(summary(text)["hash"], litter.hash)
        self.assertEqual(pupflow.load(again).hash, litter.hash)

    def test_nothing_is_replaced_unasked(self):
        litter = pupflow.Litter(pups=1)
        self.path.write_text("precious")
        with self.assertRaisesRegex(FileExistsError, "exists already; use force=True to replace it"):
            litter.save(self.path)
        self.assertEqual(self.path.read_text(), "precious")
        litter.save(self.path, force=True)
        self.assertEqual(pupflow.load(self.path).hash, litter.hash)

    def test_what_cannot_be_read_or_written(self):
        with self.assertRaisesRegex(OSError, "No such file"):
            pupflow.load(self.path)
        with self.assertRaisesRegex(OSError, "there is no folder"):
            pupflow.Litter(pups=1).save(self.folder / "none" / "x.h5")
        self.path.write_text("no HDF5")
        with self.assertRaises(OSError):
            pupflow.load(self.path)

    def test_a_bad_state_is_not_saved(self):
        litter = pupflow.Litter(pups=2, gravity=1e300)
        for use in (lambda: litter.step(1000), lambda: litter.save(self.path)):
            with self.assertRaises(pupflow.BadNumbers):
                use()
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_paths_are_os_errors(self):
        loop = self.folder / "loop"
        loop.symlink_to(loop)
        for path in (loop / "x.h5", self.folder / ("x" * 300)):
            with self.assertRaises(OSError):
                pupflow.Litter(pups=1).save(path)

    def test_paths_need_not_be_utf8(self):
        litter = pupflow.Litter(pups=1)
        path = os.path.join(self.folder, os.fsdecode(b"\xff.h5"))
        with self.assertRaisesRegex(OSError, r"\\xff.h5: .*No such file"):
            pupflow.load(path)
        litter.save(path)
        self.assertEqual(pupflow.load(path).hash, litter.hash)
        self.assertEqual(pupflow.load(os.fsencode(path)).hash, litter.hash)
        with self.assertRaisesRegex(FileExistsError, r"\\xff.h5: exists already"):
            litter.save(path)
        scene = os.path.join(self.folder, os.fsdecode(b"\xff.toml"))
        pathlib.Path(scene).write_text("ta = 0.15\n")
        self.assertEqual(pupflow.Litter(scene).params.ta, 0.15)
        pathlib.Path(scene).write_text("tta = 0.15\n")
        with self.assertRaisesRegex(ValueError, r"\\xff.toml:1:1: unknown key 'tta'"):
            pupflow.Litter(scene)

    def test_paths_with_nul_are_refused(self):
        for use in (pupflow.load, pupflow.Litter(pups=1).save, pupflow.Litter, pupflow.run):
            with self.assertRaisesRegex(ValueError, "^embedded null byte$"):
                use("a\0b")

    def test_scenes_are_read_from_paths(self):
        scene = self.folder / "mine.toml"
        scene.write_text("ta = 0.15\npups = 3\n")
        self.assertEqual(pupflow.Litter(scene, pups=2).params.ta, 0.15)
        scene.write_text("ta = 0.15\npupps = 3\n")
        with self.assertRaisesRegex(ValueError, r"mine.toml:2:1: unknown key 'pupps'; did you mean 'pups'"):
            pupflow.Litter(str(scene))
