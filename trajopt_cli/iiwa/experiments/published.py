"""What the thesis prints: its tables, by section. Cihala, Poddajne rizeni prumysloveho robota, CVUT 2020.

Its forces over time, its paths and its loop times (but for the worst) are only in figures and are not here.
"""

from __future__ import annotations

Three = tuple[float, float, float]
Flange = tuple[tuple[float, ...], tuple[float, ...]]
"""Largest and mean distance of the flange from the controller's pose, by axis [m or rad]."""

SPEED = ((0.05, 0.043), (0.1, 0.089), (0.2, 0.163), (0.4, 0.233), (0.75, 0.275), (1.0, 0.295))
"""Table 6.10: v_max [m/s] and the largest deviation d [m], eq. 6.8."""
STIFFNESS = ((2000.0, 0.115), (1000.0, 0.147), (500.0, 0.178), (200.0, 0.212), (100.0, 0.239))
"""Table 6.11: k [N/m] and the largest d [m]."""
DAMPING = ((100.0, 0.0343), (200.0, 0.0611), (500.0, 0.105), (1000.0, 0.170), (2000.0, 0.215))
"""Table 6.12: d [N s/m] and the largest d [m]."""

FLANGE_STIFFNESS: dict[float, Flange] = {
    100.0: ((7.3e-4, 8.7e-4, 11.6e-4), (0.7e-4, 0.4e-4, 0.7e-4)),
    500.0: ((7.5e-4, 8.0e-4, 15.6e-4), (0.4e-4, 0.2e-4, 0.4e-4)),
}
"""Table 6.1, by stiffness [N/m]."""
FLANGE_DAMPING: dict[float, Flange] = {
    50.0: ((0.2e-3, 0.5e-3, 1.1e-3), (0.04e-3, 0.03e-3, 0.13e-3)),
    200.0: ((0.4e-3, 1.3e-3, 1.5e-3), (0.05e-3, 0.05e-3, 0.06e-3)),
}
"""Table 6.4, by damping [N s/m]."""
FLANGE_ORIENTATION: Flange = ((0.0075, 0.0074, 0.0092), (0.0009, 0.0009, 0.0003))
"""Table 6.7 [rad]."""
FLANGE_ALL: Flange = (
    (0.0013, 0.0016, 0.0018, 0.0044, 0.0043, 0.0023),
    (0.0002, 0.0003, 0.0003, 0.0008, 0.0007, 0.0004),
)
"""Table 6.8."""

LOOP_WORST = 148e-6
"""Longest period of the loop [s], C++ on an Intel i3-7100T at 3.4 GHz (section 6.3)."""

FORCE_ERROR: dict[str, Three] = {
    "6.1.1, k = 100 N/m": (7.0, 4.0, 5.0),
    "6.1.1, k = 500 N/m": (5.0, 3.0, 4.0),
    "6.1.2, d = 50 N s/m": (6.0, 4.0, 6.0),
    "6.1.2, d = 200 N s/m": (7.0, 4.0, 5.0),
}
"""Tables 6.2 and 6.5: largest error of the robot's force along x, y, z against a force gauge [N], each +-1 N."""
FLANGE_WORST: Flange = (
    (0.0021, 0.0016, 0.0018, 0.0075, 0.0074, 0.0092),
    (0.0002, 0.0003, 0.0003, 0.0009, 0.0009, 0.0004),
)
"""Table 6.9: the worst of sections 6.1.1 to 6.1.4, those led by hand among them."""
FLANGE_EARLIER: tuple[Three, Three] = ((0.0701, 0.0600, 0.0656), (0.0023, 0.0013, 0.0024))
"""Table 6.9: the same of translation in the earlier work that the thesis builds on, a spring without damper [m]."""
