"""Functions of numbers and strings, and about data. Angles in degrees; positions in a string count from 1."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Array, Data, Type, Value
from trajopt_cli.rapid.data.scope import Absent, Place
from trajopt_cli.rapid.execution.arguments import Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.operators import string
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Boolean, Call, Expression, Name, Number, String
from trajopt_cli.units import DEG

_EXACT = 8388608  # 2^23
_BYTE, _LONG = 255, 2**52 - 1  # a dnum is exact to 52 bits
_NUMBERS = Topic("Functions of numbers to a number. Angles in degrees")


def _half_up(value: float) -> float:
    return math.copysign(math.floor(abs(value) + 0.5), value)


def _rounding(exact: Callable[[float], float]) -> Callable[..., float]:
    def compute(value: float, dec: int = 0) -> float:
        if not 0 <= dec <= 15:
            raise Refused(f"\\Dec:={dec} lies outside 0..15")
        return exact(value * 10.0**dec) / 10.0**dec

    return compute


@_NUMBERS.values(r"DnumToNum Value:num \Integer", NUM)
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
        _NUMBERS.values(f"{name}{suffix} {takes}", type_)(compute)
    for name, takes, of_bits in _OF_BITS:
        called, form = f"{name}{suffix}", " ".join(f"{one}:int" for one in takes.split())
        _NUMBERS.values(f"{called} {form}", type_)(_bits(called, of_bits, takes.split(), top))
    _NUMBERS.values(f"BitCheck{suffix} BitData:int BitPos:int", BOOL)(_bit_check(top))
_NUMBERS.values("Max Value1:num Value2:num", NUM)(max)
_NUMBERS.values("Min Value1:num Value2:num", NUM)(min)
_NUMBERS.values("NumToDnum Value:num", DNUM)(float)


_DIGITS_NUM, _DIGITS_DNUM = 6, 15  # significant digits that a controller writes
_STRINGS = Topic("Functions of strings. Positions in a string count from 1")


def _check(place: int, whole: str) -> None:
    """That a place lies in whole, counted from 1."""
    if not 1 <= place <= max(len(whole), 1):
        raise Refused(f"position {place} lies outside the string, 1..{len(whole)}", "ChPos", "ERR_ARGVALERR")


# ---------------------------------------------------------------------------------------------- values as strings


def _shown(type_: Type, data: Data) -> str:
    if isinstance(data, bool):
        return "TRUE" if data else "FALSE"
    if isinstance(data, tuple):
        return f"[{','.join(_shown(type_, value) for value in data)}]"
    if isinstance(data, float):
        return _figures(data, _DIGITS_DNUM if type_ == DNUM else _DIGITS_NUM)
    return f'"{data}"'


def _figures(value: float, digits: int) -> str:
    """A number as the controller writes it: no decimal point for whole ones, E+06 for the large."""
    text = f"{value + 0.0:.{digits}G}"
    return re.sub(r"E([+-])(\d)$", r"E\g<1>0\2", text)


@_STRINGS.function("ValToStr Val")
def _val_to_str(run: Context, node: Call, argument: Expression) -> Value:
    value = run.evaluate(argument)
    return Value(STRING, _shown(value.type, value.data))


def _num_to_str(value: float, digits: int, exp: bool = False) -> str:
    r"""The number with Dec decimals, rounded; \Exp in exponential form."""
    if not 0 <= digits <= 15:
        raise Refused(f"Dec {digits} lies outside 0..15", "Dec", "ERR_ARGVALERR")
    return f"{value:.{digits}{'E' if exp else 'f'}}"


for name in ("NumToStr", "DnumToStr"):
    _STRINGS.values(rf"{name} Val:num Dec:int \Exp", STRING)(_num_to_str)


@_STRINGS.function("StrToVal Str:string Val")
def _str_to_val(run: Context, node: Call, text: str, target: Expression) -> Value:
    """TRUE and Val changed if the string is a literal of Val's type, else FALSE and Val as it was."""
    place: Place = run.locate(target)
    try:
        literal = parse_expression(text, run.file)
        if not _literal(literal):
            return Value(BOOL, False)
        value = run.evaluate(literal, place.type)
    except InputError:  # not a literal of that type: that is the answer, not a mistake
        return Value(BOOL, False)
    run.assign(target, Value(value.type, value.data))
    return Value(BOOL, True)


def _literal(node: Expression) -> bool:
    if isinstance(node, Aggregate):
        return node.numbers is not None or all(_literal(item) for item in node.items)
    return isinstance(node, (Number, String, Boolean))


# ------------------------------------------------------------------------------------------------ parts and search

_STRINGS.values("StrLen Str:string", NUM)(len)


@_STRINGS.values("StrPart Str:string ChPos:int Len:int", STRING)
def _str_part(whole: str, start: int, length: int) -> str:
    if not (1 <= start <= len(whole) + 1 and 0 <= length <= len(whole) - start + 1):
        message = f"{length} characters from {start} lie outside the string, 1..{len(whole)}"
        raise Refused(message, error="ERR_ARGVALERR")
    return whole[start - 1 : start - 1 + length]


