"""Thick wet paint, and liquids in glass: the engine of Pastoso for Python.

    import pastoso

    painting = pastoso.Painting(120, 90)
    painting.take_brush("Flat bristle 20", size_mm=12)
    painting.load([("PB29", 1), ("PW6", 0.5)])
    painting.stroke([[0, 20, 45, 0.5], [0.5, 100, 45, 0.6]])
    painting.save("blue.png")

Film lets a scene of wet paint run without a brush, Painting paints, Tea and Tank hold liquids. Lengths of paint are in
millimetres, those of liquids in metres, times in seconds, angles in degrees. What is wrong with something that is given
is told by an InputError, in one sentence. The same calls give the same bits, on any number of threads, and the same as
`pastoso-cli` gives.
"""

from __future__ import annotations

from pathlib import Path as _Path

from . import _engine
from ._engine import InputError, InternalError
from ._engine import brushes, lights, media, pigments, scenes, supports, tanks, teas
from ._engine import validate, validation_cases

# The package of Python alone brings data and module along; installed with the programs it uses theirs.
_folder = _Path(__file__).parent
_engine.set_installed_prefix(str(_folder if (_folder / "share").is_dir() else _folder.parents[3]))

from ._film import Film, scene_runs  # noqa: E402
from ._liquids import Mesh, Tank, Tea  # noqa: E402
from ._painting import Painting  # noqa: E402

__version__: str = _engine.version
__all__ = [
    "Film", "InputError", "InternalError", "Mesh", "Painting", "Tank", "Tea", "brushes", "lights", "media", "pigments",
    "scene_runs", "scenes", "supports", "tanks", "teas", "validate",
    "validation_cases",
]
