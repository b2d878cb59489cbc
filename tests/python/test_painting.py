"""Paintings: what strokes leave, what is recorded, and the bits of the command line."""

import json
import unittest

import numpy as np

import pastoso
from command_line import InFolder


def line(y_mm, *, seconds=0.3, count=16, pressure=0.5):
    """Samples of a level stroke from 6 to 34 mm."""
    share = np.linspace(0, 1, count)
    return np.stack([share * seconds, 6 + 28 * share, np.full(count, y_mm), np.full(count, pressure)], axis=1)


def painted(threads=2):
    painting = pastoso.Painting(40, 30, 2, "panel", threads=threads)
    painting.use_medium("linseed oil")
    painting.take_brush("Flat bristle 20", size_mm=8, seed=3)
    painting.load([("PB29", 1), ("PW6", 0.5)])
    painting.stroke(line(8))
    painting.clean_brush()
    painting.load("#c03020", fill=0.8)
    painting.stroke(np.hstack([line(20), np.full((16, 3), (10, -5, 30))]))
    painting.tilt(70)
    painting.advance(0.5)
    return painting


class Strokes(InFolder):
    def test_leave_paint_where_they_went(self):
        painting = pastoso.Painting(40, 30, 2, "panel")
        self.assertEqual(painting.shape, (60, 80))
        self.assertFalse(painting.thickness.any())
        painting.take_brush("Flat bristle 20", size_mm=8)
        painting.load("PB29")
        painting.stroke(np.hstack([line(15), np.full((16, 3), (0, 0, 90))]))
        thickness = painting.thickness
        rows = np.flatnonzero(thickness.any(axis=1))
        # A brush of 8 mm that stands across its way, along 15 mm, on 2 cells a millimetre.
        self.assertLess(abs(rows.mean() / 2 - 15), 1)
        self.assertLess(abs((rows[-1] - rows[0] + 1) / 2 - 8), 3)
        self.assertFalse(thickness[:, :8].any() or thickness[:, 74:].any())
        account = painting.account()
        volume = thickness.astype(np.float64).sum() * painting.cell_mm**2
        self.assertAlmostEqual(volume, account["canvas_mm3"], delta=1e-6 * volume)
        self.assertLess(account["volume_error_rel"], 1e-9)
        self.assertAlmostEqual(account["taken_mm3"], account["canvas_mm3"] + account["brush_mm3"] + account["ledger_mm3"],
                               delta=1e-6 * account["taken_mm3"])

    def test_take_paint_time_unless_told_not_to(self):
        painting = pastoso.Painting(40, 30, 2)
        painting.take_brush("flat", size_mm=8)
        painting.load("PB29")
        painting.stroke(line(8, seconds=0.5), flow=False)
        self.assertEqual(painting.tick, 0)
        painting.stroke(line(20, seconds=0.5))
        self.assertEqual(painting.tick, 30)
        self.assertEqual(painting.time_s, 0.5)
        painting.advance(0.25)
        self.assertEqual(painting.tick, 45)

    def test_on_the_mixing_well_stay_there(self):
        painting = pastoso.Painting(40, 30, 2)
        painting.squeeze("PR108", 200, 40, 40)
        well = painting.read("thickness", well=True)
        self.assertEqual(well.shape, (270, 360))
        self.assertAlmostEqual(well.astype(np.float64).sum() / 9, 200, delta=0.01)
        painting.take_brush("knife")
        painting.stroke([[0, 30, 40, 0.5], [0.4, 60, 40, 0.5]], surface="well")
        self.assertFalse(painting.thickness.any())
        self.assertTrue((painting.read("thickness", well=True) != well).any())
        self.assertEqual(painting.render(well=True).shape, (270, 360, 3))

    def test_any_numbers_will_do(self):
        given = line(10)
        hashes = set()
        wide = np.zeros((len(given), 8))
        wide[:, ::2] = given
        for samples in (given, given.tolist(), given.copy(order="F"), wide[:, ::2]):
            painting = pastoso.Painting(40, 30, 1, threads=1)
            painting.take_brush("flat", size_mm=8)
            painting.load("PB29")
            painting.stroke(samples)
            hashes.add(painting.state_hash)
        self.assertEqual(len(hashes), 1)

    def test_refused_ones_leave_all_as_it_was(self):
        painting = painted()
        before, recording = painting.state_hash, painting.recording()
        samples = line(10)
        samples[7, 3] = 1.5
        self.assertEqual(self.input_error(lambda: painting.stroke(samples)),
                         "sample 7: the pressure of the pen is 1.5, but must lie between 0 and 1.")
        samples[7, 3] = np.nan
        self.assertIn("sample 7: the pressure of the pen is nan", self.input_error(lambda: painting.stroke(samples)))
        samples = line(10)
        samples[5, 0] = 0
        self.assertIn("sample 5: ", self.input_error(lambda: painting.stroke(samples)))
        self.assertIn("(16, 3)", self.input_error(lambda: painting.stroke(line(10)[:, :3])))
        self.assertEqual((painting.state_hash, painting.recording()), (before, recording))


