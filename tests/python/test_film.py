"""Films: exact answers on small ones, known laws, and the bits of the command line."""

import json
import unittest

import numpy as np

import pastoso
from command_line import InFolder

QUANTUM_MM = 2.0**-25


def scene(**changes):
    return {"size_mm": [16, 12], "cell_mm": 0.5, "edges": "wall", "paint": {"viscosity_m2_s": 0.01},
            "film": [{"kind": "box", "area_mm": [2, 2, 6, 8], "thickness_mm": 0.75, "pigment": "PB29"}],
            "duration_s": 0.2, **changes}


class Fields(unittest.TestCase):
    def test_are_what_the_scene_says(self):
        film = pastoso.Film(scene())
        self.assertEqual(film.shape, (24, 32))
        self.assertEqual(film.cell_mm, 0.5)
        expected = np.zeros((24, 32), np.float32)
        expected[4:16, 4:12] = 0.75
        np.testing.assert_array_equal(film.thickness, expected)
        np.testing.assert_array_equal(film.surface, expected)
        self.assertFalse(film.support.any())
        self.assertFalse(film.velocity.any())
        self.assertEqual(film.velocity.shape, (24, 32, 2))

    def test_pigment_is_thickness_times_coefficients(self):
        pigment = pastoso.Film(scene()).pigment
        self.assertEqual(pigment.shape, (24, 32, 12))
        coefficients = pastoso.pigments()["PB29"]["coefficients_per_mm"].ravel()
        # Half a quantum of what a cell carries.
        np.testing.assert_allclose(pigment[5, 5], 0.75 * coefficients, rtol=0, atol=2.0**-17)
        self.assertFalse(pigment[0, 0].any())

    def test_of_arrays_go_in_as_they_are(self):
        random = np.random.default_rng(1)
        thickness = random.uniform(0, 3, (24, 32)).astype(np.float32)
        height = random.uniform(0, 2, (24, 32)).astype(np.float32)
        film = pastoso.Film(scene(
            film=[{"kind": "array", "thickness_mm": thickness, "pigment": "PR108"}],
            support=["flat", {"kind": "array", "height_mm": height}, {"kind": "ramp", "slope": 0}]))
        np.testing.assert_allclose(film.thickness, thickness, rtol=0, atol=0.5 * QUANTUM_MM + 2.0**-23)
        # Rounded down to the support's quantum.
        np.testing.assert_allclose(film.support, height - 2.0**-21, rtol=0, atol=2.0**-21)

    def test_arrays_add_up_with_forms(self):
        both = [{"kind": "array", "thickness_mm": np.full((24, 32), 0.25)},
                {"kind": "box", "area_mm": [0, 0, 16, 6], "thickness_mm": 0.5}]
        thickness = pastoso.Film(scene(film=both)).thickness
        self.assertTrue((thickness[:12] == 0.75).all() and (thickness[12:] == 0.25).all())

    def test_profile_is_a_row(self):
        film = pastoso.Film(scene()).run()
        profile = film.profile("x", 0.5 * 7.5)
        self.assertEqual((profile.shape, profile.dtype), ((32, 5), np.float64))
        np.testing.assert_allclose(profile[:, 0], 0.25 + 0.5 * np.arange(32))
        np.testing.assert_allclose(profile[:, 2], film.thickness[7], rtol=1e-6)


class Flow(InFolder):
    def test_keeps_the_volume(self):
        film = pastoso.Film(scene(duration_s=1))
        before = film.measures()["volume_mm3"]
        film.run()
        self.assertNotEqual(film.report()["steps"], 0)
        # Sums of whole quanta: exact.
        self.assertEqual(film.measures()["volume_mm3"], before)
        self.assertEqual(before, 0.75 * 4 * 6)
        # Floats have 24 bits.
        self.assertAlmostEqual(film.thickness.astype(np.float64).sum() * 0.25, before, delta=before * 2.0**-24)

    def test_what_runs_off_is_counted(self):
        film = pastoso.Film(scene(edges="open", tilt={"tilt_deg": 90}, duration_s=4,
                                  paint={"viscosity_m2_s": 0.001}))
        film.run()
        measures = film.measures()
        self.assertGreater(measures["runoff_mm3"], 0)
        self.assertAlmostEqual(measures["runoff_mm3"] + measures["volume_mm3"], 18, delta=1e-5)

    def test_falls_as_nusselts_film(self):
        # A level film on an upright board, deep in its steady state: the mean speed is g h^2 / (3 nu).
        film = pastoso.Film(scene(edges="periodic", tilt={"tilt_deg": 90}, duration_s=0.5,
                                  paint={"viscosity_m2_s": 0.01, "slip_cells": 0},
                                  film=[{"kind": "slab", "thickness_mm": 0.5}])).run()
        expected = 9806.65 * 0.5**2 / (3 * 0.01e6)
        np.testing.assert_allclose(film.velocity[..., 1], expected, rtol=2e-3)
        np.testing.assert_allclose(film.velocity[..., 0], 0, atol=1e-6)

    def test_bits_are_those_of_the_command_line(self):
        file = self.folder / "scene.json"
        given = scene(tilt={"tilt_deg": 60}, output={"pictures_at_s": [0.05, 0.2]})
        file.write_text(json.dumps({"format": "pastoso-scene", "version": 1, **given}))
        stats = self.figures("simulate", file, "-o", self.folder / "out")
        for film in (pastoso.Film(given, threads=1), pastoso.Film(given, threads=2), pastoso.Film(file)):
            self.assertEqual(f"{film.run().state_hash:016x}", stats["runs"][0]["state_hash"])

    def test_runs_are_chosen_by_name(self):
        names = pastoso.scene_runs("ridges")
        self.assertGreater(len(names), 1)
        self.assertEqual(pastoso.Film("ridges", run=names[1]).time_s, 0)
        self.assertIn(names[0], self.input_error(lambda: pastoso.Film("ridges")))
        self.assertEqual(pastoso.scene_runs(scene()), [])

    def test_pictures_have_the_size_asked_for(self):
        film = pastoso.Film(scene())
        picture = film.render(scale=2)
        self.assertEqual((picture.shape, picture.dtype), ((48, 64, 3), np.uint8))
        part = film.render(scale=2, cells=(4, 2, 20, 12))
        np.testing.assert_array_equal(part, picture[4:24, 8:40])
        linear = film.render(dtype=np.float32, lit=False)
        self.assertEqual((linear.shape, linear.dtype), ((24, 32, 3), np.float32))
        # Ultramarine: blue above red, and darker than the ground.
        self.assertGreater(linear[8, 8, 2], 4 * linear[8, 8, 0])
        self.assertGreater(linear[0, 0, 0], linear[8, 8, 0])


if __name__ == "__main__":
    unittest.main()
