"""What is wrong is told as on the command line, in the same sentence."""

import json
import os
import pickle
import subprocess
import sys
import unittest


import pastoso
from command_line import InFolder

SCENE = {"size_mm": [10, 6], "cell_mm": 1, "paint": "house paint", "duration_s": 1,
         "film": [{"kind": "disc", "at_mm": [5, 3], "radius_mm": -2, "thickness_mm": 0.5}]}


class Sentences(InFolder):
    def test_of_files_are_those_of_the_command_line(self):
        def written(name, content):
            file = self.folder / name
            file.write_text(json.dumps(content))
            return file

        scene = written("scene.json", {"format": "pastoso-scene", "version": 1, **SCENE})
        self.assertEqual(self.input_error(lambda: pastoso.Film(scene)),
                         self.sentence("simulate", scene, "-o", self.folder / "out"))
        strokes = written("strokes.json", {**pastoso.Painting(10, 10, 1).recording(), "end_tick": 1, "events":
                                           [{"tick": 0, "load_paint": {"paint": {"mix": [["PB29", 1]]}}}]})
        self.assertEqual(self.input_error(lambda: pastoso.Painting.replay(strokes)),
                         self.sentence("replay", strokes, "-o", self.folder / "a.png"))
        tea = written("tea.json", {"format": "pastoso-tea", "version": 1, "milk_m3": 2})
        self.assertEqual(self.input_error(lambda: pastoso.Tea(tea)),
                         self.sentence("tea", tea, "--frames", self.folder / "tea"))
        tank = written("tank.json", {"format": "pastoso-tank", "version": 9})
        self.assertEqual(self.input_error(lambda: pastoso.Tank(tank)),
                         self.sentence("tank", tank, "--frames", self.folder / "tank"))
        damaged = self.folder / "damaged.pastoso"
        damaged.write_bytes(b"PK no archive")
        self.assertEqual(self.input_error(lambda: pastoso.Painting.open(damaged)), self.sentence("info", damaged))
        self.assertEqual(self.input_error(lambda: pastoso.Film("no-such-scene")),
                         self.sentence("simulate", "no-such-scene", "-o", self.folder / "out"))

    def test_of_dictionaries_name_the_place(self):
        self.assertEqual(self.input_error(lambda: pastoso.Film(SCENE)),
                         "scene, film[0].radius_mm: -2 is not between 1e-04 and 1e+05.")
        self.assertIn("tank, liquids[0]", self.input_error(lambda: pastoso.Tank({"liquids": [{}]})))
        self.assertIn("tea: milk_m3 is -1", self.input_error(lambda: pastoso.Tea({"milk_m3": -1})))
        self.assertIn("canvas, canvas", self.input_error(lambda: pastoso.Painting(0, 10)))
        self.assertIn("nan", self.input_error(lambda: pastoso.Film({**SCENE, "cell_mm": float("nan")})))
        self.assertIn("object has no place in JSON", self.input_error(lambda: pastoso.Film({**SCENE, "paint": object()})))

    def test_of_actions_name_the_value(self):
        painting = pastoso.Painting(10, 10, 1)
        self.assertIn("action, take_brush", self.input_error(lambda: painting.take_brush("broom")))
        self.assertIn("PB999", self.input_error(lambda: painting.load("PB999")))
        self.assertIn("95", self.input_error(lambda: painting.tilt(95)))
        self.assertIn("\"jump\"", self.input_error(lambda: painting.apply({"undo": {}, "jump": {}})))
        self.assertIn("-1", self.input_error(lambda: painting.advance(-1)))
        self.assertIn("there is no field", self.input_error(lambda: painting.read("depth")))
        self.assertIn("\"zoom\"", self.input_error(lambda: painting.render(zoom=2)))
        self.assertIn("95", self.input_error(lambda: painting.render(elevation_deg=95)))
        self.assertIn("b.gif", self.input_error(lambda: painting.save(self.folder / "b.gif")))
        self.input_error(lambda: painting.stroke([[0, 1, 1, 0.5]]))

    def test_of_times_that_cannot_be(self):
        film = pastoso.Film({**SCENE, "film": []})
        film.advance_to(0.5)
        self.assertEqual(self.input_error(lambda: film.advance_to(0.25)),
                         "the time in s is 0.25, but must lie between 0.5 and 1e+06.")
        self.input_error(lambda: film.advance(float("nan")))
        self.input_error(lambda: pastoso.Film({**SCENE, "film": []}, threads=-1))

    def test_of_broken_invariants_are_told_and_end_the_object(self):
        film = pastoso.Film({**SCENE, "film": []})
        with self.assertRaises(pastoso.InternalError) as caught:
            film._break_invariant()
        sentence = str(caught.exception)
        self.assertIn("broken invariant: work.film().cell_mm < 0.0 (1 against 0)", sentence)
        for work in (lambda: film.advance(0.1), lambda: film.thickness, film.measures, film.render):
            with self.assertRaises(pastoso.InternalError) as caught:
                work()
            self.assertEqual(str(caught.exception), sentence)
        pastoso.Film({**SCENE, "film": []}).advance(0.1)

    def test_of_places_that_cannot_be(self):
        film = pastoso.Film({**SCENE, "film": []})
        self.input_error(lambda: film.profile("x", float("nan")))
        self.input_error(lambda: film.profile("x", 7))
        self.input_error(lambda: film.profile("z", 1))
        for cells in ((0, 0, 11, 6), (5, 0, 5, 6), (-1, 0, 4, 4)):
            self.input_error(lambda: film.render(cells=cells))
        for scale in (0, 65, float("nan")):
            self.input_error(lambda: film.render(scale=scale))
        self.input_error(lambda: pastoso.Tea({"cells": 8, "parcels": 9}).pour_by_hand((float("nan"), 0)))

    def test_have_a_code_and_arguments(self):
        missing = self.folder / "no %1.pastoso"
        with self.assertRaises(pastoso.InputError) as caught:
            pastoso.Painting.open(missing)
        self.assertEqual(caught.exception.code, "%1: cannot be opened (%2).")
        self.assertEqual(caught.exception.arguments[0], str(missing))
        self.assertEqual(str(caught.exception), f"{missing}: cannot be opened ({caught.exception.arguments[1]}).")

    def test_are_value_errors_and_internal_ones_are_not(self):
        self.assertTrue(issubclass(pastoso.InputError, ValueError))
        self.assertTrue(issubclass(pastoso.InternalError, RuntimeError))
        self.assertEqual(pickle.loads(pickle.dumps(pastoso.InputError("a"))).args, ("a",))


class System(InFolder):
    def test_what_cannot_be_written_is_told(self):
        painting = pastoso.Painting(10, 10, 1)
        self.assertIn("no-folder", self.input_error(lambda: painting.save(self.folder / "no-folder" / "a.png")))

    def test_missing_data_is_told(self):
        code = ("import pastoso\n"
                "try: pastoso.media()\n"
                "except pastoso.InputError as error: print(error)")
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True,
                              env={**os.environ, "PASTOSO_RESOURCES": str(self.folder)}).stdout
        self.assertIn(str(self.folder / "media.json"), said)

    def test_unknown_instruction_sets_are_told(self):
        said = subprocess.run([sys.executable, "-c", "import pastoso"], capture_output=True, text=True,
                              env={**os.environ, "PASTOSO_ISA": "sse9"})
        self.assertNotEqual(said.returncode, 0)
        self.assertIn('ImportError: PASTOSO_ISA is "sse9"', said.stderr)


if __name__ == "__main__":
    unittest.main()
