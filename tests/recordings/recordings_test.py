"""Recordings and their exports, read back by the programs that they are for.

Usage: recordings_test.py PROGRAM, with h5py, xarray and numpy installed.
"""
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zipfile

import h5py
import numpy
import xarray

PROGRAM = sys.argv.pop(1)
LITTER = ["--set", "pups=4", "--set", "face_points=4", "--set", "arena_radius=0.7",
          "--set", "ta=0.3", "--seed", "3", "--quiet"]


def pupflow(*arguments):
    subprocess.run([PROGRAM, *arguments], check=True)


class Recordings(unittest.TestCase):
    """A folder with a litter of four pups that touch soon: every field, every step."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = os.path.join(cls.folder.name, "r.h5")
        cls.steps = 300
        pupflow("run", *LITTER, "--steps", str(cls.steps), "--record", cls.path, "--record-every",
                "1", "--record-from", "0", "--record-fields", "pup,afferent,point", "--pups",
                os.path.join(cls.folder.name, "pups.csv"))

    def name(self, name):
        return os.path.join(self.folder.name, name)

    def export(self, *arguments, out):
        pupflow("export", self.path, *arguments, "--out", self.name(out), "--quiet")
        return self.name(out)


class Layout(Recordings):
    def test_xarray_opens_it_by_name(self):
        root = xarray.open_dataset(self.path, engine="h5netcdf")
        self.assertEqual(root.time.dims, ("frame",))
        self.assertEqual(root.step.dims, ("frame",))
        numpy.testing.assert_array_equal(root.step, numpy.arange(self.steps + 1))
        numpy.testing.assert_allclose(root.time, 0.01 * numpy.arange(self.steps + 1), atol=1e-12)
        pup = xarray.open_dataset(self.path, group="pup", engine="h5netcdf")
        for name in ("tb felt_tb exposed heading turn t_left t_right group x y z qx qy qz qw"
                     .split()):
            self.assertEqual(pup[name].dims, ("frame", "pup"), name)
        self.assertEqual(pup.turn.units, "rad/s")
        self.assertIn("Body temperature", pup.tb.description)
        afferent = xarray.open_dataset(self.path, group="afferent", engine="h5netcdf")
        for name, kind in {"temperature": "f4", "touched": "i2", "side": "u1"}.items():
            self.assertEqual(afferent[name].dims, ("frame", "pup", "afferent"), name)
            self.assertEqual(afferent[name].dtype, kind, name)
        point = xarray.open_dataset(self.path, group="point", engine="h5netcdf")
        self.assertEqual(point.position.dims, ("frame", "pup", "point", "axis"))
        skin = xarray.open_dataset(self.path, group="skin", engine="h5netcdf")
        self.assertEqual(skin.sheet.dims, ("sheet_row", "sheet_column"))
        self.assertEqual(skin.direction.dims, ("afferent", "axis"))
        self.assertEqual(skin.neighbours.dims, ("afferent", "neighbour"))

    def test_parameters_are_numbers_and_choices_text(self):
        with h5py.File(self.path) as file:
            self.assertEqual(file.attrs["layout"], 2)
            self.assertEqual(file.attrs["ta"], 0.3)
            self.assertEqual(file.attrs["pups"], 4)
            self.assertEqual(file.attrs["contact"], "nearest")

    def test_chunks_suit_the_stream_of_one_pup(self):
        with h5py.File(self.path) as file:
            for name, chunk in {"pup/tb": (64, 1), "afferent/temperature": (64, 1, 96),
                                "point/position": (64, 1, 96, 3)}.items():
                self.assertEqual(file[name].chunks, chunk)
                self.assertTrue(file[name].shuffle)
                self.assertEqual(file[name].compression, "gzip")

    def test_it_holds_what_the_csv_holds(self):
        with open(self.name("pups.csv")) as csv:
            lines = [line for line in csv if not line.startswith("#")]
        rows = numpy.genfromtxt(lines, delimiter=",", names=True)
        with h5py.File(self.path) as file:
            for name in ("tb", "exposed", "heading"):
                numpy.testing.assert_array_equal(file["pup/" + name][1:].ravel(), rows[name])
            for name in "xyz":
                numpy.testing.assert_allclose(file["pup/" + name][1:].ravel(), rows[name],
                                              rtol=0, atol=1e-13)

    def test_a_map_model_needs_nothing_else(self):
        """Neighbours on the skin are near each other on the sheet, and on the pup."""
        with h5py.File(self.path) as file:
            sheet, direction = file["skin/sheet"][:], file["skin/direction"][:]
            self.assertEqual(sheet.shape, (32, 32))
            self.assertEqual(set(sheet.ravel()), set(range(96)))
            image = file["afferent/temperature"][100, 2][sheet]
            self.assertEqual(image.shape, (32, 32))
            beside = numpy.einsum("ijk,ijk->ij", direction[sheet[:, :-1]], direction[sheet[:, 1:]])
            self.assertGreater(beside.min(), 0.5)
            for afferent, row in enumerate(file["skin/neighbours"][:]):
                for other in row[row >= 0]:
                    self.assertGreater(direction[afferent] @ direction[other], 0.5)
            turn = numpy.moveaxis([file["pup/" + name][50] for name in ("qx", "qy", "qz", "qw")],
                                  0, -1)
            centre = numpy.moveaxis([file["pup/" + name][50] for name in "xyz"], 0, -1)
            points = file["point/position"][50]
        # Where a pup's points are, from its pose, as far as it is not deformed.
        u, w = turn[:, None, :3], turn[:, None, 3:]
        rest = 0.25 * direction[None]
        there = rest + 2 * numpy.cross(u, numpy.cross(u, rest) + w * rest) + centre[:, None]
        self.assertLess(numpy.abs(there - points).max(), 0.12)
        self.assertLess(numpy.sqrt(numpy.mean((there - points) ** 2)), 0.03)


class Rebuilding(Recordings):
    """Heat and steering of every step, from the file and the equations of docs/model.md alone."""

    def test_heat_and_steering_of_every_step(self):
        with h5py.File(self.path) as file:
            p = dict(file.attrs)
            pup = {name: file["pup/" + name][:] for name in file["pup"]}
            touched, side = file["afferent/touched"][:], file["afferent/side"][:]
        steps = slice(1, None)
        felt_tb = pup["felt_tb"][steps]
        numpy.testing.assert_array_equal(felt_tb, pup["tb"][:-1])
        touches = touched[steps] >= 0
        frame = numpy.arange(len(felt_tb))[:, None, None]
        felt = numpy.where(touches, felt_tb[frame, touched[steps]], p["ta"])

        # dT_b/dt = G - k1 A (T_b - T_a) - k2 (1 - A) (T_b - mean T_c), solved over the step
        exposed = 1 - touches.mean(axis=2)
        numpy.testing.assert_allclose(exposed, pup["exposed"][steps], rtol=0, atol=1e-15)
        count = numpy.maximum(touches.sum(axis=2), 1)
        mean = numpy.where(touches, felt, 0).sum(axis=2) / count
        air, skin = p["k1"] * exposed, p["k2"] * (1 - exposed)
        settled = (p["g"] + air * p["ta"] + skin * mean) / (air + skin)
        tb = settled + (felt_tb - settled) * numpy.exp(-(air + skin) * p["dt"])
        numpy.testing.assert_allclose(pup["tb"][steps], tb, rtol=0, atol=1e-14)

        # turn = atan(v (S_L - S_R) / (S_L + S_R)), S = 1 / (1 + exp(-sigma T (T_p - T_b')))
        def sensor(on_side):
            warmth = numpy.where(on_side, felt, 0).sum(axis=2) / on_side.sum(axis=2)
            return 1 / (1 + numpy.exp(-p["sigma"] * warmth * (p["tp"] - felt_tb)))
        left, right = sensor(side[steps] == 1), sensor(side[steps] == 0)
        turn = numpy.arctan(p["v"] * (left - right) / (left + right))
        numpy.testing.assert_allclose(pup["turn"][steps], turn, rtol=0, atol=1e-11)
        apart = pup["heading"][steps] - (pup["heading"][:-1] + p["dt"] * turn)
        apart = numpy.remainder(apart + numpy.pi, 2 * numpy.pi) - numpy.pi
        numpy.testing.assert_allclose(apart, 0, rtol=0, atol=1e-12)
        self.assertGreater(touches.any(axis=2).mean(), 0.25)
        self.assertGreater((numpy.abs(turn) > 0.1).mean(), 0.1)


class Exports(Recordings):
    def test_npy(self):
        with h5py.File(self.path) as file:
            for name, set_name in {"tb": "pup/tb", "touched": "afferent/touched",
                                   "position": "point/position"}.items():
                path = self.export("--format", "npy", "--field", name, out=name + ".npy")
                array = numpy.load(path)
                self.assertEqual(array.dtype, file[set_name].dtype)
                numpy.testing.assert_array_equal(array, file[set_name][:])
            one = numpy.load(self.export("--format", "npy", "--pup", "2", "--sheet", out="s.npy"))
            sheet = file["skin/sheet"][:]
            numpy.testing.assert_array_equal(one, file["afferent/temperature"][:, 2][:, sheet])

    def test_npy_images(self):
        out = self.export("--format", "npy", "--pup", "1", out="image-%05d.npy")
        with h5py.File(self.path) as file:
            sheet = file["skin/sheet"][:]
            for step in (0, 77, self.steps):
                image = numpy.load(out % step)
                self.assertEqual(image.shape, (32, 32, 1))
                expected = file["afferent/temperature"][step, 1][sheet]
                numpy.testing.assert_array_equal(image[:, :, 0], expected)

    def test_timedarray(self):
        path = self.export("--format", "timedarray", "--field", "tb", out="t.npz")
        self.assertIsNone(zipfile.ZipFile(path).testzip())
        data = numpy.load(path)
        with h5py.File(self.path) as file:
            numpy.testing.assert_array_equal(data["values"], file["pup/tb"][:])
        self.assertAlmostEqual(float(data["dt"]), 0.01, places=12)
        self.assertEqual(float(data["start"]), 0)
        self.assertIn(b"ta = 0.3", data["about"].item())
        path = self.export("--format", "timedarray", "--pup", "3", out="a.npz")
        self.assertEqual(numpy.load(path)["values"].shape, (self.steps + 1, 96))
        try:
            import brian2
        except ImportError:
            return
        array = brian2.TimedArray(data["values"], dt=float(data["dt"]) * brian2.second)
        self.assertAlmostEqual(float(array(1.5 * brian2.second, 2)), data["values"][150, 2])

    def test_gcal(self):
        path = self.export("--format", "gcal", "--scale", "0.25,0.75", out="g.h5")
        with h5py.File(self.path) as file:
            sheet = file["skin/sheet"][:]
            patterns = file["afferent/temperature"][:].reshape(-1, 96)[:, sheet]
        with h5py.File(path) as file:
            width, height, count = file["dims"][:]
            self.assertEqual((width, height, count), (32, 32, 4 * (self.steps + 1)))
            self.assertEqual(file["P"].ndim, 1)
            read = file["P"][:]
        self.assertGreaterEqual(read.min(), 0)
        self.assertLessEqual(read.max(), 1)
        expected = numpy.clip((patterns.astype(float) - 0.25) / 0.5, 0, 1)
        numpy.testing.assert_allclose(read.reshape(count, height, width), expected, atol=1e-7)

    def test_vtk(self):
        out = self.export("--format", "vtk", out="p-%05d.vtp")
        with h5py.File(self.path) as file:
            for step in (0, 64, self.steps):
                piece = xml.etree.ElementTree.parse(out % step).getroot().find("PolyData/Piece")
                points = int(piece.get("NumberOfPoints"))
                self.assertEqual(points, 4 * 96)

                def array(place, name):
                    node = piece.find(f"{place}/DataArray[@Name='{name}']")
                    return numpy.array(node.text.split(), float)
                numpy.testing.assert_array_equal(array("Points", "Points"),
                                                 file["point/position"][step].ravel())
                numpy.testing.assert_array_equal(array("PointData", "tb"),
                                                 numpy.repeat(file["pup/tb"][step], 96))
                numpy.testing.assert_array_equal(array("PointData", "touched"),
                                                 file["afferent/touched"][step].ravel())
                numpy.testing.assert_array_equal(array("Verts", "connectivity"),
                                                 numpy.arange(points))


if __name__ == "__main__":
    unittest.main()
