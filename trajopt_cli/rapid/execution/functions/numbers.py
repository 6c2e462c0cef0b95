"""Functions of numbers to a number. Angles in degrees."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import integer, number
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.units import DEG

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _plain(name: str, compute: Callable[..., float], count: int = 1) -> Function:
    """A function of numbers to a number."""

    def handler(run: Run, node: Call) -> Value:
        required = tuple(f"Value{i}" for i in range(1, count + 1)) if count > 1 else ("Value",)
        values = [number(run, argument) for argument in bind(run, node, required).required]
        try:
            result = compute(*values)
        except (ValueError, OverflowError, ZeroDivisionError) as error:
            shown = ", ".join(f"{value:.6g}" for value in values)
            raise run.error(node, f"{name}({shown}) is not defined: {error}") from error
        return Value(NUM, float(result))

    return handler


def _rounding(exact: Callable[[float], float]) -> Function:
    def handler(run: Run, node: Call) -> Value:
        args = bind(run, node, ("Value",), ("Dec",))
        dec = args.value("dec")
        digits = integer(run, dec, "\\Dec") if dec is not None else 0
        if not 0 <= digits <= 15:
            raise run.error(node, f"\\Dec:={digits} lies outside 0..15")
        return Value(NUM, exact(number(run, args.required[0]) * 10.0**digits) / 10.0**digits)

    return handler


def _half_up(value: float) -> float:
    return math.copysign(math.floor(abs(value) + 0.5), value)


FUNCTIONS: dict[str, Function] = {
    "Abs": _plain("Abs", abs),
    "Sqrt": _plain("Sqrt", math.sqrt),
    "Exp": _plain("Exp", math.exp),
    "Pow": _plain("Pow", math.pow, 2),
    "Sin": _plain("Sin", lambda a: math.sin(a * DEG)),
    "Cos": _plain("Cos", lambda a: math.cos(a * DEG)),
    "Tan": _plain("Tan", lambda a: math.tan(a * DEG)),
    "ASin": _plain("ASin", lambda a: math.asin(a) / DEG),
    "ACos": _plain("ACos", lambda a: math.acos(a) / DEG),
    "ATan": _plain("ATan", lambda a: math.atan(a) / DEG),
    "ATan2": _plain("ATan2", lambda y, x: math.atan2(y, x) / DEG, 2),
    "Round": _rounding(_half_up),
    "Trunc": _rounding(lambda value: float(math.trunc(value))),
}
