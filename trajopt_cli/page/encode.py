"""Numbers and text as a page carries them: blocks of float32, JSON that no text can break out of, escaped HTML."""

from __future__ import annotations

import html
import json
from base64 import b64encode
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

_SINGLE = np.dtype("<f4")


def block(values: ArrayLike) -> dict[str, Any]:
    """An array as {"f32": base64 of little-endian float32 in C order, "shape": [...]}; TrajoptPage.decode reads it.

    24 bits: a time within a minute is off by at most 2 µs. Raises ValueError for numbers that are not finite.
    """
    array = np.asarray(values, dtype=np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"block: {np.count_nonzero(~np.isfinite(array))} of {array.size} numbers are not finite")
    return {"f32": b64encode(np.ascontiguousarray(array, _SINGLE).tobytes()).decode(), "shape": list(array.shape)}


def embedded(data: Mapping[str, Any]) -> str:
    """JSON for a script element: ASCII, and without the sign that begins a tag. Raises ValueError for a number that is
    not finite."""
    return json.dumps(data, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")


def text(value: object) -> str:
    """Anything as HTML text, quotes included, so that it may stand in an attribute."""
    return html.escape(str(value), quote=True)
