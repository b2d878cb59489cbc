"""An environment for stroke-based rendering: a canvas of real oil paint that is painted one stroke at a time.

    environment = StrokeEnvironment(256)
    environment.reset(seed=1)
    environment.step(action)          # eleven numbers from 0 to 1
    picture = environment.render()    # uint8 (256, 256, 3)

The same seed and actions give the same picture, on any machine.
"""

from __future__ import annotations

import numpy as np

import pastoso

SPEED_MM_S = 150.0
SAMPLES_PER_S = 100.0


class StrokeEnvironment:
    """A square canvas of `side` cells, 2 a millimetre, which is `side` pixels wide in pictures.

    An action is eleven numbers from 0 to 1: x and y of the beginning, the middle and the end of a curve (1, 1 is the lower
    right corner), the width of the brush (from 2 to 32 mm, in proportion), the pressure, and red, green and blue (sRGB).
    A stroke has a brush that is cleaned and dipped afresh. Paint time stands still while strokes are painted; settle()
    lets paint flow, and dry() fixes what lies there.
    """

    ACTION_SIZE = 11
    WIDTHS_MM = (2.0, 32.0)

    def __init__(self, side: int = 256, *, threads: int = 1, support: str = "fine portrait linen",
                 brush: str = "Flat bristle 20", medium: str = "heavy-body oil") -> None:
        self.side, self.side_mm = side, side / 2.0
        self._threads, self._support, self._brush, self._medium = threads, support, brush, medium
        self.reset()

    def reset(self, seed: int = 0) -> np.ndarray:
        """A bare canvas. Returns its picture. The seed decides how the bristles of all brushes stand."""
        self._random = np.random.default_rng(seed)
        self._width_mm = 0.0
        self.strokes = 0
        self.painting = pastoso.Painting(self.side_mm, self.side_mm, 2, self._support, threads=self._threads)
        self.painting.set_undo_memory(0)
        self.painting.use_medium(self._medium)
        return self.render()

    def step(self, action: np.ndarray) -> None:
        """Paints the stroke of an action."""
        numbers = np.clip(np.asarray(action, dtype=np.float64), 0.0, 1.0)
        if numbers.shape != (self.ACTION_SIZE,):
            raise ValueError(f"an action is {self.ACTION_SIZE} numbers, not {numbers.shape}")
        thin, wide = self.WIDTHS_MM
        self._take(thin * (wide / thin) ** numbers[6])
        self.painting.clean_brush()
        self.painting.load("#%02x%02x%02x" % tuple(np.rint(255 * numbers[8:]).astype(int)), fill=0.9)
        self.painting.stroke(self.samples(numbers), flow=False)
        self.strokes += 1

    def render(self, *, lit: bool = True, cells: tuple[int, int, int, int] | None = None) -> np.ndarray:
        """The picture, uint8 (side, side, 3) or of some cells; without light and shade where not lit."""
        return self.painting.render(lit=lit, cells=cells)

    def settle(self, seconds: float) -> None:
        """Lets the paint flow."""
        self.painting.advance(seconds)

    def dry(self) -> None:
        """Fixes all wet paint, so that what comes next lies over it and does not mix with it."""
        self.painting.dry_now()

    def _take(self, width_mm: float) -> None:
        """Another brush is taken only where the width differs: it is what takes the time."""
        if abs(width_mm - self._width_mm) < 0.02 * width_mm:
            return
        self.painting.take_brush(self._brush, size_mm=width_mm, seed=int(self._random.integers(1, 2**31)))
        self._width_mm = width_mm

    def samples(self, numbers: np.ndarray) -> np.ndarray:
        """A quadratic Bezier curve through the three points, at an even pace of its parameter."""
        begin, middle, end = numbers[:6].reshape(3, 2) * self.side_mm
        control = 2.0 * middle - 0.5 * (begin + end)
        length_mm = np.linalg.norm(middle - begin) + np.linalg.norm(end - middle)
        count = max(3, int(np.ceil(length_mm / SPEED_MM_S * SAMPLES_PER_S)))
        share = np.linspace(0.0, 1.0, count)[:, None]
        points = (1 - share) ** 2 * begin + 2 * share * (1 - share) * control + share**2 * end
        # The brush comes down and lifts within a tenth of the way.
        touch = np.clip(10.0 * np.minimum(share, 1.0 - share), 0.2, 1.0)
        times = share * length_mm / SPEED_MM_S
        along = np.gradient(points, axis=0)
        # The flat brush stands across its way.
        rotation = np.degrees(np.unwrap(np.arctan2(along[:, 1], along[:, 0])))[:, None] + 90.0
        upright = np.zeros((count, 2))
        return np.hstack([times, points, touch * (0.2 + 0.7 * numbers[7]), upright, rotation])
