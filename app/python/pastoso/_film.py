"""Films of wet paint without a brush."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, List, Optional

import numpy as np

from . import _engine
from ._scene import PathLike, Source, source, split_arrays

_FORMAT = ("scene", "pastoso-scene", 1)


class Film(_engine.Film):
    """A scene of wet paint that flows, from time 0 on.

    scene: a dictionary as docs/scene-format.md describes it ("format" and "version" may be left out), the path of such a
    file, or the name of a scene that comes along (scenes()). In a dictionary, "film" may hold arrays,
    {"kind": "array", "thickness_mm": (height, width), "pigment": ...}, and so may "support",
    {"kind": "array", "height_mm": (height, width)}: a value for every cell, mm. float32 that lies row by row is read
    where it is; other numbers are converted first.
    run: which one, of a scene with several.
    threads: how many compute; 0: one per processor; None: as the scene says. The bits do not depend on it.
    folder: where relative paths of a dictionary start.

    Raises InputError for whatever the format does not allow, with its place: "scene, film[2].radius_mm: ...".
    """

    def __init__(self, scene: Source, *, run: str = "", threads: Optional[int] = None, folder: PathLike = ".") -> None:
        arrays: List[Any] = []
        if isinstance(scene, Mapping):
            scene, arrays = split_arrays(scene)
        text, name = source(scene, *_FORMAT)
        super().__init__(text=text, name=name, folder=os.fspath(folder), run=run, threads=threads, arrays=arrays)

    def run(self) -> "Film":
        """Lets the film flow to the end of the scene, cut where `pastoso-cli simulate` cuts it: the same bits."""
        for stop_s in self.stops_s:
            if stop_s >= self.time_s:
                self.advance_to(stop_s)
        return self

    @property
    def thickness(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Thickness h of the wet paint, mm, float32 (height, width): a new array; read() fills one that there is."""
        return self.read("thickness")

    @property
    def support(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Height c of what the paint lies on, mm, float32 (height, width)."""
        return self.read("support")

    @property
    def surface(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Height h + c of the paint's surface, mm, float32 (height, width)."""
        return self.read("surface")

    @property
    def velocity(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Velocity of the paint, mean over its depth, mm/s, float32 (height, width, 2): along x at the right face of
        each cell, along y at its lower face."""
        return self.read("velocity")

    @property
    def pigment(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Optical thickness K h and S h in six bands of light, no unit, float32 (height, width, 12)."""
        return self.read("pigment")

    def __repr__(self) -> str:
        height, width = self.shape
        return f"<pastoso.Film of {width} x {height} cells at {self.time_s:g} s>"


def scene_runs(scene: Source, *, folder: PathLike = ".") -> List[str]:
    """The names of the runs of a scene; none where it has a single one."""
    if isinstance(scene, Mapping):
        scene, _ = split_arrays(scene)
    text, name = source(scene, *_FORMAT)
    return _engine.scene_runs(text, name, os.fspath(folder))
