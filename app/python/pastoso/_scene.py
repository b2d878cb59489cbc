"""What is given as dictionaries, as the engine reads it: JSON, and arrays beside it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from ._engine import InputError

PathLike = Union[str, "os.PathLike[str]"]
Source = Union[Mapping[str, Any], PathLike]
SceneArray = Tuple[bool, int, "np.ndarray[Any, np.dtype[np.float32]]"]


def _plain(value: Any) -> Any:
    """Numbers and arrays of NumPy as those of JSON."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"{type(value).__name__} has no place in JSON")


def json_text(value: Any, name: str) -> str:
    """JSON of a dictionary; an InputError that begins with `name` for what JSON has no form of, nan among it."""
    try:
        return json.dumps(value, default=_plain, allow_nan=False)
    except TypeError as error:
        raise InputError(f"{name}: {error}.") from None
    except ValueError:
        raise InputError(f"{name}: one of its numbers is nan or infinite, or it holds itself.") from None


def source(given: Source, name: str, format_name: str, version: int) -> Tuple[Optional[str], str]:
    """The JSON text of a dictionary and what it is called; or no text, and the path or name that was given."""
    if not isinstance(given, Mapping):
        return None, os.fspath(given)
    return json_text({"format": format_name, "version": version, **given}, name), name


def _floats(values: Any) -> "np.ndarray[Any, np.dtype[np.float32]]":
    """The array itself where it is float32, row by row; a converted copy otherwise."""
    return np.ascontiguousarray(values, dtype=np.float32)


def _is_array(entry: Any) -> bool:
    return isinstance(entry, Mapping) and entry.get("kind") == "array"


def _take(entry: Mapping[str, Any], key: str, place: str) -> Tuple[Dict[str, Any], Any]:
    """An entry without its array, and the array."""
    if key not in entry:
        raise InputError(f'scene, {place}: the entry "{key}" is missing.')
    return {name: value for name, value in entry.items() if name not in (key, "kind")}, entry[key]


def split_arrays(scene: Mapping[str, Any]) -> Tuple[Dict[str, Any], List[SceneArray]]:
    """Arrays of a scene apart from it: what stands in their places holds all else that their entries say."""
    unit = "cells" if scene.get("cell_units") else "mm"
    result, arrays = dict(scene), []  # type: Dict[str, Any], List[SceneArray]
    forms = scene.get("film")
    if isinstance(forms, (list, tuple)) and any(map(_is_array, forms)):
        result["film"] = list(forms)
        for place, form in enumerate(forms):
            if _is_array(form):
                others, values = _take(form, f"thickness_{unit}", f"film[{place}]")
                result["film"][place] = {**others, "kind": "slab", f"thickness_{unit}": 1.0}
                arrays.append((False, place, _floats(values)))
    support = scene.get("support")
    reliefs = list(support) if isinstance(support, (list, tuple)) else [support]
    if any(map(_is_array, reliefs)):
        result["support"], made = list(reliefs), 0
        for place, relief in enumerate(reliefs):
            if _is_array(relief):
                others, values = _take(relief, f"height_{unit}", f"support[{place}]")
                result["support"][place] = {**others, "kind": "ramp", "slope": 0.0}
                arrays.append((True, made, _floats(values)))
            is_flat = relief == "flat" or (isinstance(relief, Mapping) and relief.get("kind") == "flat")
            made += 0 if is_flat else 1
    if arrays and "runs" in scene:
        raise InputError('scene, runs: arrays stand in scenes of a single run; make a film of each.')
    return result, arrays
