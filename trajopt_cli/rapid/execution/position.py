"""Where the robot stands while a program is read: what CRobT, PDispOn, EOffsOn and searches start from.

In RAPID's units: frames in mm, external axes in mm or deg. A move to a pose leaves the joints unknown until somebody
asks, a move to joints leaves the pose unknown; what is not known is asked of the robot, if there is one.
"""

from __future__ import annotations

from trajopt_cli.kinematics import Kinematics


class Position:
    """The robot's place after the motions so far."""

    def __init__(self, kinematics: Kinematics | None):
        self.kinematics = kinematics
