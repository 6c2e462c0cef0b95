"""Torques of a robot's axes as CasADi expressions, generated from its pin.Model: recursive Newton-Euler.

PyPI's pin has no pinocchio.casadi; this walk is what the optimiser differentiates, and pin's own tests it. It works
in the bodies' frames, where inertias are constants (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3).
"""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from trajopt_cli.geometry import Array
from trajopt_cli.robot.dynamics import ToolLoad
from trajopt_cli.robot.symbolic import exact, rotation
from trajopt_cli.robot.urdf import FLANGE

LOAD = 10
"""Numbers of what the flange carries, see load_parameters."""
_UPPER = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))


def load_parameters(load: ToolLoad | None) -> Array:
    """Of a load (10,): mass, first moment (3,), second moments xx, xy, xz, yy, yz, zz about the flange's origin, in
    whose axes they stand. Torques are linear in them."""
    if load is None:
        return np.zeros(LOAD)
    c = load.com
    about = load.inertia + load.mass * (c @ c * np.eye(3) - np.outer(c, c))
    return np.array([load.mass, *(load.mass * c), *(about[place] for place in _UPPER)])


def torques(model: Any, q: ca.SX, qd: ca.SX, qdd: ca.SX, gravity: float, load: ca.SX, rotor: Array) -> ca.SX:
    """Torques (k,) [Nm, N for a rail] that move the axes of a pin.Model so, q, qd, qdd (k,). gravity [m/s2] along the
    world's -z. load (10,): see load_parameters. rotor (k,): inertias of the drives. Raises ValueError for a model that
    is no chain of one-axis joints."""
    chain: list[tuple[ca.SX, ...]] = []  # slide, axis, turn, lever, force, moment of each body
    w, dw, a = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX([0.0, 0.0, gravity])  # of the body before, in its frame
    flange = model.frames[model.getFrameId(FLANGE)]
    for i in range(1, model.njoints):
        if model.parents[i] != i - 1 or model.nqs[i] != 1:
            raise ValueError(f"joint {model.names[i]}: only a chain of one-axis joints has expressions")
        subspace = np.asarray(model.joints[i].createData().S).reshape(6)
        slide, axis = exact(subspace[:3]), exact(subspace[3:])
        X = model.jointPlacements[i]
        R = exact(X.rotation) @ rotation(subspace[3:], q[i - 1])
        p = exact(X.translation) + (exact(X.rotation) @ slide) * q[i - 1]
        a = R.T @ (a + ca.cross(dw, p) + ca.cross(w, ca.cross(w, p)))
        carried = R.T @ w
        rate, change = qd[i - 1], qdd[i - 1]
        dw = R.T @ dw + axis * change + ca.cross(carried, axis * rate)
        a = a + slide * change + 2 * ca.cross(carried, slide * rate)
        w = carried + axis * rate
        body = model.inertias[i]
        mass, first = ca.SX(body.mass), exact(body.mass * body.lever)
        second = exact(body.inertia - body.mass * _crossed(body.lever) @ _crossed(body.lever))
        if i == flange.parentJoint:
            added = _moved(load, flange.placement.rotation, flange.placement.translation)
            mass, first, second = mass + added[0], first + added[1], second + added[2]
        force = mass * a + ca.cross(dw, first) + ca.cross(w, ca.cross(w, first))
        moment = second @ dw + ca.cross(w, second @ w) + ca.cross(first, a)
        chain.append((slide, axis, R, p, force, moment))
    out: list[ca.SX] = []
    force, moment = ca.SX.zeros(3), ca.SX.zeros(3)
    for i in reversed(range(len(chain))):
        slide, axis, R, p, own_force, own_moment = chain[i]
        force, moment = force + own_force, moment + own_moment
        out.insert(0, ca.dot(slide, force) + ca.dot(axis, moment) + float(rotor[i]) * qdd[i])
        force, moment = R @ force, R @ moment + ca.cross(p, R @ force)
    return ca.vertcat(*out)


def _crossed(v: Array) -> Array:
    """The matrix (3, 3) of v x."""
    x, y, z = np.asarray(v, dtype=np.float64)
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _moved(load: ca.SX, R: Array, p: Array) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Mass, first and second moments of a load about the origin of the body that the flange is fixed to at R, p."""
    mass, first, upper = load[0], load[1:4], load[4:]
    inertia = ca.SX.zeros(3, 3)
    for k, (i, j) in enumerate(_UPPER):
        inertia[i, j] = inertia[j, i] = upper[k]
    turned, lever = exact(R) @ first, exact(p)
    # sum m (|r|^2 1 - r r^T) with r = R c + p
    mixed = 2 * ca.dot(turned, lever) * ca.SX.eye(3) - turned @ lever.T - lever @ turned.T
    own = mass * (ca.sumsqr(lever) * ca.SX.eye(3) - lever @ lever.T)
    return mass, turned + mass * lever, exact(R) @ inertia @ exact(R).T + mixed + own
