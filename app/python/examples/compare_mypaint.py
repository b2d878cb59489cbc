"""The strokes of a painted photograph once with this engine and once with libmypaint, by MyPaint's Python binding.

    python3 compare_mypaint.py -o both.png        # needs the Debian package mypaint

Both paint the same curves with brushes of the same widths and colours on 256 x 256 pixels, on one thread. libmypaint lays
dabs of colour; its brush is MyPaint's "brush" of the set "classic", with --brush another one.
"""

from __future__ import annotations

import argparse
import sys
import time

import numpy as np
from PIL import Image

import paint_photograph
from stroke_environment import StrokeEnvironment

MYPAINT = "/usr/lib/mypaint"
BRUSHES = "/usr/share/mypaint-data/2.0/brushes"


class MypaintCanvas:
    """What StrokeEnvironment does, with libmypaint: the same actions."""

    def __init__(self, environment: StrokeEnvironment, brush: str) -> None:
        sys.path.insert(0, MYPAINT)
        from lib import brush as brushes, eotf, tiledsurface

        self.environment, self.curve = environment, eotf.eotf()
        self.surface = tiledsurface.Surface()
        with open(f"{BRUSHES}/{brush}.myb") as file:
            self.info = brushes.BrushInfo(file.read())
        self.brush = brushes.Brush(self.info)

    def step(self, action: np.ndarray) -> None:
        thin, wide = self.environment.WIDTHS_MM
        px_per_mm = self.environment.side / self.environment.side_mm
        width_px = thin * (wide / thin) ** action[6] * px_per_mm
        self.info.set_base_value("radius_logarithmic", float(np.log(0.5 * width_px)))
        self.info.set_color_rgb(tuple(map(float, action[8:])))
        samples = self.environment.samples(np.clip(action, 0.0, 1.0))
        self.brush.reset()
        self.surface.begin_atomic()
        x, y = samples[0, 1:3] * px_per_mm
        # MyPaint's way to begin elsewhere: the pen is lifted, and a long time passes.
        self.brush.stroke_to(self.surface.backend, x, y, 0.0, 0.0, 0.0, 10.0, 1.0, 0.0, 0.0)
        last_s = samples[0, 0]
        for time_s, x_mm, y_mm, pressure in samples[:, :4]:
            self.brush.stroke_to(self.surface.backend, x_mm * px_per_mm, y_mm * px_per_mm, float(pressure), 0.0, 0.0,
                                 max(time_s - last_s, 1e-4), 1.0, 0.0, 0.0)
            last_s = time_s
        self.surface.end_atomic()

    def render(self) -> np.ndarray:
        """On white, uint8 (side, side, 3)."""
        side, tile = self.environment.side, 64
        picture = np.ones((side, side, 3))
        for row in range(side // tile):
            for column in range(side // tile):
                with self.surface.tile_request(column, row, readonly=True) as values:
                    rgba = values.astype(np.float64) / (1 << 15)
                part = picture[row * tile:(row + 1) * tile, column * tile:(column + 1) * tile]
                part[...] = rgba[..., :3] + part * (1 - rgba[..., 3:])
        # MyPaint keeps linear light.
        return np.rint(255 * np.clip(picture, 0, 1) ** (1 / self.curve)).astype(np.uint8)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("photograph", nargs="?")
    parser.add_argument("-o", "--output", default="both.png")
    parser.add_argument("--strokes", type=int, default=500)
    parser.add_argument("--brush", default="classic/brush", help="of MyPaint")
    arguments = parser.parse_args()
    side, seed = 256, 1
    environment = StrokeEnvironment(side)
    photograph = paint_photograph.square_photograph(arguments.photograph, side)
    actions = paint_photograph.paint(photograph, arguments.strokes, seed, environment).actions
    ours = paint_photograph.strokes_per_s(actions, environment, seed)
    canvas = MypaintCanvas(environment, arguments.brush)
    begin = time.perf_counter()
    for action in actions:
        canvas.step(action)
    theirs = len(actions) / (time.perf_counter() - begin)
    Image.fromarray(np.hstack([environment.render(), canvas.render()])).save(arguments.output)
    print(f"{len(actions)} strokes, {side} x {side}, one thread: Pastoso {ours:.0f} strokes/s, "
          f"libmypaint ({arguments.brush}) {theirs:.0f} strokes/s")


if __name__ == "__main__":
    main()
