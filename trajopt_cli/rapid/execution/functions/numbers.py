"""Functions of numbers to a number. Angles in degrees."""

from __future__ import annotations

import math
from collections.abc import Callable

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, Type, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.syntax import Call
from trajopt_cli.units import DEG


def _plain(name: str, compute: Callable[..., float], takes: str = "Value", result: Type = NUM) -> Function:
    """A function of numbers to a number of the type result. takes: the names of its arguments."""
    required = tuple(takes.split())

    def handler(run: Context, node: Call) -> Value:
        values = [run.number(argument) for argument in bind(run, node, required).required]
        try:
            value = compute(*values)
        except (ValueError, OverflowError, ZeroDivisionError) as error:
            shown = ", ".join(f"{value:.6g}" for value in values)
            raise run.error(node, f"{name}({shown}) is not defined: {error}") from error
        return Value(result, float(value))

    return handler


def _rounding(exact: Callable[[float], float], result: Type = NUM) -> Function:
    def handler(run: Context, node: Call) -> Value:
        args = bind(run, node, ("Val",), ("Dec",))
        dec = args.value("dec")
        digits = run.integer(dec, "\\Dec") if dec is not None else 0
        if not 0 <= digits <= 15:
            raise run.error(node, f"\\Dec:={digits} lies outside 0..15")
        return Value(result, exact(run.number(args.required[0]) * 10.0**digits) / 10.0**digits)

    return handler


def _half_up(value: float) -> float:
    return math.copysign(math.floor(abs(value) + 0.5), value)


def _dnum_to_num(run: Context, node: Call) -> Value:
    r"""The dnum as a num; with \Integer only if it is a whole number that a num holds exactly."""
    args = bind(run, node, ("Value",), ("Integer",))
    value = run.number(args.required[0])
    if "integer" in args.optional and (value != math.trunc(value) or abs(value) > _EXACT):
        raise run.fault(node, "ERR_ARGVALERR", f"DnumToNum({value:.15g} \\Integer) takes whole numbers up to {_EXACT}")
    return Value(NUM, value)


_EXACT = 8388608  # 2^23


# ----------------------------------------------------------------------------------------------------------- bits


def _bits(name: str, compute: Callable[..., int], takes: str, top: int, result: Type) -> Function:
    """A function of whole numbers 0..top, the contents of a byte (or of 52 bits), to one of them."""
    required = tuple(takes.split())

    def handler(run: Context, node: Call) -> Value:
        values = []
        for argument in bind(run, node, required).required:
            value = run.integer(argument, f"an argument of {name}")
            if not 0 <= value <= top:
                raise run.error(argument, f"an argument of {name} is {value}, and must lie in 0..{top}")
            values.append(value)
        return Value(result, float(compute(*values) & top))

    return handler


_BYTE, _LONG = 255, 2**52 - 1  # a dnum is exact to 52 bits


def _bit_check(top: int) -> Function:
    def handler(run: Context, node: Call) -> Value:
        data, place = bind(run, node, ("BitData", "BitPos")).required
        value, position = run.integer(data, "BitData"), run.integer(place, "BitPos")
        if not 0 <= value <= top:
            raise run.error(data, f"BitData is {value}, and must lie in 0..{top}")
        if not 1 <= position <= top.bit_length():
            raise run.error(place, f"BitPos {position} lies outside 1..{top.bit_length()}")
        return Value(BOOL, bool(value >> (position - 1) & 1))

    return handler


def _sin(a: float) -> float:
    return math.sin(a * DEG)


def _cos(a: float) -> float:
    return math.cos(a * DEG)


def _tan(a: float) -> float:
    return math.tan(a * DEG)


def _atan2(y: float, x: float) -> float:
    return math.atan2(y, x) / DEG


# Of num and, with Dnum behind the name, of dnum.
_OF_BOTH: dict[str, tuple[Callable[..., float], str]] = {
    "Abs": (abs, "Value"),
    "Sqrt": (math.sqrt, "Value"),
    "Pow": (math.pow, "Base Exponent"),
    "Exp": (math.exp, "Exponent"),
    "Sin": (_sin, "Angle"),
    "Cos": (_cos, "Angle"),
    "Tan": (_tan, "Angle"),
    "ASin": (lambda a: math.asin(a) / DEG, "Value"),
    "ACos": (lambda a: math.acos(a) / DEG, "Value"),
    "ATan": (lambda a: math.atan(a) / DEG, "Value"),
    "ATan2": (_atan2, "Y X"),
}
_OF_BITS: dict[str, tuple[Callable[..., int], str]] = {
    "And": (lambda a, b: a & b, "BitData1 BitData2"),
    "Or": (lambda a, b: a | b, "BitData1 BitData2"),
    "XOr": (lambda a, b: a ^ b, "BitData1 BitData2"),
    "Neg": (lambda a: ~a, "BitData"),
    "LSh": (lambda a, n: a << min(n, 52), "BitData ShiftSteps"),
    "RSh": (lambda a, n: a >> n, "BitData ShiftSteps"),
}


FUNCTIONS: dict[str, Function] = {
    **{name: _plain(name, compute, takes) for name, (compute, takes) in _OF_BOTH.items()},
    **{f"{name}Dnum": _plain(f"{name}Dnum", compute, takes, DNUM) for name, (compute, takes) in _OF_BOTH.items()},
    "Max": _plain("Max", max, "Value1 Value2"),
    "Min": _plain("Min", min, "Value1 Value2"),
    "Round": _rounding(_half_up),
    "RoundDnum": _rounding(_half_up, DNUM),
    "Trunc": _rounding(lambda value: float(math.trunc(value))),
    "TruncDnum": _rounding(lambda value: float(math.trunc(value)), DNUM),
    "NumToDnum": _plain("NumToDnum", float, result=DNUM),
    "DnumToNum": _dnum_to_num,
    **{f"Bit{name}": _bits(f"Bit{name}", compute, takes, _BYTE, NUM) for name, (compute, takes) in _OF_BITS.items()},
    **{
        f"Bit{name}Dnum": _bits(f"Bit{name}Dnum", compute, takes, _LONG, DNUM)
        for name, (compute, takes) in _OF_BITS.items()
    },
    "BitCheck": _bit_check(_BYTE),
    "BitCheckDnum": _bit_check(_LONG),
}
