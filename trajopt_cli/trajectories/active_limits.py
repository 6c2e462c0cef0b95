"""Which limit holds a motion back."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.limits import TcpCaps
from trajopt_cli.problem.problem import Leg
from trajopt_cli.settings import AT_LIMIT, BINDING_SAMPLES, CHECKED, FEWEST_SAMPLES, LOOK, STILL
from trajopt_cli.trajectories.axes import Axes
from trajopt_cli.trajectories.dense_check import tool_of, tool_ratios
from trajopt_cli.trajectories.leg_trajectories import LegMotion, Sample, sampled, shares


def binding_limits(axes: Axes, tcp: TcpCaps, legs: Sequence[Leg], motions: Sequence[LegMotion]) -> list[str]:
    """Of each motion the limit it stands at for the largest share of its time, as "joint_1 acceleration" or "programmed
    ..."; "already there" where no axis has to move. tcp: the cell's caps, which a programmed speed may lie below."""
    out = [leg.waits_for if leg.least else "programmed duration" for leg in legs]
    asked = [i for i, leg in enumerate(legs) if leg.duration is None]
    counts = [int(np.clip(motions[i].T / LOOK, FEWEST_SAMPLES, BINDING_SAMPLES)) for i in asked]
    behind = np.cumsum(counts)
    for _, group in groupby(range(len(asked)), key=lambda j: int(behind[j]) // CHECKED):
        some = [*group]
        at = [asked[j] for j in some]
        found = _binding(axes, tcp, [legs[i] for i in at], [motions[i] for i in at], [counts[j] for j in some])
        for i, name in zip(at, found, strict=True):
            out[i] = legs[i].waits_for if legs[i].least and legs[i].least / AT_LIMIT >= motions[i].T else name
    return out


def _binding(
    axes: Axes, tcp: TcpCaps, legs: Sequence[Leg], motions: Sequence[LegMotion], counts: Sequence[int]
) -> Iterator[str]:
    """The same of so many that the memory takes them at once, each looked at so often; none of a given duration."""
    times = [(np.arange(n) + 0.5) / n * motion.T for n, motion in zip(counts, motions, strict=True)]
    number, sample = np.repeat(np.arange(len(legs)), counts), sampled(axes, motions, times)
    tool = tool_ratios(axes.caps(legs).at(number), tool_of(axes, [leg.X_FT for leg in legs], number, sample))
    velocity = np.array([axes.velocity_on(leg) for leg in legs])[number]
    ratios = np.concatenate([np.abs(sample.qd) / velocity, np.abs(sample.qdd) / axes.acceleration, tool], axis=1)
    if axes.torque is not None:
        ratios = np.hstack([ratios, axes.torque.used(legs, number, sample.q, sample.qd, sample.qdd)])
    if turned := any(leg.units for leg in legs):
        ratios = np.hstack([ratios, np.concatenate([_table(*of) for of in zip(legs, motions, times, strict=True)])])
    for leg, rows in zip(legs, np.split(np.arange(len(number)), np.cumsum(counts)[:-1]), strict=True):
        own = Sample(sample.t[rows], sample.q[rows], sample.qd[rows], sample.qdd[rows])
        yield _named(axes, leg, leg.v_tcp < tcp.speed, own, ratios[rows], turned)


def _table(leg: Leg, motion: LegMotion, t: Array) -> Array:
    """How much positioners use of their limits (m, 1) at times t (m,)."""
    _, rate, change = shares(motion, t)
    velocity, acceleration = leg.table
    return np.maximum(np.abs(rate) * velocity, np.abs(change) * acceleration)[:, None]


def _named(axes: Axes, leg: Leg, programmed: bool, sample: Sample, ratios: Array, turned: bool) -> str:
    """The limit of one motion. ratios (m, 2 n + 3): speeds, accelerations and the tool's three as shares of theirs; n
    torques more where they are limited; one for positioners where any is turned."""
    if np.all(np.ptp(sample.q, axis=0) < STILL) and not (turned and ratios[:, -1].any()):
        return "already there"
    capped = axes.velocity_on(leg) < axes.velocity
    names = [("programmed " if cap else "") + f"{name} speed" for name, cap in zip(axes.names, capped, strict=True)]
    names += [f"{name} acceleration" for name in axes.names]
    names += ["programmed TCP speed" if programmed else "TCP speed", "TCP acceleration", "TCP turning"]
    if axes.torque is not None:
        names += [f"{name} torque" for name in axes.names]
    if turned:
        names.append("positioner")
    if axes.jerk is not None:
        names += [f"{name} jerk" for name in axes.names]
        jerk = np.abs(np.diff(sample.qdd, axis=0)) / np.diff(sample.t)[:, None] / axes.jerk
        ratios = np.hstack([ratios, np.vstack([jerk, jerk[-1:]])])
    share = np.mean(ratios >= AT_LIMIT, axis=0)
    best = int(np.argmax(share)) if np.any(share > 0) else int(np.argmax(np.max(ratios, axis=0)))
    return names[best]
