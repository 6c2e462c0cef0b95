"""What the arm is allowed: how far it may be from its plan, and how hard it may push when somebody holds it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import inf

import numpy as np

from trajopt_cli.geometry import Array

LAGS = (1e-6, 10.0)
"""Least and greatest lag [m] that is looked at."""
TURN_LAGS = (1e-6, float(np.pi))
"""The same of the turn [rad]."""


class DoseFeed(Enum):
    """How the controller is fed: the plan's positions; the plan's speed, too; or what moves the arm along the plan.

    The last one inverts the law: u = x + (D/K) x' + (M/K) x'' for the arm's own motion x.
    """

    POSITION = "position"
    VELOCITY = "velocity"
    INVERSE = "inverse"


@dataclass(frozen=True)
class Lead:
    """A bound on what the controller would push with if the arm were held now: K (x_e - x), and D v_e where it is fed.

    most: force [N] or moment [Nm]; stretch: a distance [m] or angle [rad] of the spring that pushes as much.
    """

    most: float
    stretch: bool = False

    def weight(self, K: Array) -> Array:
        """What the push is multiplied with, by axis (3,), before its norm is held against most."""
        return np.divide(1.0, K, out=np.zeros(len(K)), where=K > 0) if self.stretch else np.ones(len(K))


@dataclass(frozen=True)
class Allowed:
    """lag [m]: greatest distance between arm and plan, at every row. turn_lag [rad]: greatest angle between their
    orientations. lead, turn_lead: of force and moment. All above zero; None: no bound."""

    lag: float
    turn_lag: float | None = None
    lead: Lead | None = None
    turn_lead: Lead | None = None

    def lags(self, K: Array) -> tuple[float, float | None]:
        """Lag [m] and turn lag [rad] of an arm behind its equilibrium that pushes no more than the leads allow.

        The stiffest axis decides where stiffnesses K (6,) differ.
        """
        lag, turn = self.lag, self.turn_lag
        if self.lead is not None:
            lag = min(lag, _stretched(self.lead, K[:3]))
        if self.turn_lead is not None:
            turn = min(inf if turn is None else turn, _stretched(self.turn_lead, K[3:]))
        return lag, turn


def _stretched(lead: Lead, K: Array) -> float:
    stiffest = float(np.max(lead.weight(K) * K))
    return lead.most / stiffest if stiffest > 0 else inf
