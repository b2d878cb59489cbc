"""The examples at work, small."""

import importlib
import subprocess
import sys
import unittest

import numpy as np

from command_line import SOURCE, InFolder

EXAMPLES = SOURCE / "app/python/examples"
sys.path.insert(0, str(EXAMPLES))


def has(module):
    return importlib.util.find_spec(module) is not None


class Examples(InFolder):
    def run_example(self, name, *arguments):
        result = subprocess.run([sys.executable, EXAMPLES / name, *map(str, arguments)], cwd=self.folder,
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    @unittest.skipUnless(has("matplotlib"), "the plot needs Matplotlib")
    def test_drips_are_shorter_the_more_viscous_paint_is(self):
        import drip_lengths

        lengths = drip_lengths.main(["--count", "4", "--cell-mm", "1", "-o", str(self.folder / "drips.png")])
        self.assertEqual(lengths, sorted(lengths, reverse=True))
        self.assertGreater(lengths[0], 3 * lengths[-1])
        self.assertTrue((self.folder / "drips.png").read_bytes().startswith(b"\x89PNG"))

    def test_robot_paints_what_the_command_line_replays(self):
        import replay_robot

        file = self.folder / "robot.json"
        painting = replay_robot.main(["--px-per-mm", "0.5", "-o", str(self.folder / "robot.png"), "--save", str(file)])
        self.assertEqual(len(painting.undo_steps), 81)
        self.assertEqual(self.figures("replay", file)["state_hash"], f"{painting.state_hash:016x}")

    @unittest.skipUnless(has("PIL"), "photographs need Pillow")
    def test_painter_comes_near_to_its_picture(self):
        import paint_photograph
        from stroke_environment import StrokeEnvironment

        # A sunset: a warm sky that darkens upwards, a disc, and the sea.
        rows, columns = np.mgrid[0:64, 0:64] / 64.0
        photograph = np.stack([0.9 - 0.5 * rows, 0.5 - 0.2 * rows, 0.25 + 0.3 * rows], axis=2)
        photograph[(rows - 0.4) ** 2 + (columns - 0.6) ** 2 < 0.02] = (0.95, 0.8, 0.35)
        photograph[rows > 0.65] = (0.12, 0.2, 0.35)
        environment = StrokeEnvironment(64)
        bare = np.sqrt(np.mean((photograph - environment.render(lit=False) / 255.0) ** 2))
        painter = paint_photograph.paint(photograph, 60, 3, environment)
        self.assertLess(painter.error(), 0.4 * bare)
        picture = environment.render()
        again = paint_photograph.paint(photograph, 60, 3, StrokeEnvironment(64))
        np.testing.assert_array_equal(again.environment.render(), picture)
        other = paint_photograph.paint(photograph, 60, 4, StrokeEnvironment(64))
        self.assertTrue((other.environment.render() != picture).any())

    def test_environment_steps_and_begins_anew(self):
        from stroke_environment import StrokeEnvironment

        environment = StrokeEnvironment(64)
        bare = environment.reset(seed=5)
        self.assertEqual((bare.shape, bare.dtype), ((64, 64, 3), np.uint8))
        random = np.random.default_rng(1)
        actions = random.uniform(0.2, 0.8, (5, environment.ACTION_SIZE))
        pictures = []
        for _ in range(2):
            np.testing.assert_array_equal(environment.reset(seed=5), bare)
            for action in actions:
                environment.step(action)
            environment.settle(0.1)
            pictures.append(environment.render())
        np.testing.assert_array_equal(*pictures)
        self.assertTrue((pictures[0] != bare).any())
        self.assertEqual(environment.strokes, 5)
        with self.assertRaises(ValueError):
            environment.step(actions[0][:4])

    def test_first_picture_tells_its_time(self):
        said = self.run_example("first_picture.py", "-o", "first.png")
        self.assertIn("s to a lit picture (512, 512, 3) of 100 strokes", said)
        self.assertTrue((self.folder / "first.png").exists())


if __name__ == "__main__":
    unittest.main()
