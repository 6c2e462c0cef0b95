"""Functions of strings. Positions in a string count from 1."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trajopt_cli.rapid.data.datatypes import NUM, STRING, Data, Type, Value
from trajopt_cli.rapid.execution.arguments import Function, bind
from trajopt_cli.rapid.execution.evaluate import evaluate, integer, number
from trajopt_cli.rapid.language.syntax import Call

if TYPE_CHECKING:
    from trajopt_cli.rapid.execution.interpreter import Run


def _shown(type_: Type, data: Data) -> str:
    if isinstance(data, bool):
        return "TRUE" if data else "FALSE"
    if isinstance(data, tuple):
        return f"[{','.join(_shown(type_, value) for value in data)}]"
    return f"{data:.6g}" if isinstance(data, float) else f'"{data}"'


def _val_to_str(run: Run, node: Call) -> Value:
    value = evaluate(run, bind(run, node, ("Val",)).required[0])
    return Value(STRING, _shown(value.type, value.data))


def _num_to_str(run: Run, node: Call) -> Value:
    value, dec = bind(run, node, ("Val", "Dec")).required
    digits = integer(run, dec, "Dec")
    if not 0 <= digits <= 15:
        raise run.error(dec, f"Dec {digits} lies outside 0..15")
    return Value(STRING, f"{number(run, value):.{digits}f}")


def _str_len(run: Run, node: Call) -> Value:
    (text,) = bind(run, node, ("Str",)).required
    return Value(NUM, float(len(str(evaluate(run, text, STRING).data))))


def _str_part(run: Run, node: Call) -> Value:
    text, first, count = bind(run, node, ("Str", "ChPos", "Len")).required
    whole = str(evaluate(run, text, STRING).data)
    start, length = integer(run, first, "ChPos"), integer(run, count, "Len")
    if not (1 <= start <= len(whole) and 0 <= length <= len(whole) - start + 1):
        raise run.error(node, f"{length} characters from {start} lie outside the string's 1..{len(whole)}")
    return Value(STRING, whole[start - 1 : start - 1 + length])


FUNCTIONS: dict[str, Function] = {
    "ValToStr": _val_to_str,
    "NumToStr": _num_to_str,
    "StrLen": _str_len,
    "StrPart": _str_part,
}
