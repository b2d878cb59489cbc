"""How far paint runs down an upright board, for viscosities from ink to cream, with a plot.

    python3 drip_lengths.py -o drips.png

A drop of Newtonian paint hangs on the board and runs for some seconds. As long as it keeps its thickness h it runs at a
speed of the order of g h^2 / 3 nu; later, drawn out to a sheet that gets ever thinner, it has come as far as
(9 A^2 g t / 4 nu)^(1/3) (Huppert 1982). The plot shows both slopes beside the drops.
"""

from __future__ import annotations

import argparse
import sys

import numpy as np

import pastoso

TOP_MM = 9.0


def drop_on_a_board(viscosity_m2_s: float, seconds: float, cell_mm: float) -> dict:
    """A scene (docs/scene-format.md): a cap of paint near the top of an upright, smooth board."""
    return {
        "size_mm": [24, 100],
        "cell_mm": cell_mm,
        "edges": {"x": "wall", "y": "open"},
        "tilt": {"tilt_deg": 90},
        "paint": {"viscosity_m2_s": viscosity_m2_s, "advancing_angle_deg": 20, "receding_angle_deg": 5},
        "film": [{"kind": "cap", "at_mm": [12, TOP_MM], "radius_mm": 5, "thickness_mm": 2, "pigment": "PB29"}],
        "duration_s": seconds,
    }


def sweep(viscosities: np.ndarray, seconds: float, cell_mm: float) -> tuple[list[float], list[np.ndarray]]:
    """Lengths in mm and pictures of the drips, for all viscosities."""
    lengths, pictures = [], []
    for viscosity in viscosities:
        film = pastoso.Film(drop_on_a_board(float(viscosity), seconds, cell_mm))
        began_mm = film.front()["tip_mm"]
        film.run()
        lengths.append(film.front()["tip_mm"] - began_mm)
        pictures.append(film.render(scale=0.5 / cell_mm * 4))
        print(f"{viscosity:.3g} m2/s: {lengths[-1]:.2f} mm", flush=True)
    return lengths, pictures


def plot(viscosities: np.ndarray, lengths: list[float], pictures: list[np.ndarray], seconds: float, path: str) -> None:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 5), width_ratios=(1, 1.2))
    left.loglog(viscosities, lengths, "o-", label="drops of paint")
    thin, thick = viscosities[:len(viscosities) // 2 + 1], viscosities[-3:]
    left.loglog(thin, 1.3 * lengths[0] * (thin / thin[0]) ** (-1 / 3), ":", color="grey", label="slope -1/3: late")
    left.loglog(thick, 1.3 * lengths[-1] * (thick / thick[-1]) ** -1.0, "--", color="grey", label="slope -1: early")
    left.set_xlabel("kinematic viscosity, m²/s")
    left.set_ylabel(f"how far the drip has run after {seconds:g} s, mm")
    left.legend()
    right.imshow(np.hstack(pictures)[:int(0.75 * len(pictures[0]))])
    right.set_axis_off()
    right.set_title("from " + " to ".join(f"{value:.2g} m²/s" for value in (viscosities[0], viscosities[-1])))
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main(arguments: list[str]) -> list[float]:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="drips.png")
    parser.add_argument("--count", type=int, default=7, help="how many viscosities")
    parser.add_argument("--seconds", type=float, default=4.0)
    parser.add_argument("--cell-mm", type=float, default=0.5)
    options = parser.parse_args(arguments)
    viscosities = np.geomspace(2e-4, 2e-2, options.count)
    lengths, pictures = sweep(viscosities, options.seconds, options.cell_mm)
    plot(viscosities, lengths, pictures, options.seconds, options.output)
    print(f"{options.output}: the plot")
    return lengths


if __name__ == "__main__":
    main(sys.argv[1:])
