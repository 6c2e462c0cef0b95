"""Every supported function: one handler and one line in FUNCTIONS. Angles are in degrees, lengths in mm."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from trajopt_cli.rapid import frames
from trajopt_cli.rapid.arguments import bind
from trajopt_cli.rapid.datatypes import BOOL, NUM, ORIENT, POS, POSE, ROBTARGET, STRING, Array, Data, Type, Value
from trajopt_cli.rapid.evaluate import evaluate, integer, number
from trajopt_cli.rapid.scope import Absent
from trajopt_cli.rapid.syntax import Call, Expression, Name
from trajopt_cli.units import DEG

if TYPE_CHECKING:
    from trajopt_cli.rapid.interpreter import Run

Handler = Callable[["Run", Call], Value]


# --------------------------------------------------------------------------------------------------------- targets


def _offs(run: Run, node: Call) -> Value:
    """The target shifted along the axes of the work object; orientation, configuration, external axes kept."""
    point, *shifts = bind(run, node, ("Point", "XOffset", "YOffset", "ZOffset")).required
    (x, y, z), *rest = evaluate(run, point, ROBTARGET).data
    dx, dy, dz = (number(run, shift) for shift in shifts)
    return Value(ROBTARGET, ((x + dx, y + dy, z + dz), *rest))


def _rel_tool(run: Run, node: Call) -> Value:
    """The target shifted along its own tool axes, then turned about the new x, the new y and the new z."""
    args = bind(run, node, ("Point", "Dx", "Dy", "Dz"), ("Rx", "Ry", "Rz"))
    point, *shifts = args.required
    p, q, *rest = evaluate(run, point, ROBTARGET).data
    if frames.norm(q) == 0:
        raise run.error(point, f"{run.text(point)} has orientation [0,0,0,0]: it was never given a value")
    dx, dy, dz = (number(run, shift) for shift in shifts)
    moved = frames.compose((p, frames.normalised(q)), ((dx, dy, dz), (1.0, 0.0, 0.0, 0.0)))[0]
    for axis, name in enumerate(("rx", "ry", "rz")):
        turn = args.value(name)
        if turn is not None:
            q = frames.product(q, frames.about(axis, number(run, turn) * DEG))
    return Value(ROBTARGET, (moved, q, *rest))


# ---------------------------------------------------------------------------------------------------------- frames


def _frame(run: Run, node: Expression) -> frames.Frame:
    p, q = evaluate(run, node, POSE).data
    if frames.norm(q) == 0:
        raise run.error(node, f"{run.text(node)} has orientation [0,0,0,0]: it was never given a value")
    return p, frames.normalised(q)


def _pose_mult(run: Run, node: Call) -> Value:
    a, b = bind(run, node, ("Pose1", "Pose2")).required
    return Value(POSE, frames.compose(_frame(run, a), _frame(run, b)))


def _pose_inv(run: Run, node: Call) -> Value:
    (a,) = bind(run, node, ("Pose",)).required
    return Value(POSE, frames.inverse(_frame(run, a)))


def _pose_vect(run: Run, node: Call) -> Value:
    a, b = bind(run, node, ("Pose", "Pos")).required
    point: frames.Vector = evaluate(run, b, POS).data
    return Value(POS, frames.compose(_frame(run, a), (point, (1.0, 0.0, 0.0, 0.0)))[0])


def _orient_zyx(run: Run, node: Call) -> Value:
    z, y, x = (number(run, a) * DEG for a in bind(run, node, ("ZAngle", "YAngle", "XAngle")).required)
    return Value(ORIENT, frames.product(frames.product(frames.about(2, z), frames.about(1, y)), frames.about(0, x)))


def _n_orient(run: Run, node: Call) -> Value:
    (argument,) = bind(run, node, ("Rotation",)).required
    q: frames.Quaternion = evaluate(run, argument, ORIENT).data
    if frames.norm(q) == 0:
        raise run.error(argument, f"{run.text(argument)} is [0,0,0,0], which has no direction")
    return Value(ORIENT, frames.normalised(q))


def _euler_zyx(run: Run, node: Call) -> Value:
    args = bind(run, node, ("Rotation",), ("X", "Y", "Z"))
    if len(args.optional) != 1:
        raise run.error(node, "EulerZYX takes exactly one of \\X, \\Y, \\Z")
    q: frames.Quaternion = evaluate(run, args.required[0], ORIENT).data
    R = frames.matrix(frames.normalised(q)) if frames.norm(q) else None
    if R is None:
        raise run.error(args.required[0], "EulerZYX of [0,0,0,0], which has no direction")
    angles = {
        "x": math.atan2(R[2][1], R[2][2]),
        "y": math.atan2(-R[2][0], math.hypot(R[0][0], R[1][0])),
        "z": math.atan2(R[1][0], R[0][0]),
    }
    return Value(NUM, angles[next(iter(args.optional))] / DEG)


def _pos(run: Run, node: Expression) -> frames.Vector:
    x, y, z = evaluate(run, node, POS).data
    return x, y, z


def _distance(run: Run, node: Call) -> Value:
    a, b = (_pos(run, argument) for argument in bind(run, node, ("Point1", "Point2")).required)
    return Value(NUM, math.dist(a, b))


def _dot_prod(run: Run, node: Call) -> Value:
    a, b = (_pos(run, argument) for argument in bind(run, node, ("Vector1", "Vector2")).required)
    return Value(NUM, a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def _vect_magn(run: Run, node: Call) -> Value:
    (a,) = bind(run, node, ("Vector",)).required
    return Value(NUM, frames.length(_pos(run, a)))


# --------------------------------------------------------------------------------------------------------- numbers


def _plain(name: str, compute: Callable[..., float], count: int = 1) -> Handler:
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


def _rounding(exact: Callable[[float], float]) -> Handler:
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


# ------------------------------------------------------------------------------------------------- data and strings


def _dim(run: Run, node: Call) -> Value:
    array, which = bind(run, node, ("ArrPar", "DimNo")).required
    value, index = evaluate(run, array), integer(run, which, "DimNo")
    if not isinstance(value.type, Array) or not 1 <= index <= value.type.dimensions:
        raise run.error(node, f"{run.text(array)} has no dimension {index}")
    data: Data = value.data
    for _ in range(index - 1):
        assert isinstance(data, tuple)
        data = data[0]
    assert isinstance(data, tuple)
    return Value(NUM, float(len(data)))


def _present(run: Run, node: Call) -> Value:
    (argument,) = bind(run, node, ("OptPar",)).required
    if not isinstance(argument, Name):
        raise run.error(argument, "Present takes the name of an optional parameter")
    return Value(BOOL, not isinstance(run.find(argument.name), Absent))


def _signal_value(run: Run, node: Call) -> float:
    (argument,) = bind(run, node, ("Signal",)).required
    run.signal(argument)
    return number(run, argument)


def _test_di(run: Run, node: Call) -> Value:
    return Value(BOOL, _signal_value(run, node) == 1.0)


def _signal(run: Run, node: Call) -> Value:
    return Value(NUM, _signal_value(run, node))


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


FUNCTIONS: dict[str, Handler] = {
    "Offs": _offs,
    "RelTool": _rel_tool,
    "PoseMult": _pose_mult,
    "PoseInv": _pose_inv,
    "PoseVect": _pose_vect,
    "OrientZYX": _orient_zyx,
    "EulerZYX": _euler_zyx,
    "NOrient": _n_orient,
    "Distance": _distance,
    "DotProd": _dot_prod,
    "VectMagn": _vect_magn,
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
    "Dim": _dim,
    "Present": _present,
    "TestDI": _test_di,
    "DInput": _signal,
    "DOutput": _signal,
    "GInput": _signal,
    "GOutput": _signal,
    "AInput": _signal,
    "AOutput": _signal,
    "ValToStr": _val_to_str,
    "NumToStr": _num_to_str,
    "StrLen": _str_len,
    "StrPart": _str_part,
}
