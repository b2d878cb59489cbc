"""Python goes on while the engine computes, and one object is used by one thread at a time."""

import signal
import tempfile
import threading
import time
import unittest

import numpy as np

import pastoso


def flowing_film():
    return pastoso.Film({"size_mm": [60, 60], "cell_mm": 0.25, "paint": {"viscosity_m2_s": 0.001}, "duration_s": 60,
                         "tilt": {"tilt_deg": 80}, "film": [{"kind": "noise", "thickness_mm": 2}],
                         "solver": {"scheme": "explicit"}}, threads=1)


def progress_during(work):
    """How often another Python thread has come round while work() ran."""
    rounds, ended = 0, False

    def count():
        nonlocal rounds
        while not ended:
            rounds += 1
            time.sleep(0.0005)

    counter = threading.Thread(target=count)
    counter.start()
    before = rounds
    work()
    during = rounds - before
    ended = True
    counter.join()
    return during


class OtherThreads(unittest.TestCase):
    # A thread that had to wait for the lock would come round once at most; the work takes far longer than a round.

    def test_go_on_while_films_flow_and_are_rendered(self):
        film = flowing_film()
        self.assertGreater(progress_during(lambda: film.advance(0.05)), 5)
        self.assertGreater(progress_during(lambda: film.render(scale=4)), 5)

    def test_go_on_while_paintings_are_painted_saved_and_opened(self):
        painting = pastoso.Painting(100, 100, 4, threads=1)
        painting.take_brush("Flat bristle 20", size_mm=30)
        painting.load("PB29")
        share = np.linspace(0, 1, 200)
        samples = np.stack([share, 10 + 80 * share, 50 + 30 * np.sin(9 * share), 0 * share + 0.6], axis=1)
        self.assertGreater(progress_during(lambda: painting.stroke(samples)), 5)
        self.assertGreater(progress_during(lambda: painting.advance(1)), 5)
        self.assertGreater(progress_during(lambda: pastoso.Painting.replay(painting.recording())), 5)
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/a.pastoso"
            self.assertGreater(progress_during(lambda: painting.save(file)), 5)
            self.assertGreater(progress_during(lambda: pastoso.Painting.open(file)), 5)

    def test_go_on_while_liquids_move(self):
        tea = pastoso.Tea({"cells": 32, "parcels": 20000}, threads=1)
        self.assertGreater(progress_during(lambda: tea.step(10)), 5)
        self.assertGreater(progress_during(lambda: tea.render(32, 32, samples=16)), 5)

    def test_go_on_while_the_solver_is_validated(self):
        self.assertGreater(progress_during(lambda: pastoso.validate("nusselt-film", scheme="large")), 5)


class OneObject(unittest.TestCase):
    def test_of_two_threads_one_waits(self):
        film = flowing_film()
        alone = flowing_film()
        for _ in range(8):
            alone.advance(0.01)
        threads = [threading.Thread(target=lambda: [film.advance(0.01) for _ in range(4)]) for _ in range(2)]
        for thread in threads:
            thread.start()
        totals = [film.thickness.astype(np.float64).sum() for _ in range(10)]
        for thread in threads:
            thread.join()
        self.assertEqual(film.state_hash, alone.state_hash)
        # Open edges: what is read between two steps is a film that has lost some.
        self.assertEqual(sorted(totals, reverse=True), totals)

    def test_objects_compute_beside_each_other(self):
        teas = [pastoso.Tea({"cells": 16, "parcels": 300}, threads=2) for _ in range(3)]
        threads = [threading.Thread(target=tea.step, args=(20,)) for tea in teas]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len({tea.state_hash for tea in teas}), 1)


class Interruption(unittest.TestCase):
    def interrupted(self, work):
        main = threading.main_thread().ident
        threading.Timer(0.3, lambda: signal.pthread_kill(main, signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            work()

    def test_puts_a_film_back(self):
        film = flowing_film()
        film.advance(0.01)
        before, time_s = film.state_hash, film.time_s
        self.interrupted(lambda: film.advance(1000))
        self.assertEqual((film.state_hash, film.time_s), (before, time_s))
        film.advance(0.01)

    def test_leaves_a_painting_between_two_ticks(self):
        painting = pastoso.Painting(50, 50, 4, threads=1)
        painting.take_brush("Flat bristle 20")
        painting.load("PB29")
        painting.stroke([[0, 10, 25, 0.5], [0.2, 40, 25, 0.5]])
        painting.tilt(80)
        self.interrupted(lambda: painting.advance(1e6))
        again = pastoso.Painting.replay(painting.recording())
        self.assertEqual((again.tick, again.state_hash), (painting.tick, painting.state_hash))

    def test_stops_liquids_between_two_steps(self):
        tea = pastoso.Tea({"cells": 16, "parcels": 300}, threads=1)
        self.interrupted(lambda: tea.step(10**6))
        self.assertGreater(tea.steps, 0)
        tea.step()
        tank = pastoso.Tank({"cells": [12, 12, 12], "cell_m": 0.01, "liquids": [
            {"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [0.05, 1, 0.08]}}}]}, threads=1)
        self.interrupted(lambda: tank.advance(1e6))
        self.assertGreater(tank.steps, 0)

    def test_stops_pictures_and_validation(self):
        tea = pastoso.Tea({"cells": 16, "parcels": 300}, threads=2)
        tea.step()
        self.interrupted(lambda: tea.render(400, 400, samples=10**6))
        self.interrupted(lambda: pastoso.validate("fingers", with_long=True, threads=2))


if __name__ == "__main__":
    unittest.main()
