"""Tea and tanks: volumes that are kept, closed surfaces, and the bits of the command line."""

import json
import unittest

import numpy as np
from PIL import Image

import pastoso
from command_line import InFolder, run

TEA = {"cells": 24, "parcels": 3000, "pour_s": 0.4}
# A pool of 40 mm in a box of 120 x 80 x 80 mm, and a block of milk above it.
TANK = {"cells": [24, 16, 16], "cell_m": 0.005, "liquids": [
    {"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [1, 1, 0.04]}}},
    {"shape": {"block": {"low_m": [0.04, 0.02, 0.05], "high_m": [0.08, 0.06, 0.07]}}, "milk": 1}]}


def is_closed(mesh):
    """Every edge belongs to two triangles that go along it in opposite directions."""
    edges = np.concatenate([mesh.triangles[:, pair] for pair in ((0, 1), (1, 2), (2, 0))]).astype(np.int64)
    there = np.sort(edges[:, 0] << 32 | edges[:, 1])
    back = np.sort(edges[:, 1] << 32 | edges[:, 0])
    return len(mesh.triangles) > 0 and bool((there == back).all())


class Tea(InFolder):
    def test_holds_the_milk_that_was_poured(self):
        tea = pastoso.Tea(TEA)
        self.assertEqual((tea.poured_m3, tea.steps), (0, 0))
        tea.advance(1)
        self.assertEqual(tea.steps, 30)
        self.assertAlmostEqual(tea.time_s, 1)
        # To the rounding of single precision.
        self.assertAlmostEqual(tea.milk_m3() / tea.poured_m3, 1, delta=1e-4)
        self.assertAlmostEqual(tea.poured_m3 / 26e-6, 1, delta=1e-4)
        parcels = tea.parcels()["volume_m3"].astype(np.float64).sum()
        self.assertAlmostEqual(parcels + tea.dissolved.astype(np.float64).sum() * (0.1 / 24) ** 3, tea.milk_m3(),
                               delta=1e-3 * tea.poured_m3)
        self.assertTrue((tea.coldness >= 0).all())

    def test_surface_is_closed_and_as_large_as_its_milk(self):
        tea = pastoso.Tea(TEA)
        tea.advance(1)
        mesh = tea.surface()
        self.assertTrue(is_closed(mesh))
        milk = tea.parcels()["volume_m3"].astype(np.float64).sum()
        # The search for the threshold ends within half a percent; some clouds have no surface of their volume.
        self.assertAlmostEqual(mesh.volume_m3() / milk, 1, delta=0.02)

    def test_cup_encloses_glass_and_tea(self):
        settings = pastoso.Tea(TEA).settings()["cup"]
        cup = pastoso.Tea(TEA).cup()
        self.assertEqual(set(cup), {"glass_air", "tea_glass", "tea_air"})
        level = cup["tea_air"].positions_m[:, 2]
        self.assertLess(np.ptp(level), 1e-6)
        self.assertLess(level[0], settings["level_m"])  # before the milk is in it
        self.assertAlmostEqual(cup["tea_glass"].positions_m[:, 2].min(), settings["floor_m"], places=6)

    def test_bits_are_those_of_the_command_line(self):
        file = self.folder / "tea.json"
        file.write_text(json.dumps({"format": "pastoso-tea", "version": 1, **TEA}))
        stats = self.figures("tea", file, "--seconds", 0.48, "--fps", 25)
        for threads in (1, 2):
            tea = pastoso.Tea(TEA, threads=threads, fps=25)
            tea.advance(0.48)
            self.assertEqual(tea.steps, stats["steps"])
            self.assertEqual(f"{tea.state_hash:016x}", stats["state_hash"])
        self.assertNotEqual(pastoso.Tea(TEA).step_s, tea.step_s)

    def test_pictures_are_those_of_the_command_line(self):
        file = self.folder / "tea.json"
        file.write_text(json.dumps({"format": "pastoso-tea", "version": 1, **TEA}))
        tea = pastoso.Tea(TEA, fps=5)
        tea.advance(0.4)
        for milk in ("medium", "surface"):
            pictures = self.folder / milk
            result = run("tea", file, "--seconds", 0.4, "--fps", 5, "--every", 2, "--frames", pictures, "--size", "24x20",
                         "--samples", 2, "--milk", milk, "-q")
            self.assertEqual(result.returncode, 0, result.stderr)
            picture = tea.render(24, 20, samples=2, milk=milk)
            self.assertEqual((picture.shape, picture.dtype), ((20, 24, 3), np.uint8))
            np.testing.assert_array_equal(picture, np.asarray(Image.open(pictures / "milk_0002.png")))
        self.assertTrue((tea.render(24, 20, samples=2) != picture).any())

    def test_radiance_is_linear_and_may_keep_its_noise(self):
        tea = pastoso.Tea(TEA)
        tea.advance(0.4)
        even, noisy = (tea.render(24, 20, samples=2, dtype="float32", denoise=denoise) for denoise in (True, False))
        self.assertEqual((even.shape, even.dtype), ((20, 24, 3), np.float32))
        self.assertTrue((noisy >= 0).all())
        # Noise is what neighbours differ by.
        self.assertLess(np.abs(np.diff(even, axis=1)).mean(), np.abs(np.diff(noisy, axis=1)).mean())

    def test_pictures_that_there_are_not(self):
        tea = pastoso.Tea(TEA)
        self.assertIn("width of the picture", self.input_error(lambda: tea.render(0, 20)))
        self.assertIn("number of samples", self.input_error(lambda: tea.render(24, 20, samples=0)))
        self.assertIn('"int8"', self.input_error(lambda: tea.render(24, 20, dtype="int8")))
        self.assertIn('"cloud"', self.input_error(lambda: tea.render(24, 20, milk="cloud")))

    def test_is_poured_into_by_hand(self):
        tea = pastoso.Tea({**TEA, "milk_m3": 1e-6})
        tea.advance(1)
        before = tea.poured_m3
        tea.pour_by_hand((0.05, 0.05))
        tea.advance(0.5)
        self.assertGreater(tea.poured_m3, before)
        tea.pour_by_hand(None)


class Tank(InFolder):
    def test_keeps_its_volume(self):
        tank = pastoso.Tank(TANK)
        before = 0.12 * 0.08 * 0.04 + 0.04 * 0.04 * 0.02
        self.assertAlmostEqual(tank.volume_m3() / before, 1, delta=1e-3)
        tank.advance(0.1)
        self.assertAlmostEqual(tank.time_s, 0.1)
        # Particles: none is lost.
        self.assertEqual(len(tank.particles()), len(pastoso.Tank(TANK).particles()))
        self.assertAlmostEqual(tank.volume_m3() / before, 1, delta=0.02)
        self.assertGreater(tank.fastest_m_s, 0.1)

    def test_fields_show_pool_and_milk(self):
        tank = pastoso.Tank(TANK)
        self.assertEqual(tank.milk.shape, (16, 16, 24))
        self.assertEqual(tank.milk[12, 8, 12], 1)
        self.assertEqual(tank.milk[3, 8, 12], 0)
        self.assertEqual(tank.level.shape, (2 * 18, 2 * 18, 2 * 26))
        # Two points a cell, one cell beyond the box: 20 mm below the level of the pool, and 20 mm above the milk.
        self.assertLess(tank.level[10, 18, 26], 0)
        self.assertGreater(tank.level[33, 18, 26], 0)
        self.assertEqual([face.shape for face in tank.read("velocity")], [(16, 16, 25), (16, 17, 24), (17, 16, 24)])
        particles = tank.particles()
        self.assertEqual(set(np.unique(particles["milk"])), {0, 1})
        self.assertFalse(particles["velocity_m_s"].any())

    def test_surface_is_closed_and_as_large_as_its_liquid(self):
        tank = pastoso.Tank(TANK)
        mesh = tank.surface()
        self.assertTrue(is_closed(mesh))
        self.assertAlmostEqual(mesh.volume_m3() / tank.volume_m3(), 1, delta=0.05)

    def test_solids_are_a_closed_mesh(self):
        ball = {"sphere": {"centre_m": [0.06, 0.04, 0.04], "radius_m": 0.02}}
        mesh = pastoso.Tank({**TANK, "solids": [ball]}).solids()
        self.assertTrue(is_closed(mesh))
        self.assertAlmostEqual(mesh.volume_m3() / (4 / 3 * np.pi * 0.02**3), 1, delta=0.02)
        self.assertEqual(len(pastoso.Tank(TANK).solids().triangles), 0)

    def test_bits_are_those_of_the_command_line(self):
        file = self.folder / "tank.json"
        file.write_text(json.dumps({"format": "pastoso-tank", "version": 1, **TANK}))
        stats = self.figures("tank", file, "--seconds", 0.1, "--fps", 30)
        for threads in (1, 2):
            tank = pastoso.Tank(TANK, threads=threads)
            for frame in range(1, 4):
                tank.advance_to(frame / 30)
            self.assertEqual(f"{tank.state_hash:016x}", stats["state_hash"])
        self.assertEqual(tank.steps, stats["steps"])

    def test_pictures_are_those_of_the_command_line(self):
        ball = {"sphere": {"centre_m": [0.06, 0.04, 0.04], "radius_m": 0.02}}
        scene = {**TANK, "solids": [ball]}
        file = self.folder / "tank.json"
        file.write_text(json.dumps({"format": "pastoso-tank", "version": 1, **scene}))
        pictures = self.folder / "pictures"
        result = run("tank", file, "--seconds", 0.1, "--fps", 10, "--frames", pictures, "--size", "24x16", "--samples", 2, "-q")
        self.assertEqual(result.returncode, 0, result.stderr)
        tank = pastoso.Tank(scene)
        tank.advance_to(0.1)
        picture = tank.render(24, 16, samples=2)
        np.testing.assert_array_equal(picture, np.asarray(Image.open(pictures / "liquid_0001.png")))
        radiance = tank.render(24, 16, samples=2, dtype=np.float32)
        self.assertEqual((radiance.shape, radiance.dtype), ((16, 24, 3), np.float32))


if __name__ == "__main__":
    unittest.main()
