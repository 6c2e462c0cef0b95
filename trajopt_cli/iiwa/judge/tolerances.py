"""What the judge of the compliant job lets pass, each number with its reason; an offence 1.1 times one is called.

Printed digits and rows farther apart than the controller's period come on top; see samples.py.
"""

from __future__ import annotations

import math

EXACT = 1e-12
"""Distance [m, rad] of what has to be the same number: first and last pose, the two files of a sequence, rows of a
dwell. Numbers of size 1 are printed in 17 digits, and a sum over poses or a turn of axes rounds in the fifteenth."""

PATH = 1e-6
"""Distance from the path between two poses, m, and angle from the orientation there, rad; also within which a pose
counts as reached. A hundredth of the arm's repeatability (0.1 mm), and as much at a lever of 1 m."""

BACKWARD = 1e-9
"""Way back along the path against the farthest point reached so far, m or rad: a thousandth of the slowest step anybody
programs (1 mm/s at 1 kHz)."""

CAP = 1e-9
"""Relative excess of a step over v_max h or omega_max h: steps on the cap are rounded differences of coordinates."""

RAMP = 1e-6
"""Relative excess of a_max, epsilon_max and the jerks: differences of differences lose that many digits more."""

ARM_CAP = 1e-3
"""The same of joints that anybody wrote, whose rows may stand between those of the sequence: from row to row
joints turn evenly, the tool not quite (1e-4 of a_max at 1 kHz), and the caps are numbers of two or three digits."""

ROUNDING = 4e-15
"""How far rounding leaves a coordinate off, m (times its size above 1 m) or rad (over cos beta for three angles); what
a difference makes of it is granted."""

SIMULATED = 1e-8
"""How far the columns of a simulation may be off, m or rad: they are printed in ten digits, and so are the forces that
move it: 1e-8 N of 100 N for a time constant are 1e-11 m."""

SIMULATED_JOINTS = 1e-7
"""The same of where its joints put the tool, m plus rad: seven of them in ten digits, 1 m from the tool."""

FELT, FELT_SHARE = 0.01, 2e-3
"""How far forces may be off, N or Nm, and as a share: speeds are differences of printed rows, and friction knows 2000 N
a m/s; from row to row joints turn evenly, the tool not quite."""

PROMISED = 1e-6
"""Relative excess over a lag or a push that dosing promises: sums over all rows round elsewhere."""

ARRIVED = 1e-3, math.radians(0.1)
"""Distance [m] and turn [rad] from its end at which an arm counts as arrived, as the manual has it."""

PUSH_KEPT = 0.2
"""Share by which dosing may change the push on what is touched, as the manual has it."""

PERIOD = 1e-9
"""What a row's time may be off its place on the grid, s: an hour in periods of 1 ms, printed in 15 digits, is right to
1e-11 s; files of others print nine decimals."""

FOLLOW = 1e-9
"""Distance [m] and angle [rad] between the tool at a row's joints and the pose of that row. A closed form's joints are
right to 1e-13 rad, near singularities to 1e-11 rad; the arm's reach is about 1 m."""

BETWEEN = 1e-4
"""Distance [m] and angle [rad] of the tool half way between two rows' joints from half way between their poses: the
arm's repeatability (0.1 mm). At 1 m/s and 1 kHz a joint motion bends by less than a hundredth of it."""

JOINT = 1e-6
"""Relative excess of a joint limit (of the range for positions), as in the other judge."""

ARM_ANGLE = 1e-6
"""How far a constant arm angle may be off, rad: 0.4 um at the elbow."""

START = 1e-6
"""How far the first row's joints may be off the start's where both are the same pose, rad."""

REST = 1e-5
"""Joint speed that counts as rest, rad/s: 10 nrad in a row of 1 kHz."""

SLACK = 2
"""Rows by which a dwell may seem longer than asked for: the first and the last row of a smooth ramp can lie within
rounding of the pose."""
PRESSED = 0.05
"""Of a force by which an equilibrium may press otherwise: what the task's obstacle gives is taken up to here."""
