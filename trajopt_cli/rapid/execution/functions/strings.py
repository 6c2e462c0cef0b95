"""Functions of strings. Positions in a string count from 1."""

from __future__ import annotations

import re

from trajopt_cli.errors import InputError
from trajopt_cli.rapid.data.datatypes import BOOL, DNUM, NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.language.expressions import parse_expression
from trajopt_cli.rapid.language.syntax import Aggregate, Boolean, Call, Expression, Number, String

_DIGITS_NUM, _DIGITS_DNUM = 6, 15  # significant digits that a controller writes


def _string(run: Context, node: Expression) -> str:
    return str(run.evaluate(node, STRING).data)


def _place(run: Context, node: Expression, whole: str) -> int:
    """A position in whole, from 1."""
    place = run.integer(node, "ChPos")
    if not 1 <= place <= max(len(whole), 1):
        raise run.fault(node, "ERR_ARGVALERR", f"position {place} lies outside the string, 1..{len(whole)}")
    return place


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


def _val_to_str(run: Context, node: Call) -> Value:
    value = run.evaluate(bind(run, node, ("Val",)).required[0])
    return Value(STRING, _shown(value.type, value.data))


def _num_to_str(run: Context, node: Call) -> Value:
    r"""The number with Dec decimals, rounded; \Exp in exponential form."""
    args = bind(run, node, ("Val", "Dec"), ("Exp",))
    value, dec = args.required
    digits = run.integer(dec, "Dec")
    if not 0 <= digits <= 15:
        raise run.fault(dec, "ERR_ARGVALERR", f"Dec {digits} lies outside 0..15")
    return Value(STRING, f"{run.number(value):.{digits}{'E' if 'exp' in args.optional else 'f'}}")


def _str_to_val(run: Context, node: Call) -> Value:
    """TRUE and Val changed if the string is a literal of Val's type, else FALSE and Val as it was."""
    text, target = bind(run, node, ("Str", "Val")).required
    place = run.locate(target)
    try:
        literal = parse_expression(_string(run, text), run.file)
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


def _str_len(run: Context, node: Call) -> Value:
    (text,) = bind(run, node, ("Str",)).required
    return Value(NUM, float(len(_string(run, text))))


def _str_part(run: Context, node: Call) -> Value:
    text, first, count = bind(run, node, ("Str", "ChPos", "Len")).required
    whole = _string(run, text)
    start, length = run.integer(first, "ChPos"), run.integer(count, "Len")
    if not (1 <= start <= len(whole) + 1 and 0 <= length <= len(whole) - start + 1):
        message = f"{length} characters from {start} lie outside the string, 1..{len(whole)}"
        raise run.fault(node, "ERR_ARGVALERR", message)
    return Value(STRING, whole[start - 1 : start - 1 + length])


def _str_find(run: Context, node: Call) -> Value:
    r"""Where the first character of Set (with \NotInSet: the first that is not in it) stands; length + 1 for none."""
    args = bind(run, node, ("Str", "ChPos", "Set"), ("NotInSet",))
    text, first, chars = args.required
    whole, wanted = _string(run, text), _string(run, chars)
    outside = "notinset" in args.optional
    start = _place(run, first, whole)
    found = (i for i in range(start, len(whole) + 1) if (whole[i - 1] in wanted) != outside)
    return Value(NUM, float(next(found, len(whole) + 1)))


def _str_match(run: Context, node: Call) -> Value:
    """Where the pattern begins; length + 1 where it does not occur."""
    text, first, pattern = bind(run, node, ("Str", "ChPos", "Pattern")).required
    whole = _string(run, text)
    found = whole.find(_string(run, pattern), _place(run, first, whole) - 1)
    return Value(NUM, float(found + 1 if found >= 0 else len(whole) + 1))


def _str_memb(run: Context, node: Call) -> Value:
    text, first, chars = bind(run, node, ("Str", "ChPos", "Set")).required
    whole = _string(run, text)
    place = _place(run, first, whole)
    return Value(BOOL, whole[place - 1 : place] != "" and whole[place - 1] in _string(run, chars))


def _str_order(run: Context, node: Call) -> Value:
    """Whether Str1 stands before Str2, or is the same, when characters are ordered as in Order."""
    first, second, order = (_string(run, argument) for argument in bind(run, node, ("Str1", "Str2", "Order")).required)

    def rank(text: str) -> list[int]:
        # Characters that Order does not name come behind all it does, by their code.
        return [order.index(char) if char in order else len(order) + ord(char) for char in text]

    return Value(BOOL, rank(first) <= rank(second))


def _str_map(run: Context, node: Call) -> Value:
    text, old, new = (_string(run, argument) for argument in bind(run, node, ("Str", "FromMap", "ToMap")).required)
    if len(old) != len(new):
        message = f"FromMap has {len(old)} characters and ToMap {len(new)}; they stand for each other one by one"
        raise run.fault(node, "ERR_ARGVALERR", message)
    table = {a: b for a, b in reversed(list(zip(old, new, strict=True)))}  # the first of two counts
    return Value(STRING, "".join(table.get(char, char) for char in text))


# --------------------------------------------------------------------------------------------------------- numerals


_BASES = {"hex": (16, "02X"), "okt": (8, "03o"), "bin": (2, "08b")}


def _byte_to_str(run: Context, node: Call) -> Value:
    args = bind(run, node, ("BitData",), ("Hex", "Okt", "Bin", "Char"))
    value = run.integer(args.required[0], "BitData")
    if not 0 <= value <= 255:
        raise run.fault(node, "ERR_ARGVALERR", f"BitData {value} lies outside a byte's 0..255")
    if "char" in args.optional:
        return Value(STRING, chr(value))
    form = next((_BASES[name][1] for name in args.optional), "d")
    return Value(STRING, f"{value:{form}}")


def _str_to_byte(run: Context, node: Call) -> Value:
    args = bind(run, node, ("ConStr",), ("Hex", "Okt", "Bin", "Char"))
    text = _string(run, args.required[0])
    if "char" in args.optional:
        value = ord(text) if len(text) == 1 else -1
    else:
        value = _numeral(text, next((_BASES[name][0] for name in args.optional), 10))
    if not 0 <= value <= 255:
        raise run.fault(node, "ERR_ARGVALERR", f'StrToByte: "{text}" is not a byte from 0 to 255')
    return Value(NUM, float(value))


def _numeral(text: str, base: int) -> int:
    digits = "0123456789abcdef"[:base]
    plain = text.strip().lower()
    return int(plain, base) if plain and set(plain) <= set(digits) else -1


def _recoded(name: str, base: int, form: str) -> Function:
    def handler(run: Context, node: Call) -> Value:
        text = _string(run, bind(run, node, ("Str",)).required[0])
        value = _numeral(text, base)
        if value < 0:
            raise run.fault(node, "ERR_ARGVALERR", f'{name}: "{text}" is not a whole number in base {base}')
        return Value(STRING, f"{value:{form}}")

    return handler


FUNCTIONS: dict[str, Function] = {
    "ValToStr": _val_to_str,
    "NumToStr": _num_to_str,
    "DnumToStr": _num_to_str,
    "StrToVal": _str_to_val,
    "StrLen": _str_len,
    "StrPart": _str_part,
    "StrFind": _str_find,
    "StrMatch": _str_match,
    "StrMemb": _str_memb,
    "StrOrder": _str_order,
    "StrMap": _str_map,
    "ByteToStr": _byte_to_str,
    "StrToByte": _str_to_byte,
    "DecToHex": _recoded("DecToHex", 10, "X"),
    "HexToDec": _recoded("HexToDec", 16, "d"),
}
