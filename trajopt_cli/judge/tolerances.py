"""What the judge lets pass, each number with its reason; and with it the smallest offence that is sure to be seen.

The promise holds for files as we write them: speeds, 17 digits, rows of 1 kHz and one at every motion boundary and
every switch of an axis' acceleration. An offence 1.1 times a number below is called illegal there. A foreign file is
judged with the same numbers plus what its printed digits and its missing rows leave open; see samples.py.
"""

from __future__ import annotations

JOINT = 1e-6
"""Relative excess of a joint limit (of the range for positions): solvers stop at 1e-8, drives are tuned to 1e-3.
Between the rows of a line the Hermite's own truncation comes on top, 1e-4 at most; see samples.truncation."""

TORQUE = 1e-5
"""Relative excess of a torque limit, besides what printing and the Hermite between rows leave open of accelerations;
see torques.py. Plans keep 3e-5 below it between their samples; a robot's masses are known to percents."""

TCP = 1e-4
"""Relative excess of a TCP cap. The cap is a data-sheet figure of two digits; the Hermite's TCP acceleration between
rows of 1 kHz is good to 3e-5 of it."""

LINE_POSITION = 1e-6
"""Distance from the chord or the circle, and in a corner from the zone's sphere and from the triangle of entry, point
and exit, m: a thirtieth of the robot's repeatability (0.03 mm)."""

LINE_ROTATION = 1e-6
"""Angle from the programmed orientation, and in a corner of the rotation vector from its triangle, rad: 1 um at a lever
of 1 m."""

BACKWARD = 1e-6
"""Way back along a line or an arc, outside zones, against the farthest point reached so far, m (rad on a pure
reorientation)."""

STOP_POSITION = 1e-6
"""Distance from a programmed point where the motion counts as there, m; also what it may drift in a dwell."""

STOP_ROTATION = 1e-6
"""Angle from a programmed orientation, rad."""

REST_LINEAR = 1e-5
"""TCP speed that counts as rest, m/s: 10 nm in a row of 1 kHz."""

REST_ANGULAR = 1e-5
"""Angular speed of the tool that counts as rest, rad/s."""

REST_JOINT = 1e-5
"""Axis speed that counts as rest, rad/s or m/s, where every axis must stand."""

JOINT_TARGET = 1e-6
"""Distance from programmed axis values (MoveAbsJ, fixed rail, start), rad or m."""

NEAREST = 1e-6
"""How much farther than in the nearest posture a joint move under ConfJ \\Off may end, rad: of two that are equally
near rounding decides."""

HELD = 1e-6
"""Way of a rail that must stand still, m, from its least to its greatest position, and of an axis off where its
leader takes it: that of a stop's drift, a thirtieth of the robot's repeatability (0.03 mm); plans keep it to their
printed digits."""

FOLLOWER_TARGET = 1e-4
"""Distance of an axis in a target from where the one that leads it takes it, m: backups hold measured values."""

DWELL = 1e-9
"""What may be missing from a programmed wait, s: rounding of sums of times."""

DURATION = 1e-6
"""What a motion with a programmed time may take more or less, s."""

COMPUTED = 1e-12
"""Rounding of whoever computed the positions and speeds (rad, m, 1/s), however many digits are printed: a closed-form
inverse near a singular wrist loses four of sixteen digits."""

LARGEST_GAP = 0.02
"""Rows farther apart than this cannot show a stop, s: at 20 m/s2 the nearest row may be 1 mm away from it."""

COARSEST_PRINT = 1e-4
"""Printed digits that leave the TCP more uncertain than this cannot show a line, m."""

COARSEST_TURN = 1e-3
"""Printed digits that leave the tool's orientation more uncertain than this cannot show a slerp, rad: 0.1 mm at 0.1 m
from the TCP, as COARSEST_PRINT."""

COARSEST_RATE = 0.03
"""Printed digits and times that hide a motion so much too fast cannot show a limit on speed; twice as much of one on
acceleration and three times of one on jerk, which such a motion exceeds by so much."""
