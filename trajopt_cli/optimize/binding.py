"""Which limit holds a motion back."""

from __future__ import annotations

import numpy as np

from trajopt_cli.limits import TcpCaps
from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.exchange import tool_of, tool_ratios
from trajopt_cli.optimize.legs import LegMotion
from trajopt_cli.optimize.tuning import AT_LIMIT, BINDING_SAMPLES, FEWEST_SAMPLES, LOOK, STILL
from trajopt_cli.problem.problem import Leg


def binding_limit(axes: Axes, tcp: TcpCaps, leg: Leg, motion: LegMotion) -> str:
    """The limit a motion stands at for the largest share of its time, as "joint_1 acceleration" or "programmed ...";
    "already there" where no axis has to move. tcp: the cell's caps, which a programmed speed may lie below."""
    if leg.duration is not None:
        return "programmed duration"
    places = np.zeros(int(np.clip(motion.T / LOOK, FEWEST_SAMPLES, BINDING_SAMPLES)), dtype=np.intp)
    sample = motion.sample(axes, (np.arange(len(places)) + 0.5) / len(places) * motion.T)
    if np.all(np.ptp(sample.q, axis=0) < STILL):
        return "already there"
    tool = tool_ratios(axes.caps([leg]).at(places), tool_of(axes, [leg.X_FT], places, sample))
    names = [f"{name} speed" for name in axes.names] + [f"{name} acceleration" for name in axes.names]
    programmed = leg.v_tcp < tcp.speed
    names += ["programmed TCP speed" if programmed else "TCP speed", "TCP acceleration", "TCP turning"]
    ratios = np.concatenate([np.abs(sample.qd) / axes.velocity, np.abs(sample.qdd) / axes.acceleration, tool], axis=1)
    if axes.jerk is not None:
        names += [f"{name} jerk" for name in axes.names]
        jerk = np.abs(np.diff(sample.qdd, axis=0)) / np.diff(sample.t)[:, None] / axes.jerk
        ratios = np.hstack([ratios, np.vstack([jerk, jerk[-1:]])])
    share = np.mean(ratios >= AT_LIMIT, axis=0)
    best = int(np.argmax(share)) if np.any(share > 0) else int(np.argmax(np.max(ratios, axis=0)))
    return names[best]
