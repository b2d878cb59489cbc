"""Paints a photograph with oil strokes, from broad ones to fine ones, and tells how fast.

    python3 paint_photograph.py PHOTOGRAPH -o painted.png

Each stroke is chosen among some that follow the forms of the photograph: the one that brings the picture nearest to it.
Between two widths the paint dries, as painters do it, so that lights stay clean over darks.
"""

from __future__ import annotations

import argparse
import time

import numpy as np
from PIL import Image

from stroke_environment import StrokeEnvironment

# Width in mm on a canvas of 128 mm, and the share of all strokes.
PASSES = ((24.0, 0.05), (13.0, 0.10), (7.5, 0.18), (4.5, 0.27), (2.7, 0.40))
CANDIDATES = 40
# Of the sample: left, top and side, pixels.
SAMPLE_HEAD = (100, 0, 330)


def square_photograph(path: str | None, side: int) -> np.ndarray:
    """The middle of a photograph, or the head of the sample, as floats from 0 to 1 (side, side, 3)."""
    picture = Image.open(path or sample_photograph()).convert("RGB")
    edge = min(picture.size)
    left, top = (picture.width - edge) // 2, (picture.height - edge) // 4
    if path is None:
        left, top, edge = SAMPLE_HEAD
    picture = picture.crop((left, top, left + edge, top + edge)).resize((side, side), Image.LANCZOS)
    return np.asarray(picture, dtype=np.float64) / 255.0


def blurred(picture: np.ndarray, deviation_px: float) -> np.ndarray:
    """Under a Gaussian, mirrored at its edges."""
    for axis in (0, 1):
        size = picture.shape[axis]
        mirrored = np.concatenate([picture, np.flip(picture, axis)], axis)
        waves = np.exp(-2.0 * (np.pi * deviation_px * np.fft.rfftfreq(2 * size)) ** 2)
        waves = waves.reshape([-1 if i == axis else 1 for i in range(picture.ndim)])
        picture = np.fft.irfft(np.fft.rfft(mirrored, axis=axis) * waves, 2 * size, axis=axis).take(range(size), axis)
    return picture


