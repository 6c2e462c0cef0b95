"""The controller that a task orders, read anew, and what its law makes of an equilibrium, row by row (law_loops.py)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.judge import quaternions as turns
from trajopt_cli.iiwa.judge.task_order import frame
from trajopt_cli.iiwa.judge.written import METRE, PLAIN, RADIAN, SECOND, Written
from trajopt_cli.native.loops import loops

_FORCE = {"N": 1.0, "Nm": 1.0}
STIFFNESS = {"N/m": 1.0, "N/mm": 1e3, "Nm/rad": 1.0}
DAMPING = {"N s/m": 1.0, "Ns/m": 1.0, "N m s/rad": 1.0, "Nms/rad": 1.0}
INERTIA = {"kg": 1.0, "g": 1e-3, "kg m2": 1.0}
_COMPONENTS = ("fx", "fy", "fz", "mx", "my", "mz")
_SOON = 1e-9  # s: a change this little after a period's start begins with it
_SETTLING, _LONGEST = 8, 10.0  # slowest time constants, and s: an arm is at rest after that
_LOOPS = "trajopt_cli.iiwa.judge.law_loops"


@dataclass(frozen=True, eq=False)
class Law:
    """From a row on: stiffness K (6,), how the state goes on (6, 6), and of a force what is felt: within bounds (6,),
    by kept (6, 6)."""

    row: int
    K: Array
    step: Array
    bounds: Array
    kept: Array


@dataclass(frozen=True, eq=False)
class Answer:
    """Rows of the arm: x (n, 6), its angles counted from the start (positions alone mean something with slerp);
    q (n, 4) in the world; force (n, 6) [N, Nm] and depth (n,) [m] of what it touches."""

    x: Array
    q: Array
    force: Array
    depth: Array


@dataclass(frozen=True, eq=False)
class Controller:
    """h [s]: the period. laws: in order, the first from row 0 on. shapes (b, 19) and tip [m]: as in law_loops.py.

    pushes: from, to [s] and force (6,). beyond: why the judge cannot tell where the arm goes; unfelt: why not what it
    feels.
    """

    h: float
    slerp: bool
    laws: tuple[Law, ...]
    shapes: Array
    tip: float
    pushes: tuple[tuple[float, float, Array], ...]
    beyond: tuple[str, ...]
    unfelt: tuple[str, ...]

    @property
    def rest(self) -> int:
        """Rows until an arm that is let go stands at its equilibrium."""
        slowest = 0.0
        for law in self.laws:
            for (a, b, _, p, q, _), k in zip(law.step, law.K, strict=True):
                size = float(np.abs(np.linalg.eigvals([[a, b], [p, 1 + q]])).max())
                slowest = max(slowest, (-self.h / math.log(size) if 0 < size < 1 else math.inf) if k > 0 else 0.0)
        return math.ceil(min(_SETTLING * slowest, _LONGEST) / self.h)

    def stiffness(self, rows: int) -> Array:
        """K (rows, 6) at each row."""
        which = np.searchsorted([law.row for law in self.laws], np.arange(rows), side="right") - 1
        return np.asarray(np.array([law.K for law in self.laws])[which])

    def pushed(self, t: Array) -> Array:
        """The forces (n, 6) that are ordered for times t (n,)."""
        out = np.zeros((len(t), 6))
        for begin, end, force in self.pushes:
            out[(t + _SOON >= begin) & (t + _SOON < end)] += force
        return out

    def answer(
        self, u: Array, q_e: Array, start: tuple[Array, Array], felt: Array | None = None, speed: bool = False
    ) -> Answer:
        """Where the law leads from rest at start (p, q) along an equilibrium u (n, 6), q_e (n, 4).

        felt (n, 6): forces; None for those of the shapes. speed: whether the equilibrium's is fed, too.
        """
        n = len(u)
        out = Answer(np.zeros((n, 6)), np.zeros((n, 4)), np.zeros((n, 6)), np.zeros(n))
        row, step, bounds, kept = (
            np.array([getattr(law, name) for law in self.laws]) for name in ("row", "step", "bounds", "kept")
        )
        if felt is not None:
            kept = np.tile(np.eye(6), (len(row), 1, 1))
        laws, forces = (row, step, kept, bounds), np.zeros((n, 6)) if felt is None else felt
        shapes = self.shapes if felt is None else np.zeros((0, 19))
        into = out.x, out.q, out.force, out.depth, np.zeros((2, 6))
        place = forces, shapes, self.tip, *start
        loops(_LOOPS)["replay"](self.h, int(self.slerp), int(speed), u, q_e, *laws, *place, *into)
        return out

    def touched(self, p: Array, q: Array) -> tuple[Array, Array]:
        """Forces (n, 6) and depths (n,) of rows p (n, 3), q (n, 4)."""
        force, depth = np.zeros((len(p), 6)), np.zeros(len(p))
        loops(_LOOPS)["touched"](self.h, self.shapes, self.tip, p, q, force, depth)
        return force, depth

    def at_rest(self, p: Array) -> Array:
        """Depth, normal (3) and force (n, 5) of rows p (n, 3) as law_loops.at_rest has them."""
        out = np.zeros((len(p), 5))
        loops(_LOOPS)["at_rest"](self.shapes, self.tip, p, np.maximum(self.stiffness(len(p))[:, :3], 1e-300), out)
        return out

    def felt(self, force: Array, t: Array) -> Array:
        """What the controller believes (n, 6) of true forces."""
        which = np.searchsorted([law.row for law in self.laws], np.arange(len(t)), side="right") - 1
        bounds, kept = (np.array([getattr(law, name) for law in self.laws])[which] for name in ("bounds", "kept"))
        return np.asarray(np.einsum("nij,nj->ni", kept, np.clip(force, -bounds, bounds) + self.pushed(t)))


def read_controller(path: str, h: float, rows: Mapping[str, int], integration: str | None = None) -> Controller:
    """The controller of a task file. rows: those at which a sequence arrives at poses, by name. integration: how it is
    stepped, None for as the task says.

    Raises InputError with file, line and key for what the judge cannot use.
    """
    task = Written(path, "task file")
    exact = (integration or task.choice("integration", "euler", "exact")) == "exact"
    beyond, unfelt, changes = [], [], [{"at": 0.0}, *task.at("changes", [])]
    units = {"K": STIFFNESS, "D": DAMPING, "M": INERTIA}
    now: dict[str, Any] = {}
    laws = []
    if task.at("controller", "admittance") != "admittance" or any(task.at(name) is None for name in units):
        other = ("a controller of another kind, or of another file",)
        return Controller(h, False, (), np.zeros((0, 19)), 0.0, (), other, other)
    dated = sorted(range(len(changes)), key=lambda i: _row(task, i - 1, changes[i].get("at"), h, rows))
    for i in dated:
        key, section = (f"changes.{i - 1}.", changes[i]) if i else ("", task.content)
        for name, unit in units.items():
            if section.get(name) is not None:
                now[name] = np.array(task.numbers(key + name, section[name], unit, 6))
        if "zero" in section or not i:
            now["kept"] = _kept(task, key + "zero", section.get("zero") or {})
        if "clamps" in section or not i:
            clamps = section.get("clamps") or {}
            now["bounds"] = np.full(6, np.inf)
            if clamps.get("force") is not None:
                now["bounds"] = np.array(task.numbers(f"{key}clamps.force", clamps["force"], _FORCE, 6))
            if clamps.get("torque") is not None:
                unfelt.append("clamps of torques")
        if i and {"tool", "base", "restart"} & section.keys():
            beyond.append("changes of frames")
        step = np.array([_step(*one, h, exact) for one in zip(now["K"], now["D"], now["M"], strict=True)])
        row = _row(task, i - 1, changes[i].get("at"), h, rows)
        laws.append(Law(row, now["K"], step, now["bounds"], now["kept"]))
    if task.at("sensor") is not None:
        unfelt.append("errors of sensors")
    if task.at("force.by") == "wrench":
        beyond.append("a wrench that the controller is told")
    pushes = task.at("pushes", [])
    if isinstance(pushes, str):
        unfelt.append("recorded pushes")
        pushes = []
    forces = []
    for i, push in enumerate(pushes):
        begin, end = (task.number(f"pushes.{i}.{name}", push[name], SECOND) for name in ("from", "to"))
        forces.append((begin, end, np.array(task.numbers(f"pushes.{i}.force", push["force"], _FORCE, 6))))
    tip = 0.0 if task.at("contact") is None else task.number("contact.tip", task.at("contact.tip"), METRE)
    obstacles = task.section("contact.obstacles")
    shapes = np.array([_shape(task, f"contact.obstacles.{name}", one) for name, one in obstacles.items()])
    slerp = task.choice("rotation", "tait-bryan", "slerp") == "slerp"
    shapes = shapes.reshape(-1, 19)
    return Controller(h, slerp, tuple(laws), shapes, tip, tuple(forces), tuple(beyond), tuple(unfelt))


def _row(task: Written, i: int, at: Any, h: float, rows: Mapping[str, int]) -> int:
    """The row from which on a change holds."""
    if i < 0:
        return 0
    if isinstance(at, str) and at in rows:
        return rows[at]
    return max(0, math.ceil((task.number(f"changes.{i}.at", at, SECOND) - _SOON) / h - 1e-9))


def _step(k: float, d: float, m: float, h: float, exact: bool) -> list[float]:
    """a, b, c, p, q, r of one axis."""
    if not exact:
        return [1 - h * d / m, -h * k / m, h / m, h, 0.0, 0.0]
    A = h * np.array([[-d / m, -k / m, 1 / m], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    halvings = max(0, math.ceil(math.log2(max(np.abs(A).sum(axis=1).max(), 1e-300))) + 4)
    part = power = np.eye(3)
    for n in range(1, 15):
        power = power @ A / (n * 2.0**halvings)
        part = part + power
    for _ in range(halvings):
        part = part @ part
    return [*part[0].tolist(), part[1, 0], part[1, 1] - 1, part[1, 2]]


def _kept(task: Written, key: str, zero: Mapping[str, Any]) -> Array:
    """Of a force what is left where components in a turned frame are zeroed (6, 6)."""
    angles = task.numbers(f"{key}.frame", zero.get("frame", [0, 0, 0]), RADIAN, 3)
    R = turns.to_matrix(turns.from_angles(np.array(angles)))
    left = np.array([name not in zero.get("components", ()) for name in _COMPONENTS], dtype=np.float64)
    out = np.zeros((6, 6))
    out[:3, :3], out[3:, 3:] = R * left[:3] @ R.T, R * left[3:] @ R.T
    return out


def _shape(task: Written, key: str, one: Mapping[str, Any]) -> Array:
    """A row of law_loops.shapes."""
    numbers = [task.number(f"{key}.stiffness", one.get("stiffness"), STIFFNESS)]
    numbers.append(task.number(f"{key}.damping", one.get("damping", 0.0), DAMPING))
    numbers.append(task.number(f"{key}.friction", one.get("friction", 0.0), PLAIN))
    if "capsule" in one:
        a, b = (np.array(task.numbers(f"{key}.capsule", one["capsule"][end], METRE, 3)) for end in ("from", "to"))
        radius = task.number(f"{key}.capsule.radius", one["capsule"]["radius"], METRE)
        return np.array([1.0, *numbers, *a, *(b - a), radius, *np.zeros(8)])
    X = frame(task, f"{key}.box", one["box"])
    R = turns.to_matrix(X.q)
    size = np.array(task.numbers(f"{key}.box.size", one["box"]["size"], METRE, 3))
    return np.array([0.0, *numbers, *R.ravel(), *X.p, *(size / 2)])


def held(rows: Array, more: int) -> Array:
    """Rows with the last one that many times more."""
    return np.concatenate([rows, np.repeat(rows[-1:], more, axis=0)])
