"""Which limit holds a motion back."""

from __future__ import annotations

import numpy as np

from trajopt_cli.optimize.axes import Axes
from trajopt_cli.optimize.exchange import tool_ratios
from trajopt_cli.optimize.legs import LegMotion
from trajopt_cli.optimize.tuning import AT_LIMIT, BINDING_SAMPLES, STILL
from trajopt_cli.problem.problem import Leg, LegKind


def binding_limit(axes: Axes, leg: Leg, motion: LegMotion) -> str:
    """The limit a motion stands at for the largest share of its time, as "joint_1 acceleration" or "programmed ...";
    "already there" where no axis has to move."""
    if leg.duration is not None:
        return "programmed duration"
    sample = motion.sample(axes, (np.arange(BINDING_SAMPLES) + 0.5) / BINDING_SAMPLES * motion.T)
    if np.all(np.ptp(sample.q, axis=0) < STILL):
        return "already there"
    tool = tool_ratios(axes, leg, sample.q, sample.qd, sample.qdd)
    names = [f"{name} speed" for name in axes.names] + [f"{name} acceleration" for name in axes.names]
    names += ["programmed TCP speed" if leg.kind is LegKind.LINE else "TCP speed", "TCP acceleration", "TCP turning"]
    ratios = np.concatenate([np.abs(sample.qd) / axes.velocity, np.abs(sample.qdd) / axes.acceleration, tool], axis=1)
    share = np.mean(ratios >= AT_LIMIT, axis=0)
    best = int(np.argmax(share)) if np.any(share > 0) else int(np.argmax(np.max(ratios, axis=0)))
    return names[best]
