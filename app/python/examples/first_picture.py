"""How long it takes from `import pastoso` to a lit picture of 512 x 512 pixels with 100 strokes on it.

    python3 first_picture.py -o first.png
"""

import argparse
import sys
import time

import numpy as np


def strokes(count: int, seed: int) -> list:
    """Curves (20, 7) across a canvas of 128 mm, at 150 mm/s, and colours."""
    random = np.random.default_rng(seed)
    share = np.linspace(0.0, 1.0, 20)
    made = []
    for _ in range(count):
        middle, turn = random.uniform(16, 112, 2), random.uniform(0, 2 * np.pi)
        along = (share - 0.5) * random.uniform(25, 60)
        bow = random.normal(0, 6) * (1 - (2 * share - 1) ** 2)
        x = middle[0] + along * np.cos(turn) - bow * np.sin(turn)
        y = middle[1] + along * np.sin(turn) + bow * np.cos(turn)
        time_s = (along - along[0]) / 150.0
        pressure = np.clip(8 * np.minimum(share, 1 - share), 0.2, 0.6)
        colour = "#%02x%02x%02x" % tuple(random.integers(30, 240, 3))
        # The flat brush stands across its way.
        rotation = np.full_like(x, np.degrees(turn) + 90.0)
        made.append((np.stack([time_s, x, y, pressure, 0 * x, 0 * x, rotation], axis=1), colour))
    return made


def main(arguments: list) -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output")
    parser.add_argument("--threads", type=int, default=0, help="0: one per processor")
    parser.add_argument("--flow", action="store_true", help="let the paint flow while the strokes are painted")
    options = parser.parse_args(arguments)
    given = strokes(100, 7)

    begin = time.perf_counter()
    import pastoso

    imported = time.perf_counter()
    painting = pastoso.Painting(128, 128, 4, threads=options.threads)
    painting.use_medium("heavy-body oil")
    painting.take_brush("Flat bristle 20", size_mm=10)
    made = time.perf_counter()
    for samples, colour in given:
        painting.clean_brush()
        painting.load(colour)
        painting.stroke(samples, flow=options.flow)
    painted = time.perf_counter()
    picture = painting.render()
    rendered = time.perf_counter()
    if options.output:
        painting.save(options.output)
    print(f"{rendered - begin:.3f} s to a lit picture {picture.shape} of {len(given)} strokes with {painting.threads} threads: "
          f"import {imported - begin:.3f}, canvas and brush {made - imported:.3f}, strokes {painted - made:.3f}, "
          f"rendering {rendered - painted:.3f}")


if __name__ == "__main__":
    main(sys.argv[1:])
