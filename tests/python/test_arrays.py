"""Whose memory arrays lie in, how they are laid out, and that they outlive what they came from."""

import gc
import unittest

import numpy as np

import pastoso
from command_line import InFolder


def small_film():
    return pastoso.Film({"size_mm": [10, 6], "cell_mm": 1, "paint": "house paint", "duration_s": 1,
                         "film": [{"kind": "slab", "thickness_mm": 0.5}]})


def small_tea():
    return pastoso.Tea({"cells": 16, "parcels": 500}, threads=1)


class Output(InFolder):
    def test_goes_into_the_array_given(self):
        film = small_film()
        out = np.full((6, 10), -1, np.float32)
        self.assertIs(film.read("thickness", out=out), out)
        self.assertTrue((out == 0.5).all())
        painting = pastoso.Painting(10, 6, 1)
        self.assertIs(painting.read("thickness", out=out), out)
        self.assertFalse(out.any())

    def test_may_lie_anywhere_row_by_row(self):
        whole = np.full((3, 6, 10), -1, np.float32)
        small_film().read("thickness", out=whole[1])
        self.assertTrue((whole[1] == 0.5).all() and (whole[::2] == -1).all())

    def test_that_does_not_fit_is_refused(self):
        film = small_film()
        for wrong, said in ((np.zeros((6, 10)), "float64 (6, 10)"), (np.zeros((10, 6), np.float32), "float32 (10, 6)"),
                            (np.zeros((10, 6), np.float32).T, "not row by row"), ([1.0], "not a NumPy array")):
            self.assertIn(said, self.input_error(lambda: film.read("thickness", out=wrong)))
        locked = np.zeros((6, 10), np.float32)
        locked.flags.writeable = False
        self.assertIn("written", self.input_error(lambda: film.read("thickness", out=locked)))


class Pictures(unittest.TestCase):
    def test_lie_in_the_memory_they_were_rendered_into(self):
        for dtype in ("uint8", np.float32):
            picture = small_film().render(dtype=dtype)
            self.assertFalse(picture.flags.owndata)
            self.assertEqual(type(picture.base).__name__, "PyCapsule")
            self.assertTrue(picture.flags.c_contiguous and picture.flags.writeable)
        film = small_film()
        first, second = film.render(), film.render()
        self.assertFalse(np.shares_memory(first, second))

    def test_outlive_what_they_show(self):
        film = small_film()
        picture, expected = film.render(), film.render().copy()
        del film
        gc.collect()
        np.testing.assert_array_equal(picture, expected)


class Input(InFolder):
    def test_is_read_where_it_lies(self):
        # Half of a larger array: an engine that took the wrong memory or strides would see the other half.
        whole = np.zeros((12, 10), np.float32)
        whole[6:] = 0.25
        film = pastoso.Film({"size_mm": [10, 6], "cell_mm": 1, "paint": "house paint", "duration_s": 1,
                             "film": [{"kind": "array", "thickness_mm": whole[6:]}]})
        self.assertTrue((film.thickness == 0.25).all())
        whole[:] = 3
        self.assertTrue((film.thickness == 0.25).all())

    def test_of_another_shape_is_refused(self):
        given = {"size_mm": [10, 6], "cell_mm": 1, "paint": "house paint", "duration_s": 1,
                 "film": [{"kind": "array", "thickness_mm": np.zeros((10, 6))}]}
        self.assertEqual(self.input_error(lambda: pastoso.Film(given)),
                         'the array "film[0]" is float32 (10, 6), but must be float32 (6, 10), row by row.')


class Liquids(unittest.TestCase):
    def test_fields_are_views_without_what_lies_around_the_box(self):
        tea = small_tea()
        tea.step(3)
        dissolved = tea.dissolved
        self.assertEqual((dissolved.shape, dissolved.dtype), ((16, 16, 16), np.float32))
        self.assertEqual(type(dissolved.base).__name__, "PyCapsule")
        self.assertFalse(dissolved.flags.c_contiguous)
        # Rows of 16 cells, two ghosts on each side and a face, padded to whole cache lines.
        self.assertEqual(dissolved.strides[1:], (32 * 4, 4))
        self.assertEqual([face.shape for face in tea.read("velocity")], [(16, 16, 17), (16, 17, 16), (17, 16, 16)])

    def test_parcels_are_records(self):
        tea = small_tea()
        tea.step(30)
        parcels = tea.parcels()
        self.assertGreater(len(parcels), 0)
        self.assertEqual(parcels.dtype.itemsize, 48)
        self.assertEqual(parcels["position_m"].shape, (len(parcels), 3))
        inside = (parcels["position_m"] > 0) & (parcels["position_m"] < 0.1)
        self.assertTrue(inside.all())
        # What has dissolved in a second is less than a hundredth.
        self.assertTrue((abs(parcels["volume_m3"] / (26e-6 / 500) - 0.995) < 0.0051).all())
        self.assertTrue((parcels["coldness"] <= 1).all() and (parcels["ball"] >= -1).all())

    def test_meshes_lie_in_the_memory_they_were_made_in(self):
        cup = small_tea().cup()["tea_air"]
        for array, dtype in zip(cup, (np.float32, np.float32, np.uint32)):
            self.assertEqual((array.dtype, array.shape[1]), (dtype, 3))
            self.assertEqual(type(array.base).__name__, "PyCapsule")
        gc.collect()
        np.testing.assert_allclose(np.linalg.norm(cup.normals, axis=1), 1, atol=1e-6)


if __name__ == "__main__":
    unittest.main()
