"""Functions of strings. Positions in a string count from 1."""

from __future__ import annotations

import re

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.data.scope import Place
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.registry import Refused, Topic
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Boolean, Call, Expression, Number, String

_DIGITS_NUM, _DIGITS_DNUM = 6, 15  # significant digits that a controller writes
_TOPIC = Topic(__doc__)


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


@_TOPIC.function("ValToStr Val")
def _val_to_str(run: Context, node: Call, argument: Expression) -> Value:
    value = run.evaluate(argument)
    return Value(STRING, _shown(value.type, value.data))


def _num_to_str(value: float, digits: int, exp: bool = False) -> str:
    r"""The number with Dec decimals, rounded; \Exp in exponential form."""
    if not 0 <= digits <= 15:
        raise Refused(f"Dec {digits} lies outside 0..15", "Dec", "ERR_ARGVALERR")
    return f"{value:.{digits}{'E' if exp else 'f'}}"


for name in ("NumToStr", "DnumToStr"):
    _TOPIC.values(rf"{name} Val:num Dec:int \Exp", STRING)(_num_to_str)


@_TOPIC.function("StrToVal Str:string Val")
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

_TOPIC.values("StrLen Str:string", NUM)(len)


@_TOPIC.values("StrPart Str:string ChPos:int Len:int", STRING)
def _str_part(whole: str, start: int, length: int) -> str:
    if not (1 <= start <= len(whole) + 1 and 0 <= length <= len(whole) - start + 1):
        message = f"{length} characters from {start} lie outside the string, 1..{len(whole)}"
        raise Refused(message, error="ERR_ARGVALERR")
    return whole[start - 1 : start - 1 + length]


@_TOPIC.values(r"StrFind Str:string ChPos:int Set:string \NotInSet", NUM)
def _str_find(whole: str, start: int, wanted: str, notinset: bool = False) -> int:
    r"""Where the first character of Set (with \NotInSet: the first that is not in it) stands; length + 1 for none."""
    _check(start, whole)
    found = (i for i in range(start, len(whole) + 1) if (whole[i - 1] in wanted) is not notinset)
    return next(found, len(whole) + 1)


@_TOPIC.values("StrMatch Str:string ChPos:int Pattern:string", NUM)
def _str_match(whole: str, start: int, pattern: str) -> int:
    """Where the pattern begins; length + 1 where it does not occur."""
    _check(start, whole)
    found = whole.find(pattern, start - 1)
    return found + 1 if found >= 0 else len(whole) + 1


@_TOPIC.values("StrMemb Str:string ChPos:int Set:string", BOOL)
def _str_memb(whole: str, place: int, wanted: str) -> bool:
    _check(place, whole)
    return whole != "" and whole[place - 1] in wanted


@_TOPIC.values("StrOrder Str1:string Str2:string Order:string", BOOL)
def _str_order(first: str, second: str, order: str) -> bool:
    """Whether Str1 stands before Str2, or is the same, when characters are ordered as in Order."""

    def rank(text: str) -> list[int]:
        # Characters that Order does not name come behind all it does, by their code.
        return [order.index(char) if char in order else len(order) + ord(char) for char in text]

    return rank(first) <= rank(second)


@_TOPIC.values("StrMap Str:string FromMap:string ToMap:string", STRING)
def _str_map(text: str, old: str, new: str) -> str:
    if len(old) != len(new):
        message = f"FromMap has {len(old)} characters and ToMap {len(new)}; they stand for each other one by one"
        raise Refused(message, error="ERR_ARGVALERR")
    return text.translate({ord(a): b for a, b in reversed([*zip(old, new, strict=True)])})  # the first of two counts


# --------------------------------------------------------------------------------------------------------- numerals


_BASES = {"hex": (16, "02X"), "okt": (8, "03o"), "bin": (2, "08b")}


@_TOPIC.values(r"ByteToStr BitData:int \Hex \Okt \Bin \Char", STRING)
def _byte_to_str(value: int, **form: bool) -> str:
    if not 0 <= value <= 255:
        raise Refused(f"BitData {value} lies outside a byte's 0..255", error="ERR_ARGVALERR")
    return chr(value) if "char" in form else f"{value:{next((_BASES[name][1] for name in form), 'd')}}"


@_TOPIC.values(r"StrToByte ConStr:string \Hex \Okt \Bin \Char", NUM)
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


_TOPIC.values("DecToHex Str:string", STRING)(lambda text: _recoded(text, "DecToHex", 10, "X"))
_TOPIC.values("HexToDec Str:string", STRING)(lambda text: _recoded(text, "HexToDec", 16, "d"))
