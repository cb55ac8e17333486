"""Checkpoints, and scenes from files."""

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

    def test_scenes_are_read_from_paths(self):
        scene = self.folder / "mine.toml"
        scene.write_text("ta = 0.15\npups = 3\n")
        self.assertEqual(pupflow.Litter(scene, pups=2).params.ta, 0.15)
        scene.write_text("ta = 0.15\npupps = 3\n")
        with self.assertRaisesRegex(ValueError, r"mine.toml:2:1: unknown key 'pupps'; did you mean 'pups'"):
            pupflow.Litter(str(scene))
