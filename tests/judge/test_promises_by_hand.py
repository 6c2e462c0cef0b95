"""Every promise of the judge against the formulas of docs/judge.md, worked out here from a file's rows and steps; and
the levers and the grants for distances that they are made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf, log10

import numpy as np
import pytest
from by_hand import seen
from legal_motion import Case, bench_case, plant_with_rail, plant_without_rail, rapid_case
from legal_runs import line_line, with_rail

from trajopt_cli.geometry import Array, pose
from trajopt_cli.joint_csv import Resolution
from trajopt_cli.judge.mechanism import mechanism_of
from trajopt_cli.judge.promises import Promises, levers
from trajopt_cli.judge.samples import Rows
from trajopt_cli.limits import JointLimits
from trajopt_cli.motion import MoveExtJ
from trajopt_cli.problem.plant import Plant
from trajopt_cli.shapes import Box, Capsule, Solid
from trajopt_cli.trajectory import Trajectory

Least = Callable[[float, float], tuple[float, float | None]]  # of steps of values and of times: excess and how long
Row = tuple[float, float | None, float | None, tuple[tuple[str, float], ...]]
BOX = Solid(Box("box", np.full(3, 0.05), pose(np.eye(3), [2.0, 2.0, 0.5])))


@dataclass
class File:
    """What the formulas need of one file."""

    case: Case
    rows: Rows

    def __post_init__(self) -> None:
        rows, plant = self.rows, self.case.plant
        self.speeds, self.h = rows.qd is not None, float(rows.longest.max())
        self.tau = 0.0 if rows.marked else self.h / 2
        self.r, self.r_v = rows.doubt_q.max(axis=0), rows.doubt_v.max(axis=0)
        at_ends = len(rows.t) > 4 and rows.step_t[1:-1].max() < rows.step_t.max()
        self.inner = slice(1, -1) if at_ends else slice(None)
        self.r_t = float(rows.step_t[self.inner].max())
        # without the first and the last row an excess may have begun and ended a gap earlier and later
        self.beside = 2 * self.h if at_ends else 0.0
        self.t = np.r_[0.0, np.cumsum(rows.gaps[self.inner])]
        tools = {np.asarray(one.tool.X_FT).tobytes(): one.tool.X_FT for one in self.case.program.motions
                 if hasattr(one, "tool") and not isinstance(one, MoveExtJ)}  # fmt: skip
        self.p = self.R = self.V = self.W = 0.0
        for X_FT in tools.values():
            J = plant.robot.jacobian(rows.q, X_FT)
            linear, angular = (np.linalg.norm(part, axis=1) for part in (J[:, :3], J[:, 3:]))
            at = [(columns * rows.doubt_q / 2).sum(axis=1) for columns in (linear, angular)]
            self.p, self.R = max(self.p, at[0].max()), max(self.R, at[1].max())
            if self.speeds:  # a turned Jacobian counts at the speed that all axes make together
                total = np.abs(rows.qd).sum(axis=1)
                V, W = ((columns * rows.doubt_v / 2).sum(axis=1) + total * doubt
                        for columns, doubt in zip((linear, angular), at, strict=True))  # fmt: skip
                self.V, self.W = max(self.V, V.max()), max(self.W, W.max())

    def by_lag(self, differences: int, top: float, least: Callable[[float], float]) -> tuple[float, float | None]:
        """The shortest lag that shows a hundredth of top, else the one that shows most."""
        found: tuple[float, float | None] = (inf, None)
        for m in (1, 2, 4, 8, 16, 32):
            n = differences * m
            if n + 1 < len(self.t):
                x = least(float((self.t[n:] - self.t[:-n]).min()) / differences)
                lasting = float((self.t[n + 1 :] - self.t[: -n - 1]).max()) + self.beside
                found = min(found, (x, lasting), key=lambda one: one[0])
                if x <= 0.01 * top:
                    break
        return found

    def rate(self, top: float, eps: float, r: float, bend: float = 0.0) -> Least:
        """Of mean rates between two rows. bend: the acceleration that bends the way between them."""

        def least(q: float, t: float) -> tuple[float, float | None]:
            def of(H: float) -> float:
                r_t = t * self.r_t
                chord = bend**2 * H**2 / (24 * top)
                return (top * (1 + eps) * (H + r_t) + 2 * q * r) / (H - r_t) - top + chord if r_t < H else inf

            return self.by_lag(1, top, of)

        return least

    def or_of_rows(self, of_lags: Least, top: float, at_rows: Least) -> Least:
        """The same, or by the speeds of single rows: the shorter one of those that show a hundredth, else the less."""

        def least(q: float, t: float) -> tuple[float, float | None]:
            one, other = of_lags(q, t), at_rows(q, t)
            enough = [both for both in (one, other) if both[0] <= 0.01 * top]
            return min(enough or (one, other))

        return least if self.speeds else of_lags

    def d_2(self, H: float, r: float, speed: float, r_t: float) -> float:
        return 4 * (r + speed * r_t) / ((H - r_t) * (2 * H - r_t)) if r_t < H else inf

    def second(self, top: float, eps: float, r: float, speed: float) -> Least:
        def least(q: float, t: float) -> tuple[float, float | None]:
            def of(H: float) -> float:
                r_t = t * self.r_t
                d = self.d_2(H, q * r, speed, r_t)
                return (top * (1 + eps) + d) * H / (H - r_t) + d - top if r_t < H else inf

            return self.by_lag(2, top, of)

        return least

    def third(self, top: float, r: float, speed: float, a: float) -> Least:
        def least(q: float, t: float) -> tuple[float, float | None]:
            def of(H: float) -> float:
                r_t = t * self.r_t
                if r_t >= H:
                    return inf
                u = (self.d_2(H, q * r, speed, r_t) * (2 * H - r_t) + a * r_t) / (2 * H - 2 * r_t)
                return (top * (1 + 1e-6) * (3 * H + r_t) + 12 * u) / (3 * H - r_t) - top

            return self.by_lag(3, top, of)

        return least

    def row(self, least: Least, most: float | None = None, digits: str = "positions", step: float | None = None) -> Row:
        """A promise, with what steps would leave half of what may be open: powers of ten."""
        value, lasting = least(1.0, 1.0)
        needs = []
        if most is not None and least(0.0, 0.0)[0] < most:
            step = step if step is not None else float((self.r if digits == "positions" else self.r_v).max())
            for name, one, of in (
                (digits, step, lambda x: least(x, 0.0)[0]), ("times", self.r_t, lambda x: least(0.0, x)[0])
            ):  # fmt: skip
                base = of(0.0)
                enough = [d for d in range(15) if of(10.0**-d / one) - base <= (most - base) / 2]
                if enough and enough[0]:
                    needs.append((name, 10.0 ** -enough[0]))
        return value, lasting, most, tuple(needs)

    def of_axis(self, j: int, swing: dict[str, float]) -> dict[tuple[str, ...], Row]:
        """All of one axis."""
        limits, out = self.case.plant.limits, {}
        v, a, r, r_v = (float(x[j]) for x in (limits.velocity, limits.acceleration, self.r, self.r_v))
        name, span = limits.names[j], float(limits.upper[j] - limits.lower[j])
        unit, force = ("m", "N") if name == "rail" else ("rad", "Nm")
        kind, step = ("speeds", r_v) if self.speeds else ("positions", r)
        out["joint position", name, unit] = self.row(linear(1e-6 * span + a * self.h**2 / 8, r))
        speed = self.or_of_rows(self.rate(v, 1e-6, r), v, linear(v * 1e-6, 1.5 * r_v, self.h))
        out["joint speed", name, f"{unit}/s"] = self.row(speed, 0.03 * v, kind, step)
        pull = self.rate(a, 1e-6, r_v) if self.speeds else self.second(a, 1e-6, r, v)
        out["joint acceleration", name, f"{unit}/s2"] = self.row(pull, 0.06 * a, kind, step)
        top = float(limits.jerk[j])
        jerk = self.second(top, 1e-6, r_v, a) if self.speeds else self.third(top, r, v, a)
        out["joint jerk", name, f"{unit}/s3"] = self.row(jerk, 0.09 * top, kind, step)
        if name in swing:
            most = 1e-5 * float(limits.torque[j]) + 2 * swing[name]
            out["joint torque", name, force] = self.row(linear(most, 0.0, 3 * self.h))
        return out

    def table(self, swing: dict[str, float], lever: Array, fly_by: bool, bend: float) -> dict[tuple[str, ...], Row]:
        """All of docs/judge.md. bend: the most that a way turns by its length [rad/m]."""
        rows, plant, out = self.rows, self.case.plant, {}
        limits, a_tcp, v_tcp, h, tau = plant.limits, plant.tcp.acceleration, plant.tcp.speed, self.h, self.tau
        kind = "speeds" if self.speeds else "positions"
        for j in range(len(limits.names)):
            out |= self.of_axis(j, swing)
        of_tool = self.rate(v_tcp, 1e-4, 2 * self.p, a_tcp)
        speed = self.or_of_rows(of_tool, v_tcp, linear(v_tcp * 1e-4, 2 * self.V, h))
        out["TCP speed", "TCP", "m/s"] = self.row(speed, 0.03 * v_tcp, kind)
        pull = self.rate(a_tcp, 1e-4, 2 * self.V) if self.speeds else self.second(a_tcp, 1e-4, 2 * self.p, v_tcp)
        out["TCP acceleration", "TCP, one way", "m/s2"] = self.row(pull, 0.06 * a_tcp, kind)
        top = max(one.speed.v_ori for one in self.case.program.motions if hasattr(one, "speed"))
        turns = self.or_of_rows(self.rate(top, 1e-4, 2 * self.R), top, linear(top * 1e-4, 2 * self.W, h))
        out["programmed reorientation", "TCP", "rad/s"] = self.row(turns, 0.03 * top, kind)
        out["path deviation", "TCP", "m"] = self.row(linear(1e-6, 2 * self.p, 3 * h), 2e-4 + 1e-6)
        off_turn = linear(1e-6, 2 * (self.R + bend * self.p), 3 * h)
        out["path rotation", "TCP", "rad"] = self.row(off_turn, 2 * (1e-3 + bend * 1e-4) + 1e-6)
        alpha = float(sum(x for x, n in zip(limits.acceleration, limits.names, strict=True) if n != "rail"))
        near, turned = 1e-6 + a_tcp * tau**2 / 2, 1e-6 + alpha * tau**2 / 2
        out["stop reached", "TCP", "m"] = self.row(linear(near, 2 * self.p), 2e-4 + near)
        out["stop reached", "tool", "rad"] = self.row(linear(turned, 2 * self.R), 2e-3 + turned)
        rest = 1e-5 + a_tcp * tau + 2 * self.V
        if not self.speeds:
            rest = (1e-5 + a_tcp * (tau + h / 2) + 4 * self.p / h) * 24 / 23 * (1 + 2 * self.r_t / h)
        out["stop rest", "TCP", "m/s"] = self.row(linear(rest, 0.0, 2 * h))
        if fly_by:
            out["fly-by passed", "TCP", "m"] = self.row(linear(1e-6 + a_tcp * h**2 / 4, 2 * self.p))
        if plant.robot.has_rail:
            r, a = float(self.r[0]), float(limits.acceleration[0])
            out["rail target", "rail", "m"] = self.row(linear(1e-6 + a * tau**2, r, 2 * tau))
            out["way while held", "rail", "m"] = self.row(linear(1e-6, 2 * r, 3 * h))
        r_t = float(rows.step_t.max())
        out["dwell length", "TCP", "s"] = self.row(linear(1e-9 + 2 * r_t + 4 * tau, 0.0))
        out["duration", "move, positioner", "s"] = self.row(linear(1e-6 + 4 * r_t + 6 * tau, 0.0))
        bent = 0.0 if rows.marked and self.speeds else h**2 / 8
        granted = float(lever @ (self.r / 2 + limits.acceleration * bent))
        out["clearance", "robot", "m"] = self.row(linear(1e-4 + 2 * granted, 0.0))
        return out


def linear(base: float, slope: float, lasting: float | None = None) -> Least:
    """An excess that grows with the step of values."""
    return lambda q, _: (base + slope * q, lasting)


def hard(plant: Plant) -> Plant:
    """With limits on jerk and torque that bind, and an obstacle."""
    limits, k = plant.limits, len(plant.limits.names)
    limits = JointLimits(
        limits.names, limits.lower, limits.upper, limits.velocity, limits.acceleration,
        jerk=limits.acceleration * 20.0, jerk_binds=True, torque=np.full(k, 300.0), torque_binds=True,
    )  # fmt: skip
    return replace(plant, limits=limits, obstacles=(BOX,))


def steps_of(k: int, n: int, size: float, speeds: bool, times: object) -> Resolution:
    rng = np.random.default_rng(k + n)
    q, v = (size * rng.uniform(0.5, 1.0, (n, k)) for _ in range(2))
    return Resolution(times, q, 3 * v * speeds)  # type: ignore[arg-type]


def at_ends(n: int, inner: float = 0.0) -> Array:
    return np.r_[4e-4, np.full(n - 2, inner), 3e-4]


FILES: dict[str, tuple[Callable[[], Case], float, bool, float | None, Callable[[int], object]]] = {
    # motion, step of rows [s] (0: our own), speeds, steps of positions, of times
    "own": (rapid_case, 0.0, True, None, lambda n: 0.0),
    "own in steps": (with_rail, 0.0, True, 1e-6, lambda n: 1e-6),
    "speeds": (bench_case, 0.004, True, 2e-6, lambda n: 0.0),
    "speeds, coarse": (line_line, 0.01, True, 2e-3, lambda n: np.full(n, 1e-3)),
    "positions": (rapid_case, 0.004, False, 1e-6, at_ends),
    "positions, coarse": (bench_case, 0.01, False, 1e-3, lambda n: np.full(n, 2e-4)),
    "positions, times": (line_line, 0.02, False, 1e-5, lambda n: np.full(n, 1e-2)),
}


@pytest.mark.parametrize("name", FILES)
def test_promises_are_those_of_the_manual(name: str) -> None:
    """Least excess, how long it lasts, what is too coarse, and which steps would do: of every check."""
    make, step, speeds, size, times = FILES[name]
    case = make()
    case = replace(case, plant=hard(case.plant))
    rows = case.rows(step=step, grid_only=True) if step else case.rows(step=0.004)
    trajectory = rows if speeds else Trajectory(rows.names, rows.t, rows.q, None)
    k = len(rows.names)
    steps = None if size is None else steps_of(k, len(rows.t), size, speeds, times(len(rows.t)))
    line, frames = seen(case, trajectory, steps)
    assert line.rows.exact == (step == 0.0)
    swing, lever = {"joint_2": 3.0, "joint_6": 0.25, "rail": 7.0}, np.linspace(2.0, 0.5, k)
    promised = Promises(line, frames, swing, lever.tolist())
    found = {(one.check, one.subject, one.unit): one for one in promised.told(case.program)}
    turns, fly_by = bends_of(case), any(not one.zone.stop for one in case.program.motions if hasattr(one, "zone"))
    swing = {key: value for key, value in swing.items() if key in rows.names}
    wanted = File(case, line.rows).table(swing, lever, fly_by, turns)
    assert list(found) == list(wanted)
    for key, (least, lasting, most, needs) in wanted.items():
        one = found[key]
        assert one.least == pytest.approx(least, rel=1e-9), key
        assert one.lasting == (None if lasting is None else pytest.approx(lasting, rel=1e-9)), key
        assert one.most == (None if most is None else pytest.approx(most, rel=1e-12)), key
        assert [(n, log10(d)) for n, d in one.needs] == [(n, pytest.approx(log10(d))) for n, d in needs], key
    assert promised.rate == (pytest.approx(1 / step) if step else None)


def bends_of(case: Case) -> float:
    """The most that a line or an arc of the case turns by its length."""
    out, before = 0.0, case.plant.robot.forward(case.plant.start[None])[0]
    for one in case.program.motions:
        if hasattr(one, "X_WT"):
            start = before @ one.tool.X_FT if before is not None else None
            if type(one).__name__ in ("MoveL", "MoveC") and start is not None:
                angle = np.arccos(np.clip((np.trace(start[:3, :3].T @ one.X_WT[:3, :3]) - 1) / 2, -1, 1))
                way = float(np.linalg.norm(one.X_WT[:3, 3] - start[:3, 3]))
                if type(one).__name__ == "MoveC":
                    way *= np.pi / 2  # half circles
                if way > 1e-6:
                    out = max(out, angle / way)
            before = one.X_WT @ np.linalg.inv(one.tool.X_FT)
    return out


@pytest.mark.parametrize("make", [plant_with_rail, plant_without_rail])
def test_levers_are_the_arm_stretched_out(make: Callable[[], Plant]) -> None:
    """From every axis the links behind it one after the other, and what is at the flange: the capsule or the body whose
    far end is farthest; a rail moves all by its own way."""
    plant = make()
    mechanism = mechanism_of(plant)
    lengths = np.linalg.norm(np.diff(mechanism.links(plant.start[None])[0][0][1:, :3, 3], axis=0), axis=1)
    beyond = max(
        max(np.linalg.norm(one.a), np.linalg.norm(one.b)) + one.radius for one in plant.robot.capsules.values()
    )
    rod = Capsule("rod", np.zeros(3), np.array([0.0, 0, 2.0]), 0.01)
    for carried, reach in (((), beyond), ((rod,), 2.01)):
        wanted = [lengths[i:].sum() + reach for i in range(6)]
        np.testing.assert_allclose(levers(plant, mechanism, carried), [1.0] * plant.robot.has_rail + wanted, rtol=1e-12)
