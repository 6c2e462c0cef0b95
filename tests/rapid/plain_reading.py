"""RAPID moves read a second time: from the text by regular expressions, with nothing of trajopt in it.

Planner and judge have one reader, so what it makes of mm, frames and speeds wrong both take for right. This one reads
literal data, moves and the few instructions that change them, in the order of the text and without any control flow.
SI units. Figures and the meaning of data as in ABB's reference manual.
"""

from __future__ import annotations

import re
from ast import literal_eval
from collections import Counter
from contextlib import suppress
from math import nan, pi
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

Pose = Any  # (4, 4)
MM, DEG, NONE = 0.001, pi / 180, (nan,) * 6
SPEEDS = (5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800)
SPEEDS += (1000, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7000)
ZONES = {5: 8, 10: 15, 15: 23, 20: 30, 30: 45, 40: 60, 50: 75, 60: 90, 80: 120, 100: 150, 150: 225, 200: 300}
TOOL0 = [True, [[0, 0, 0], [1, 0, 0, 0]], None]
WOBJ0 = [False, True, "", TOOL0[1], TOOL0[1]]
PREDEFINED: dict[str, Any] = {"tool0": TOOL0, "wobj0": WOBJ0, "fine": [True], "vmax": [5000, 500, 5000, 1000]}
PREDEFINED |= {f"v{v}": [v, 500, 5000, 1000] for v in SPEEDS} | {f"vrot{v}": [0, 0, 0, v] for v in (10, 20, 50, 100)}
PREDEFINED |= {f"vlin{v}": [0, 0, v, 0] for v in (10, 20, 50, 100, 200, 500, 1000)}
PREDEFINED |= {"z0": [False, 0.3, 0.3, 0.3, 0.03, 0.3, 0.03], "z1": [False, 1, 1, 1, 0.1, 1, 0.1]}
PREDEFINED |= {f"z{r}": [False, r, w, w, a, w, a] for r, w in ZONES.items() for a in [23 if r == 150 else w / 10]}
STATEMENT = re.compile(r"\b(Move(?:AbsJ|ExtJ|[JLC])|PDispSet|PDispOff|VelSet)\b([^;]*);", re.I)
ARGUMENT = re.compile(r"\\?(?:[^,\\()\[\]]|\((?:[^()]|\([^()]*\))*\)|\[(?:[^\[\]]|\[[^\[\]]*\])*\])+")


def known(name: str, data: dict[str, Any]) -> Any:
    """Data by name or as written, Offs and RelTool of it with numbers; KeyError for everything else."""
    name = name.strip()
    if call := re.fullmatch(r"(Offs|RelTool)\s*\((.*)\)", name, re.I | re.S):
        target, *shift = ARGUMENT.findall(call[2])
        (p, q, *rest), turn = known(target, data), dict(re.findall(r"\\(R[xyz])\s*:=\s*([^\\]+)", call[2], re.I))
        R, by = rotation(q), [float(value) for value in shift[:3]]
        if call[1].lower() == "offs":
            return [[*np.add(p, by)], q, *rest]
        R_1 = R * Rotation.from_euler("XYZ", [float(turn.get(axis, 0)) for axis in ("Rx", "Ry", "Rz")], degrees=True)
        return [[*(p + R.apply(by))], R_1.as_quat(scalar_first=True), *rest]
    if name.startswith("["):
        return literal_eval(re.sub(r"\b(TRUE|FALSE)\b", lambda word: word[0].capitalize(), name, flags=re.I))
    return data[name.lower()]


def rotation(q: Any) -> Rotation:
    return Rotation.from_quat(q, scalar_first=True)


def pose(p: Any, q: Any) -> Pose:
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = rotation(q).as_matrix(), np.multiply(p, MM)
    return X


def readings(text: str, tables: dict[str, Any] | None = None) -> dict[int, dict[str, Any]]:
    """What each move asks for, by where it begins in the text; without those whose arguments are no literal data.

    tables: of a unit that carries work objects the pose of its axis, which turns about z as external axis b says.
    """
    text = re.sub(r'"[^"\n]*"|![^\n]*', lambda part: part[0] if part[0][0] == '"' else " " * len(part[0]), text)
    data, out, D, share, highest, table = PREDEFINED.copy(), {}, np.eye(4), 1.0, 1e9, 0.0
    for name, value in re.findall(r"\b(?:CONST|PERS|VAR)\s+\w+\s+(\w+)\s*:=\s*(\[[^;]*);", text, re.I):
        with suppress(ValueError):  # no literal
            data[name.lower()] = known(value, data)
    given = Counter(name.lower() for name in re.findall(r"(?<![\\.\w])(\w+)(?:\s*\.\s*\w+)*\s*:=", text))
    for name in [name for name, times in given.items() if times > 1]:
        data.pop(name, None)  # written to, or another one of that name
    for found in STATEMENT.finditer(text):
        what, args = found[1].lower(), [one.strip() for one in ARGUMENT.findall(found[2])]
        options = {}
        for one in [one for one in args if one.startswith("\\")]:
            options[re.match(r"\\(\w+)", one)[1].lower()] = one.partition(":=")[2]  # type: ignore[index]
        args = [one for one in args if not one.startswith("\\")]
        try:
            if what == "pdispset":
                D = pose(*known(args[0], data))
            elif what == "pdispoff":
                D = np.eye(4)
            elif what == "velset":
                share, highest = float(args[0]) / 100, float(args[1]) * MM
            else:
                speed, zone, tool = [*args[2 if what == "movec" else 1 :], "tool0"][:3]
                v, z = np.array(known(speed, data), float), known(zone, data)
                v[0] = float(options.get("v", v[0]))
                v *= np.array([MM, DEG, MM, DEG]) * share
                v[0] = min(v[0], highest)
                sizes = NONE if z[0] or "inpos" in options else [float(options.get("z", z[1])), *z[2:]]
                asked = known(args[1 if what == "movec" else 0], data)
                extax = [nan if value > 8.9e9 else value for value in asked[-1]]
                table = table if extax[1] != extax[1] else extax[1]
                read = {"extax": extax, "speed": v, "zone": np.multiply(sizes, [MM, MM, MM, DEG, MM, DEG])}
                read["time"] = float(options["t"]) / share if "t" in options else nan
                if what != "moveextj":
                    read["X_FT"] = pose(*known(tool, data)[1])
                if what == "moveabsj":
                    read["q"] = np.multiply(asked[0], DEG)
                if what in ("movej", "movel", "movec"):
                    _, fixed, unit, user, oframe = known(options.get("wobj", "wobj0"), data)
                    turn = pose((0, 0, 0), (np.cos(table * DEG / 2), 0, 0, np.sin(table * DEG / 2)))
                    X_WU = pose(*user) if fixed else (tables or {})[unit] @ turn
                    X_WO = X_WU @ pose(*oframe) @ D
                    read |= {"X_WO": X_WO, "X_WT": X_WO @ pose(*asked[:2]), "conf": [*asked[2], 0][:4]}
                if what == "movec":
                    read["X_WV"] = X_WO @ pose(*known(args[0], data)[:2])
                out[found.start()] = read
        except (KeyError, ValueError, SyntaxError):
            continue
    return out
