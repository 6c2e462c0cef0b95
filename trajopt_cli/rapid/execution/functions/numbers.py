"""Functions of numbers to a number. Angles in degrees."""

from __future__ import annotations

import math
from collections.abc import Callable

from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM
from trajopt_cli.rapid.execution.registry import Refused, Topic
from trajopt_cli.units import DEG

_EXACT = 8388608  # 2^23
_BYTE, _LONG = 255, 2**52 - 1  # a dnum is exact to 52 bits
_TOPIC = Topic(__doc__)


def _half_up(value: float) -> float:
    return math.copysign(math.floor(abs(value) + 0.5), value)


def _rounding(exact: Callable[[float], float]) -> Callable[..., float]:
    def compute(value: float, dec: int = 0) -> float:
        if not 0 <= dec <= 15:
            raise Refused(f"\\Dec:={dec} lies outside 0..15")
        return exact(value * 10.0**dec) / 10.0**dec

    return compute


@_TOPIC.values(r"DnumToNum Value:num \Integer", NUM)
def _dnum_to_num(value: float, integer: bool = False) -> float:
    r"""The dnum as a num; with \Integer only if it is a whole number that a num holds exactly."""
    if integer and (value != math.trunc(value) or abs(value) > _EXACT):
        message = f"DnumToNum({value:.15g} \\Integer) takes whole numbers up to {_EXACT}"
        raise Refused(message, error="ERR_ARGVALERR")
    return value


def _bits(name: str, compute: Callable[..., int], takes: list[str], top: int) -> Callable[..., int]:
    """A function of whole numbers 0..top, the contents of a byte (or of 52 bits), to one of them."""

    def checked(*values: int) -> int:
        for at, value in zip(takes, values, strict=True):
            if not 0 <= value <= top:
                raise Refused(f"an argument of {name} is {value}, and must lie in 0..{top}", at)
        return compute(*values) & top

    return checked


def _bit_check(top: int) -> Callable[[int, int], bool]:
    def compute(value: int, position: int) -> bool:
        if not 0 <= value <= top:
            raise Refused(f"BitData is {value}, and must lie in 0..{top}", "BitData")
        if not 1 <= position <= top.bit_length():
            raise Refused(f"BitPos {position} lies outside 1..{top.bit_length()}", "BitPos")
        return bool(value >> (position - 1) & 1)

    return compute


# Of num and, with Dnum behind the name, of dnum: name, arguments, value.
_OF_BOTH: tuple[tuple[str, str, Callable[..., float]], ...] = (
    ("Abs", "Value:num", abs),
    ("Sqrt", "Value:num", math.sqrt),
    ("Pow", "Base:num Exponent:num", math.pow),
    ("Exp", "Exponent:num", math.exp),
    ("Sin", "Angle:num", lambda a: math.sin(a * DEG)),
    ("Cos", "Angle:num", lambda a: math.cos(a * DEG)),
    ("Tan", "Angle:num", lambda a: math.tan(a * DEG)),
    ("ASin", "Value:num", lambda a: math.asin(a) / DEG),
    ("ACos", "Value:num", lambda a: math.acos(a) / DEG),
    ("ATan", "Value:num", lambda a: math.atan(a) / DEG),
    ("ATan2", "Y:num X:num", lambda y, x: math.atan2(y, x) / DEG),
    ("Round", r"Val:num \Dec:int", _rounding(_half_up)),
    ("Trunc", r"Val:num \Dec:int", _rounding(math.trunc)),
)
_OF_BITS: tuple[tuple[str, str, Callable[..., int]], ...] = (
    ("BitAnd", "BitData1 BitData2", lambda a, b: a & b),
    ("BitOr", "BitData1 BitData2", lambda a, b: a | b),
    ("BitXOr", "BitData1 BitData2", lambda a, b: a ^ b),
    ("BitNeg", "BitData", lambda a: ~a),
    ("BitLSh", "BitData ShiftSteps", lambda a, n: a << min(n, 52)),
    ("BitRSh", "BitData ShiftSteps", lambda a, n: a >> n),
)
for suffix, type_, top in (("", NUM, _BYTE), ("Dnum", DNUM, _LONG)):
    for name, takes, compute in _OF_BOTH:
        _TOPIC.values(f"{name}{suffix} {takes}", type_)(compute)
    for name, takes, of_bits in _OF_BITS:
        called, form = f"{name}{suffix}", " ".join(f"{one}:int" for one in takes.split())
        _TOPIC.values(f"{called} {form}", type_)(_bits(called, of_bits, takes.split(), top))
    _TOPIC.values(f"BitCheck{suffix} BitData:int BitPos:int", BOOL)(_bit_check(top))
_TOPIC.values("Max Value1:num Value2:num", NUM)(max)
_TOPIC.values("Min Value1:num Value2:num", NUM)(min)
_TOPIC.values("NumToDnum Value:num", DNUM)(float)
