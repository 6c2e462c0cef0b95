"""Factors from the units of RAPID, cell files and reports to SI: value_in_si = value * FACTOR. Numbers in texts."""

from __future__ import annotations

from math import pi

MM = 1e-3
DEG = pi / 180.0


def unit_of(axis: str) -> tuple[float, str]:
    """SI per shown unit, and the unit's sign, of an axis by name."""
    return (MM, "mm") if slides(axis) else (DEG, "deg")


def slides(axis: str) -> bool:
    """Whether an axis, by name, is a rail ("rail", "rail_a" of several) or one of a positioner that slides: in m, all
    others in rad."""
    return axis == "rail" or axis.startswith("rail_") or (axis.startswith("eax_") and axis.endswith("_slide"))


def decimal(text: str) -> float:
    """The number that a text spells as files do: float() also takes 1_0 and the digits of other scripts.

    Raises ValueError, as float() does.
    """
    if "_" in text or not text.isascii():
        raise ValueError(f"could not convert string to float: {text!r}")
    return float(text)
