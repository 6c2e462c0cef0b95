"""Parameters of ros2_controllers' admittance controller as K, D and M of a task.

By its admittance_rule_impl.hpp: D = 2 zeta sqrt(M S) per axis, and joint_damping d takes d of every joint's speed per
second, which is M d more; forces along axes that are not selected are zeroed. It moves an offset from a reference that
is followed at once: the equilibrium's speed is fed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.yaml_file import line_of, parse

_COMPONENTS = ("fx", "fy", "fz", "mx", "my", "mz")
_JOINT_DAMPING = 5.0  # 1/s, the controller's default
_BOUNDS = {"mass": (1e-4, 1e6), "damping_ratio": (0.0, 1e6), "stiffness": (0.0, 1e8)}  # its own, admittance parameters


def read_admittance(text: str, file: str, name: str | None) -> tuple[dict[str, Any], str]:
    """The task's keys K, D, M and zero, and what to know of them.

    name: the controller's, None where the file has one. Raises InputError with file and line for a file without one, or
    with several, and for values that the controller would refuse.
    """
    content, lines = parse(text, file, "a ROS 2 parameter file is needed")
    nodes = {key.strip("/*"): key for key in content if isinstance(_at(content, key, "ros__parameters"), Mapping)}
    of = ("ros__parameters", "admittance")
    found = {short: key for short, key in nodes.items() if isinstance(_at(content, key, *of), Mapping)}
    chosen = found if name is None else {short: key for short, key in found.items() if short == name}
    if len(chosen) != 1:
        known = f"it has {', '.join(found)}; name one, 'FILE.yaml:NAME'" if found else "it has none"
        raise InputError(f"needs one admittance controller: {known}", file=file, line=1)
    ((short, key),) = chosen.items()
    given = _at(content, key, *of)
    place = f"{key}.ros__parameters.admittance"

    def wrong(what: str, message: str) -> InputError:
        return InputError(f"{what}: {message}", file=file, line=line_of(f"{place}.{what}", lines))

    six = {}
    for what, (least, most) in _BOUNDS.items():
        values = given.get(what)
        if not isinstance(values, Sequence) or len(values) != 6 or not all(_number(one, least, most) for one in values):
            raise wrong(what, f"needs six numbers of {least:g} to {most:g}, not {values!r}"[:200])
        six[what] = np.array(values, dtype=np.float64)
    axes, extra = given.get("selected_axes", [True] * 6), given.get("joint_damping", _JOINT_DAMPING)
    if not isinstance(axes, Sequence) or len(axes) != 6 or not all(isinstance(one, bool) for one in axes):
        raise wrong("selected_axes", f"needs six of true and false, not {axes!r}"[:200])
    if not _number(extra, 0.0, 1e6):
        raise wrong("joint_damping", f"needs a number of 0 or more, not {extra!r}"[:200])
    M, S = six["mass"], six["stiffness"]
    D = 2 * six["damping_ratio"] * np.sqrt(M * S) + M * float(extra)
    out: dict[str, Any] = {"K": S.tolist(), "D": D.tolist(), "M": M.tolist()}
    if not all(axes):
        out["zero"] = {"components": [c for c, taken in zip(_COMPONENTS, axes, strict=True) if not taken]}
    frame = _at(content, key, "ros__parameters", "control", "frame", "id") or "its control frame"
    return out, (
        f"{short} of {file}: its axes are those of {frame}, here the world's; its force filter is not in it, and every"
        " period is stepped by forward Euler, stable a little less far than its own"
    )


def _at(content: Any, *keys: str) -> Any:
    for key in keys:
        content = content.get(key) if isinstance(content, Mapping) else None
    return content


def _number(value: Any, least: float, most: float) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and least <= value <= most
