"""Paints the list of strokes that a robot was given, as it was timed, and keeps the painting.

    python3 replay_robot.py robot_strokes.csv -o robot.png --save robot.json

A line of the list is a moment of the tool: number of the stroke, seconds, x and y in mm, how far the bristles are pressed
below touching the canvas in mm, lean to the right and down in degrees, rotation about the tool in degrees, and paint.
"""

from __future__ import annotations

import argparse
import csv
import sys
from itertools import groupby
from pathlib import Path

import numpy as np

import pastoso

CANVAS_MM = (160.0, 120.0)
BRUSH = "Flat bristle 20"
# How far the robot presses its brush at most; the engine's pressure is a share of that.
DEEPEST_MM = 6.0


def read_strokes(path: str) -> list[tuple[np.ndarray, str]]:
    """Samples (count, 7) as Painting.stroke() takes them, and the paint, of each stroke."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    strokes = []
    for _, moments in groupby(rows, key=lambda row: row["stroke"]):
        moments = list(moments)
        samples = np.array([[float(row[key]) for key in
                             ("t_s", "x_mm", "y_mm", "depth_mm", "lean_x_deg", "lean_y_deg", "rotation_deg")]
                            for row in moments])
        samples[:, 3] = np.clip(samples[:, 3] / DEEPEST_MM, 0.0, 1.0)
        strokes.append((samples, moments[0]["paint"]))
    return strokes


def mixture(text: str) -> list[tuple[str, float]]:
    """"PB29=1+PW6=0.5" as pigments with their parts."""
    parts = (part.split("=") for part in text.split("+"))
    return [(pigment, float(share)) for pigment, share in parts]


def paint(strokes: list[tuple[np.ndarray, str]], px_per_mm: float, threads: int = 0) -> pastoso.Painting:
    """Paints them at the times of the list: the paint runs while the robot dips its brush."""
    painting = pastoso.Painting(*CANVAS_MM, px_per_mm, "medium linen", threads=threads)
    painting.use_medium("heavy-body oil")
    painting.take_brush(BRUSH, size_mm=9)
    for samples, paint_name in strokes:
        painting.advance(max(0.0, samples[0, 0] - painting.time_s))
        painting.clean_brush()
        painting.load(mixture(paint_name))
        painting.stroke(samples)
    painting.advance(1.0)
    return painting


def main(arguments: list[str]) -> pastoso.Painting:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("strokes", nargs="?", default=str(Path(__file__).parent / "robot_strokes.csv"))
    parser.add_argument("-o", "--output", default="robot.png")
    parser.add_argument("--save", help="the recording, for pastoso-cli replay")
    parser.add_argument("--px-per-mm", type=float, default=4.0)
    options = parser.parse_args(arguments)
    painting = paint(read_strokes(options.strokes), options.px_per_mm)
    painting.save(options.output)
    if options.save:
        painting.save(options.save)
    print(f"{options.output}: {painting.time_s:.1f} s of painting, state {painting.state_hash:016x}")
    return painting


if __name__ == "__main__":
    main(sys.argv[1:])
