"""Which links of an arm that has moved were in an obstacle: looked at afterwards, nothing is pushed back."""

from __future__ import annotations

from trajopt_cli.geometry import Array
from trajopt_cli.iiwa.task.model import Contact
from trajopt_cli.iiwa.task.world import LinkContact
from trajopt_cli.proximity.pair import Pair
from trajopt_cli.robot.srs import SrsRobot

EVERY = 10
"""Of so many periods one is looked at: a link at 1 m/s goes 10 mm in between with periods of 1 ms."""


def link_contacts(robot: SrsRobot, q: Array, contact: Contact, h: float) -> tuple[LinkContact, ...]:
    """The capsules of all links that move against the obstacles at joints q (n, 7) [rad], a row every h [s].

    Every tenth row is looked at, and the last; force is None, as nothing is pushed back.
    """
    rows = sorted({*range(0, len(q), EVERY), len(q) - 1})
    X = dict(zip(robot.link_names, robot.links(q[rows]).swapaxes(0, 1), strict=True))
    found = []
    for link in robot.link_names[1:]:
        if link not in robot.capsules:
            continue
        for obstacle in contact.obstacles:
            box = obstacle.box
            depth = -Pair(robot.capsules[link], box).distances(X[link])
            inside = [i for i, deep in enumerate(depth.tolist()) if deep > 0]
            if inside:
                first, last = (rows[i] * h for i in (inside[0], inside[-1]))
                found.append(LinkContact(link, box.name, first, last, float(depth.max()), None))
    return tuple(sorted(found, key=lambda one: one.first))
