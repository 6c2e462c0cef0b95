"""What the arm is allowed: how far it may be from its plan, and how hard it may push when somebody holds it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trajopt_cli.geometry import Array

LAGS = (1e-6, 10.0)
"""Least and greatest lag [m] that is looked at."""
TURN_LAGS = (1e-6, float(np.pi))
"""The same of the turn [rad]."""


@dataclass(frozen=True)
class Lead:
    """A bound on what the controller would push with if the arm were held now: K (x_e - x).

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