@_STRINGS.values(r"StrFind Str:string ChPos:int Set:string \NotInSet", NUM)
def _str_find(whole: str, start: int, wanted: str, notinset: bool = False) -> int:
    r"""Where the first character of Set (with \NotInSet: the first that is not in it) stands; length + 1 for none."""
    _check(start, whole)
    found = (i for i in range(start, len(whole) + 1) if (whole[i - 1] in wanted) is not notinset)
    return next(found, len(whole) + 1)


@_STRINGS.values("StrMatch Str:string ChPos:int Pattern:string", NUM)
def _str_match(whole: str, start: int, pattern: str) -> int:
    """Where the pattern begins; length + 1 where it does not occur."""
    _check(start, whole)
    found = whole.find(pattern, start - 1)
    return found + 1 if found >= 0 else len(whole) + 1


@_STRINGS.values("StrMemb Str:string ChPos:int Set:string", BOOL)
def _str_memb(whole: str, place: int, wanted: str) -> bool:
    _check(place, whole)
    return whole != "" and whole[place - 1] in wanted


@_STRINGS.values("StrOrder Str1:string Str2:string Order:string", BOOL)
def _str_order(first: str, second: str, order: str) -> bool:
    """Whether Str1 stands before Str2, or is the same, when characters are ordered as in Order."""

    def rank(text: str) -> list[int]:
        # Characters that Order does not name come behind all it does, by their code.
        return [order.index(char) if char in order else len(order) + ord(char) for char in text]

    return rank(first) <= rank(second)


@_STRINGS.values("StrMap Str:string FromMap:string ToMap:string", STRING)
def _str_map(text: str, old: str, new: str) -> str:
    if len(old) != len(new):
        message = f"FromMap has {len(old)} characters and ToMap {len(new)}; they stand for each other one by one"
        raise Refused(message, error="ERR_ARGVALERR")
    return text.translate({ord(a): b for a, b in reversed([*zip(old, new, strict=True)])})  # the first of two counts


# --------------------------------------------------------------------------------------------------------- numerals


_BASES = {"hex": (16, "02X"), "okt": (8, "03o"), "bin": (2, "08b")}


@_STRINGS.values(r"ByteToStr BitData:int \Hex \Okt \Bin \Char", STRING)
def _byte_to_str(value: int, **form: bool) -> str:
    if not 0 <= value <= 255:
        raise Refused(f"BitData {value} lies outside a byte's 0..255", error="ERR_ARGVALERR")
    return chr(value) if "char" in form else f"{value:{next((_BASES[name][1] for name in form), 'd')}}"


@_STRINGS.values(r"StrToByte ConStr:string \Hex \Okt \Bin \Char", NUM)
def _str_to_byte(text: str, **form: bool) -> int:
    if "char" in form:
        value = ord(text) if len(text) == 1 else -1
    else:
        value = _numeral(text, next((_BASES[name][0] for name in form), 10))
    if not 0 <= value <= 255:
        raise Refused(f'StrToByte: "{text}" is not a byte from 0 to 255', error="ERR_ARGVALERR")
    return value


def _numeral(text: str, base: int) -> int:
    digits = "0123456789abcdef"[:base]
    plain = text.strip().lower()
    return int(plain, base) if plain and set(plain) <= set(digits) else -1


def _recoded(text: str, name: str, base: int, form: str) -> str:
    value = _numeral(text, base)
    if value < 0:
        raise Refused(f'{name}: "{text}" is not a whole number in base {base}', error="ERR_ARGVALERR")
    return f"{value:{form}}"


_STRINGS.values("DecToHex Str:string", STRING)(lambda text: _recoded(text, "DecToHex", 10, "X"))
_STRINGS.values("HexToDec Str:string", STRING)(lambda text: _recoded(text, "HexToDec", 16, "d"))


_DATA = Topic("Functions about data")


@_DATA.function("Dim ArrPar DimNo:int")
def _dim(run: Context, node: Call, array: Expression, index: int) -> Value:
    value = run.evaluate(array)
    if not isinstance(value.type, Array) or not 1 <= index <= value.type.dimensions:
        raise Refused(f"{run.text(array)} has no dimension {index}", error="ERR_ILLDIM")
    data = value.data
    for _ in range(index - 1):
        data = data[0]
    return Value(NUM, float(len(data) if value.type.sizes is None else value.type.sizes[index - 1]))


@_DATA.function("Present OptPar")
def _present(run: Context, node: Call, argument: Expression) -> Value:
    if not isinstance(argument, Name):
        raise Refused("Present takes the name of an optional parameter", "OptPar")
    return Value(BOOL, not isinstance(run.find(argument.name), Absent))


_DATA.values("IsPers DatObj:place", BOOL)(lambda place: place.storage == "PERS")
_DATA.values("IsVar DatObj:place", BOOL)(lambda place: place.storage == "VAR")


@_DATA.function("ArgName Parameter")
def _arg_name(run: Context, node: Call, argument: Expression) -> Value:
    """How the caller, or the caller's caller, wrote the argument that a parameter stands for."""
    name = run.argument_name(argument.name) if isinstance(argument, Name) else None
    if name is None:
        raise Refused(f"{run.text(argument)} is not a parameter of the routine", "Parameter", "ERR_ARGNAME")
    return string(run, node, name)


@_DATA.values("Type Data:place", STRING)
def _type(place: Place) -> str:
    return place.type.element.name if isinstance(place.type, Array) else place.type.name