class Same(InFolder):
    def test_bits_on_any_number_of_threads(self):
        self.assertEqual(painted(1).state_hash, painted(2).state_hash)

    def test_bits_as_the_command_line(self):
        painting = painted()
        strokes, picture = self.folder / "strokes.json", self.folder / "cli.png"
        painting.save(strokes)
        stats = self.figures("replay", strokes, "-o", picture, "--save", self.folder / "cli.pastoso")
        self.assertEqual(stats["state_hash"], f"{painting.state_hash:016x}")
        painting.save(self.folder / "python.png")
        self.assertEqual((self.folder / "python.png").read_bytes(), picture.read_bytes())
        painting.save(str(self.folder / "python.pastoso"))
        self.assertEqual((self.folder / "python.pastoso").read_bytes(), (self.folder / "cli.pastoso").read_bytes())

    def test_bits_when_replayed(self):
        painting = painted()
        recording = painting.recording()
        self.assertEqual(recording["format"], "pastoso-strokes")
        again = pastoso.Painting.replay(recording)
        self.assertEqual((again.state_hash, again.tick), (painting.state_hash, painting.tick))
        painting.save(self.folder / "strokes.json")
        self.assertEqual(pastoso.Painting.replay(self.folder / "strokes.json").state_hash, painting.state_hash)

    def test_bits_when_saved_and_opened(self):
        painting = painted()
        painting.save(self.folder / "a.pastoso")
        opened = pastoso.Painting.open(self.folder / "a.pastoso")
        self.assertEqual(opened.notes, [])
        self.assertEqual((opened.state_hash, opened.recording()), (painting.state_hash, painting.recording()))
        for both in (painting, opened):
            both.stroke(line(12))
            both.advance(0.2)
        self.assertEqual(opened.state_hash, painting.state_hash)


class Steps(unittest.TestCase):
    def test_are_taken_back_and_done_again(self):
        painting = painted()
        after = painting.state_hash
        self.assertEqual(painting.undo_steps, ["Stroke", "Stroke"])
        painting.undo()
        painting.undo()
        self.assertFalse(painting.thickness.any())
        self.assertEqual((painting.undo_steps, painting.redo_steps), ([], ["Stroke", "Stroke"]))
        painting.redo()
        painting.redo()
        self.assertEqual(painting.state_hash, after)

    def test_are_forgotten_without_memory(self):
        painting = painted()
        before = painting.state_hash
        painting.set_undo_memory(0)
        painting.undo()
        self.assertEqual((painting.undo_steps, painting.state_hash), ([], before))

    def test_of_drying_turn_wet_paint_into_support(self):
        painting = painted()
        wet, ground = painting.thickness, painting.support
        painting.dry_now()
        self.assertFalse(painting.thickness.any())
        # Linseed oil keeps its volume as it dries, told in quanta of 2^-17 mm that are rounded whenever paint moves.
        np.testing.assert_allclose(painting.support - ground, wet, rtol=0, atol=2e-4)
        painting.undo()
        np.testing.assert_array_equal(painting.thickness, wet)


class Layers(InFolder):
    def test_come_and_go_by_number(self):
        painting = painted()
        below = painting.thickness
        number = painting.add_layer("Glaze")
        self.assertEqual([layer["active"] for layer in painting.layers()], [False, True])
        painting.stroke(line(25))
        painting.set_layer(number, visible=False, opacity=0.5)
        self.assertEqual(painting.layers()[1],
                         {"number": number, "name": "Glaze", "visible": False, "locked": False, "bare_locked": False, "clipped": False, "opacity": 0.5,
                          "group": 0, "active": True})
        self.assertIn("Glaze", self.input_error(lambda: painting.stroke(line(26))))
        painting.remove_layer(number)
        np.testing.assert_array_equal(painting.thickness, below)
        self.input_error(lambda: painting.select_layer(number))

    def test_hold_pictures(self):
        painting = pastoso.Painting(40, 30, 2, "panel")
        pixels = np.zeros((30, 40, 3), np.uint8)
        pixels[:, :20] = (200, 40, 30)
        pixels[:, 20:] = (30, 60, 160)
        painting.paint_picture(pixels, "Flag", (0, 0, 40, 30))
        seen = painting.render(lit=False).astype(int)
        # Paint of a colour is that colour: to 4 of 255 on a thin film, away from the edge between the two.
        self.assertLess(abs(seen[30, 20] - (200, 40, 30)).max(), 5)
        self.assertLess(abs(seen[30, 60] - (30, 60, 160)).max(), 5)
        self.input_error(lambda: painting.paint_picture(pixels[:, :, :2], "Flag", (0, 0, 40, 30)))


class Catalogue(unittest.TestCase):
    def test_names_what_can_be_painted_with(self):
        painting = pastoso.Painting(20, 20, 1)
        self.assertEqual(pastoso.brushes()["Flat bristle 20"], 20)
        for medium in pastoso.media():
            painting.use_medium(medium)
        for name in pastoso.supports():
            pastoso.Painting(5, 5, 1, name)
        painting.take_brush("flat", size_mm=4)
        for pigment, entry in pastoso.pigments().items():
            painting.load(pigment)
            self.assertEqual((entry["coefficients_per_mm"].shape, entry["coefficients_per_mm"].dtype), ((2, 6), np.float32))
        for light in pastoso.lights():
            self.assertEqual(painting.render(light=light).shape, (20, 20, 3))

    def test_every_action_of_recordings_can_be_applied(self):
        painting = painted()
        painting.apply({"set_symmetry": {"centre_x_mm": 20, "centre_y_mm": 15, "mirror": True}})
        painting.apply({"select_area": {"outline_mm": [[0, 0], [20, 0], [20, 30]]}})
        painting.apply({"resize_canvas": {"x_mm": 0, "y_mm": 0, "width_mm": 30, "height_mm": 30}})
        self.assertEqual(painting.shape, (60, 60))
        self.assertEqual(len(painting.recording()["events"]), len(json.loads(painting.recording_json())["events"]))


if __name__ == "__main__":
    unittest.main()
