"""Paintings: a canvas, brushes and paint."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from . import _engine
from ._scene import PathLike, Source, json_text, source

Paint = Union[str, Sequence[Tuple[str, float]], Mapping[str, Any], None]
_FORMAT = ("recording", "pastoso-strokes", 11)


def _recipe(paint: Paint) -> Mapping[str, Any]:
    if paint is None:
        return {"mix": []}
    if isinstance(paint, Mapping):
        return paint
    if isinstance(paint, str):
        return {"mix": [[paint, 1]]}
    return {"mix": [list(part) for part in paint]}


class Painting(_engine.Painting):
    """A canvas with wet paint, and what is in hand.

    width_mm, height_mm: 1 to 5000 mm; px_per_mm: cells per millimetre, 0.25 to 64.
    support: one of supports(), or "image" with support_image, the path of a height image; support_relief_mm: its height,
    0 for its own. threads: how many compute, 0 for one per processor; the bits do not depend on it.

    Paints are named by pigments() ("PB29") or as colours of sRGB ("#c03020"); a mixture is a list of them with parts by
    volume, [("PB29", 1), ("PW6", 0.5)], a dictionary {"mix": [...], "strength": 0.8} thins it with clear medium, and None
    is the medium alone.

    Everything that is done is recorded: save("strokes.json") writes what `pastoso-cli replay` paints again, to the same
    bits. Raises InputError for whatever there is not, and for what is out of its range; the painting is then as it was.
    """

    def __init__(self, width_mm: float = 300.0, height_mm: float = 200.0, px_per_mm: float = 4.0,
                 support: str = "linen", *, support_image: PathLike = "", support_relief_mm: float = 0.0,
                 threads: int = 0) -> None:
        canvas: Dict[str, Any] = {"width_mm": width_mm, "height_mm": height_mm, "px_per_mm": px_per_mm,
                                  "support": support, "support_relief_mm": support_relief_mm}
        if support_image:
            canvas["support_image"] = os.path.abspath(support_image)
        text, _ = source({"canvas": canvas, "end_tick": 0, "events": []}, *_FORMAT)
        super().__init__(text=text, name="canvas", folder="", threads=threads)

    @classmethod
    def open(cls, path: PathLike, *, threads: int = 0) -> "Painting":
        """A painting that was saved, NAME.pastoso, with its wet paint; undo begins anew. See notes."""
        painting = cls.__new__(cls)
        _engine.Painting.__init__(painting, path=os.fspath(path), threads=threads)
        return painting

    @classmethod
    def replay(cls, recording: Source, *, threads: int = 0, folder: PathLike = ".") -> "Painting":
        """A recording painted from its beginning to its end: a path, or a dictionary as docs/stroke-format.md describes
        it, whose relative paths start at `folder`. The bits are those of `pastoso-cli replay`."""
        if isinstance(recording, Mapping):
            text, name = source(recording, *_FORMAT)
        else:
            name = os.fspath(recording)
            text = None
            folder = Path(name).parent
        painting = cls.__new__(cls)
        _engine.Painting.__init__(painting, text=text, name=name, folder=os.fspath(folder), threads=threads)
        return painting

    def apply(self, action: Mapping[str, Any]) -> None:
        """Does whatever recordings know, docs/stroke-format.md: {"set_symmetry": {"centre_x_mm": 60, ...}}."""
        self.apply_json(json_text(action, "action"))

    # What is in hand.

    def take_brush(self, preset: Union[str, Mapping[str, Any]], *, size_mm: float = 0.0, seed: int = 1) -> None:
        """Takes a clean tool: one of brushes(), or all of a preset; size_mm: the width of its tip, 0 for its own;
        seed: of its bristles."""
        self.apply({"take_brush": {"preset": preset, "size_mm": size_mm, "seed": seed}})

    def use_medium(self, name: str, *, paint_share: float = 1.0, **numbers: float) -> None:
        """What the next paint is mixed with: one of media(), thinned to paint_share by volume (0.02 to 1); numbers of
        one's own take the place of its own, viscosity_m2_s=0.01 and so on."""
        medium: Dict[str, Any] = {"name": name, "paint_share": paint_share}
        if numbers:
            medium["numbers"] = numbers
        self.apply({"use_medium": medium})

    def load(self, paint: Paint, *, fill: float = 1.0, second: Paint = None, second_share: float = 0.0,
             share_variation: float = 0.0, side_by_side: bool = False, tip_only: bool = False) -> None:
        """Dips the brush; fill: of what it can hold, 0 to 1.2. A second paint may be picked up with it: second_share,
        its mean share; share_variation, from bristle to bristle; side_by_side, one half of the tip in each."""
        load: Dict[str, Any] = {"paint": _recipe(paint), "fill": fill, "tip_only": tip_only}
        if second is not None:
            load.update(second=_recipe(second), second_share=second_share, share_variation=share_variation,
                        side_by_side=side_by_side)
        self.apply({"load_paint": load})

    def clean_brush(self, share: float = 1.0) -> None:
        """Wipes that share, 0 to 1, off every bristle."""
        self.apply({"clean_brush": {"share": share}})

    def squeeze(self, paint: Paint, volume_mm3: float, x_mm: float, y_mm: float) -> None:
        """Squeezes paint out of its tube onto the mixing well, which is 120 x 90 mm."""
        self.apply({"squeeze_paint": {"paint": _recipe(paint), "volume_mm3": volume_mm3, "x_mm": x_mm, "y_mm": y_mm}})

    # How paint flows and dries.

    def tilt(self, tilt_deg: float, direction_deg: float = 90.0) -> None:
        """Leans the canvas: 0 flat to 90 upright; direction_deg is where down points, 0 right, 90 to the lower edge."""
        self.apply({"tilt_canvas": {"tilt_deg": tilt_deg, "direction_deg": direction_deg}})

    def set_drying(self, speed: float, **fan: float) -> None:
        """Seconds of drying in a second of paint time, 0 to 1e5; a fan: fan=10, fan_x_mm, fan_y_mm, fan_radius_mm."""
        self.apply({"set_drying": {"speed": speed, **fan}})

    def dry_now(self) -> None:
        """All wet paint of the active layer becomes dry."""
        self.apply({"dry_now": {}})

    # What was done.

    def undo(self) -> None:
        """Takes the latest undo step back; nothing happens where there is none."""
        self.apply({"undo": {}})

    def redo(self) -> None:
        """Does again what undo() took back last."""
        self.apply({"redo": {}})

    def recording(self) -> Dict[str, Any]:
        """Everything that was done, as replay() takes it."""
        recording: Dict[str, Any] = json.loads(self.recording_json())
        return recording

    # Layers, by their numbers.

    def add_layer(self, name: str) -> int:
        """A bare layer above the active one, which becomes active. Returns its number."""
        self.apply({"add_layer": {"name": name}})
        return self.active_layer

    @property
    def active_layer(self) -> int:
        """The number of the layer that is painted on."""
        return next(layer["number"] for layer in self.layers() if layer["active"])

    def select_layer(self, number: int) -> None:
        """Makes a layer active: its wet paint flows, that of all others keeps still."""
        self.apply({"select_layer": {"layer": number}})

    def set_layer(self, number: int, **look: Any) -> None:
        """Changes name, visible, locked, bare_locked, clipped (to the layer below) or opacity (0 to 1) of a layer."""
        known: Dict[str, Any] = next((dict(layer) for layer in self.layers() if layer["number"] == number), {"name": ""})
        kept = {key: known[key] for key in ("name", "visible", "locked", "bare_locked", "clipped", "opacity") if key in known}
        self.apply({"set_layer": {"layer": number, **kept, **look}})

    def duplicate_layer(self, number: int) -> int:
        """A copy above it, of paint from the tubes, which becomes active. Returns its number."""
        self.apply({"duplicate_layer": {"layer": number}})
        return self.active_layer

    def remove_layer(self, number: int) -> None:
        """Removes a layer with its paint; the last one stays."""
        self.apply({"remove_layer": {"layer": number}})

    def merge_down(self, number: int) -> None:
        """Merges a layer onto the one below it."""
        self.apply({"merge_down": {"layer": number}})

    def flatten(self) -> None:
        """Merges all visible layers into the lowest of them."""
        self.apply({"flatten_layers": {}})

    # What is visible.

    @property
    def thickness(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Thickness of the wet paint, mm, float32 (height, width): a new array; read() fills one that there is."""
        return self.read("thickness")

    @property
    def support(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Height of what the wet paint lies on, dried paint included, mm, float32 (height, width)."""
        return self.read("support")

    @property
    def surface(self) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """Height of the painting's surface, mm, float32 (height, width)."""
        return self.read("surface")

    def __repr__(self) -> str:
        height, width = self.shape
        return f"<pastoso.Painting of {width} x {height} cells at {self.time_s:g} s>"
