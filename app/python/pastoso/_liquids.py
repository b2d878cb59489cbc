"""Liquids in glass: milk in tea, and tanks."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, NamedTuple, Optional

import numpy as np

from . import _engine
from ._scene import PathLike, Source, source


class Mesh(NamedTuple):
    """A surface of triangles, z up.

    positions_m: m, float32 (vertices, 3). normals: of length 1, outwards, float32 (vertices, 3); None where there are
    none. triangles: places of vertices, counter-clockwise seen from outside, uint32 (triangles, 3).
    """

    positions_m: "np.ndarray[Any, np.dtype[np.float32]]"
    normals: "Optional[np.ndarray[Any, np.dtype[np.float32]]]"
    triangles: "np.ndarray[Any, np.dtype[np.uint32]]"

    def volume_m3(self) -> float:
        """What a closed mesh encloses: the sum of a . (b x c) / 6 over its triangles."""
        a, b, c = np.moveaxis(self.positions_m.astype(np.float64)[self.triangles], 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)


class Tea(_engine.Tea):
    """A glass of tea that milk is poured into.

    scene: a dictionary as docs/tea-format.md describes it ("format" and "version" may be left out), the path of such a
    file, or the name of a tea that comes along (teas()).
    fps: makes steps so long that a whole number of them is a frame, as `pastoso-cli tea --fps` does (30 there); None:
    step_s of the scene. threads: how many compute, 0 for one per processor; the bits do not depend on it.
    """

    def __init__(self, scene: Source = "usual", *, threads: int = 0, fps: Optional[float] = None) -> None:
        text, name = source(scene, "tea", "pastoso-tea", 1)
        super().__init__(text=text, name=name, threads=threads, fps=fps)

    def advance(self, seconds: float) -> None:
        """Lets time pass in whole steps, as many as come nearest to `seconds`."""
        self.step(round(seconds / self.step_s))

    @property
    def dissolved(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Share of milk that has dissolved, 0 to 1, float32 (z, y, x) with a value for each cell."""
        return self.read("dissolved")

    @property
    def coldness(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Coldness, no unit, 0 as warm as the tea to 1 as cold as the milk was, float32 (z, y, x) with a value for each
        cell."""
        return self.read("coldness")

    def surface(self, parts: int = 2) -> Mesh:
        """The surface of the milk that has not dissolved, closed; parts: samples along a cell, 1 to 8.

        A Mesh: float32 (vertices, 3) positions in m and normals, uint32 (triangles, 3)."""
        return Mesh(*self.surface_arrays(parts))

    def cup(self) -> Dict[str, Mesh]:
        """The glass and the tea in it, where light crosses: "glass_air", "tea_glass", "tea_air".

        A Mesh each: float32 (vertices, 3) positions in m and normals, uint32 (triangles, 3)."""
        return {name: Mesh(*arrays) for name, arrays in self.cup_arrays().items()}

    def settings(self) -> Dict[str, Any]:
        """All numbers of the glass, as the format has them."""
        settings: Dict[str, Any] = json.loads(self.settings_json())
        return settings

    def __repr__(self) -> str:
        return f"<pastoso.Tea at {self.time_s:g} s>"


class Tank(_engine.Tank):
    """Liquid with a free surface in a glass tank.

    scene: a dictionary as docs/tank-format.md describes it ("format" and "version" may be left out), the path of such a
    file, or the name of a tank that comes along (tanks()). threads: how many compute, 0 for one per processor; the bits
    do not depend on it. folder: where relative paths of meshes start, of a dictionary.
    """

    def __init__(self, scene: Source, *, threads: int = 0, folder: PathLike = ".") -> None:
        text, name = source(scene, "tank", "pastoso-tank", 1)
        super().__init__(text=text, name=name, folder=os.fspath(folder), threads=threads)

    def advance(self, seconds: float) -> None:
        """advance_to() so much later than now."""
        self.advance_to(self.time_s + seconds)

    @property
    def level(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Signed distance from the surface, m, negative in the liquid, float32 (z, y, x), two points along a cell and a
        cell more on every side."""
        return self.read("level")

    @property
    def milk(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Share of milk in the liquid, 0 to 1, float32 (z, y, x) with a value for each cell."""
        return self.read("milk")

    def surface(self, parts: int = 2) -> Mesh:
        """The surface of the liquid, closed, cut where glass and solids begin; parts: samples along a cell, 1 to 4.

        A Mesh: float32 (vertices, 3) positions in m and normals, uint32 (triangles, 3)."""
        return Mesh(*self.surface_arrays(parts))

    def solids(self, parts: int = 3) -> Mesh:
        """The solids that stand in the tank; parts: samples along a cell, 1 to 8.

        A Mesh: float32 (vertices, 3) positions in m and normals, uint32 (triangles, 3)."""
        return Mesh(*self.solid_arrays(parts))

    def scene(self) -> Dict[str, Any]:
        """All of the scene, as the format has it."""
        scene: Dict[str, Any] = json.loads(self.scene_json())
        return scene

    def __repr__(self) -> str:
        return f"<pastoso.Tank at {self.time_s:g} s>"