class Painter:
    """Chooses strokes that bring a canvas nearer to a photograph."""

    def __init__(self, photograph: np.ndarray, environment: StrokeEnvironment, seed: int) -> None:
        self.photograph, self.environment = photograph, environment
        self.random = np.random.default_rng(seed)
        environment.reset(seed)
        self.seen = environment.render(lit=False) / 255.0
        self.actions: list[np.ndarray] = []

    def error(self) -> float:
        """Root of the mean square of what is wrong, 0 to 1."""
        return float(np.sqrt(np.mean((self.photograph - self.seen) ** 2)))

    def paint(self, width_mm: float, strokes: int) -> None:
        """Paints so many strokes of one width, of the photograph as it is seen through half-closed eyes."""
        side = self.environment.side
        self.width_px = width_mm * side / self.environment.side_mm
        blur = 0.2 * self.width_px
        self.target = blurred(self.photograph, blur)
        grey = blurred(self.photograph.mean(axis=2), 0.35 * self.width_px)
        self.slope_y, self.slope_x = np.gradient(grey)
        for _ in range(strokes):
            self.paint_one(width_mm)

    def paint_one(self, width_mm: float) -> None:
        wrong = ((self.target - self.seen) ** 2).sum(axis=2)
        best_gain, best = -np.inf, None
        for start in self.starts(wrong):
            gain, candidate = self.candidate(start)
            if gain > best_gain:
                best_gain, best = gain, candidate
        points, colour = best
        self.put(points, colour, width_mm)

    def starts(self, wrong: np.ndarray) -> np.ndarray:
        """Places where much is wrong, (CANDIDATES, 2) px: squares half as wide as the brush, and a point in each."""
        side = self.environment.side
        square = max(1, int(0.5 * self.width_px))
        edges = np.arange(0, side, square)
        squares = np.add.reduceat(np.add.reduceat(wrong, edges, axis=0), edges, axis=1)
        chance = squares.ravel() ** 1.5 + 1e-9
        chosen = self.random.choice(chance.size, CANDIDATES, p=chance / chance.sum())
        corners = edges[np.stack([chosen % len(edges), chosen // len(edges)], axis=1)]
        return np.minimum(corners + self.random.uniform(0, square, corners.shape), side - 1.0)

    def candidate(self, start: np.ndarray) -> tuple[float, tuple[np.ndarray, np.ndarray]]:
        """A stroke from a place on, along the forms, as long as its colour is better than what is there."""
        points = self.follow(start)
        rows, columns, weight = self.footprint(points)
        target, seen = self.target[rows, columns], self.seen[rows, columns]
        colour = (weight[:, None] * target).sum(axis=0) / weight.sum()
        gain = (weight * (((target - seen) ** 2).sum(axis=1) - ((target - colour) ** 2).sum(axis=1))).sum()
        return gain, (points, colour)

    def follow(self, start: np.ndarray) -> np.ndarray:
        """Three points along the edges of the photograph, px."""
        colour = self.target[tuple(np.rint(start[::-1]).astype(int))]
        step = 0.5 * self.width_px
        longest = self.random.uniform(2.0, 7.0) * self.width_px
        point, heading, path = start, None, [start]
        while len(path) * step < longest:
            row, column = np.rint(point[::-1]).astype(int)
            along = np.array([-self.slope_y[row, column], self.slope_x[row, column]])
            length = np.hypot(*along)
            if length < 1e-4:
                along = heading if heading is not None else self.random.normal(size=2)
                length = np.hypot(*along)
            along = along / length
            if heading is not None:
                along = along if along @ heading > 0 else -along
                along = 0.5 * along + 0.5 * heading
                along /= np.hypot(*along)
            following = point + step * along
            if not np.all((following >= 0) & (following <= self.environment.side - 1)):
                break
            row, column = np.rint(following[::-1]).astype(int)
            ours = ((self.target[row, column] - colour) ** 2).sum()
            theirs = ((self.target[row, column] - self.seen[row, column]) ** 2).sum()
            if len(path) > 2 and ours > theirs:
                break
            point, heading = following, along
            path.append(point)
        if len(path) == 1:
            path.append(np.clip(start + step, 0, self.environment.side - 1))
        return np.array([path[0], path[len(path) // 2], path[-1]])

    def footprint(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Pixels that a stroke would cover, and how well."""
        low = np.maximum(np.floor(points.min(axis=0) - self.width_px).astype(int), 0)
        high = np.minimum(np.ceil(points.max(axis=0) + self.width_px).astype(int) + 1, self.environment.side)
        rows, columns = np.mgrid[low[1]:high[1], low[0]:high[0]]
        share = np.linspace(0.0, 1.0, 12)[:, None, None]
        control = 2.0 * points[1] - 0.5 * (points[0] + points[2])
        curve = [(1 - share) ** 2 * points[0][i] + 2 * share * (1 - share) * control[i] + share**2 * points[2][i]
                 for i in range(2)]
        distance = np.sqrt(((columns - curve[0]) ** 2 + (rows - curve[1]) ** 2).min(axis=0))
        weight = np.clip((0.5 * self.width_px - distance) / 1.5 + 0.5, 0.0, 1.0)
        covered = weight > 0
        return rows[covered], columns[covered], weight[covered]

    def put(self, points: np.ndarray, colour: np.ndarray, width_mm: float) -> None:
        environment, side = self.environment, self.environment.side
        thin, wide = environment.WIDTHS_MM
        width = np.log(width_mm / thin) / np.log(wide / thin)
        action = np.concatenate([((points + 0.5) / side).ravel(), [width, 0.55], colour])
        environment.step(action)
        self.actions.append(action)
        margin = self.width_px + 2
        left, top = np.maximum(points.min(axis=0) - margin, 0).astype(int)
        right, bottom = np.minimum(points.max(axis=0) + margin, side).astype(int)
        part = environment.render(lit=False, cells=(left, top, right, bottom))
        self.seen[top:bottom, left:right] = part / 255.0


def paint(photograph: np.ndarray, strokes: int, seed: int, environment: StrokeEnvironment) -> Painter:
    """Paints it with about so many strokes."""
    painter = Painter(photograph, environment, seed)
    for width_mm, share in PASSES:
        painter.paint(width_mm * environment.side_mm / 128.0, max(1, round(share * strokes)))
        environment.settle(0.2)
        environment.dry()
    return painter


def strokes_per_s(actions: list[np.ndarray], environment: StrokeEnvironment, seed: int) -> float:
    """How many of the strokes are painted in a second, nothing else being done."""
    environment.reset(seed)
    begin = time.perf_counter()
    for action in actions:
        environment.step(action)
    return len(actions) / (time.perf_counter() - begin)


def sample_photograph() -> str:
    """A portrait that comes with Matplotlib (Grace Hopper, United States Navy, public domain)."""
    from matplotlib import cbook

    return str(cbook.get_sample_data("grace_hopper.jpg", asfileobj=False))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("photograph", nargs="?", help="default: a portrait that comes with Matplotlib")
    parser.add_argument("-o", "--output", default="painted.png")
    parser.add_argument("--strokes", type=int, default=500)
    parser.add_argument("--side", type=int, default=256, help="pixels")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()

    photograph = square_photograph(arguments.photograph, arguments.side)
    environment = StrokeEnvironment(arguments.side)
    bare = float(np.sqrt(np.mean((photograph - environment.render(lit=False) / 255.0) ** 2)))
    begin = time.perf_counter()
    painter = paint(photograph, arguments.strokes, arguments.seed, environment)
    passed = time.perf_counter() - begin
    Image.fromarray(environment.painting.render(scale=3)).save(arguments.output)
    print(f"{arguments.output}: {len(painter.actions)} strokes, error {bare:.3f} of the bare canvas to "
          f"{painter.error():.3f}, in {passed:.1f} s")
    rate = strokes_per_s(painter.actions, environment, arguments.seed)
    print(f"the same strokes alone, {arguments.side} x {arguments.side}, one thread: {rate:.0f} strokes/s")


if __name__ == "__main__":
    main()
