"""The data every controller has: speeds, zones, tool0, wobj0, load0. Figures as in ABB's reference manual."""

from __future__ import annotations

from functools import cache
from math import pi

from trajopt_cli.rapid.datatypes import (
    LOADDATA,
    NUM,
    SPEEDDATA,
    TOOLDATA,
    WOBJDATA,
    ZONEDATA,
    Data,
    Type,
    Value,
)

_SPEEDS = (
    5, 10, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 400, 500, 600, 800,
    1000, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7000,
)  # fmt: skip
# vmax on a controller is the robot's own highest TCP speed; 5 m/s is what ABB gives for robots without a figure.
VMAX = 5000.0  # mm/s
_V_ORI, _V_LEAX, _V_REAX = 500.0, 5000.0, 1000.0  # deg/s, mm/s, deg/s

# pzone_tcp, pzone_ori, pzone_eax [mm], zone_ori [deg], zone_leax [mm], zone_reax [deg]. z0 is a fly-by, not a stop.
_ZONES = {
    "z0": (0.3, 0.3, 0.3, 0.03, 0.3, 0.03),
    "z1": (1, 1, 1, 0.1, 1, 0.1),
    "z5": (5, 8, 8, 0.8, 8, 0.8),
    "z10": (10, 15, 15, 1.5, 15, 1.5),
    "z15": (15, 23, 23, 2.3, 23, 2.3),
    "z20": (20, 30, 30, 3.0, 30, 3.0),
    "z30": (30, 45, 45, 4.5, 45, 4.5),
    "z40": (40, 60, 60, 6.0, 60, 6.0),
    "z50": (50, 75, 75, 7.5, 75, 7.5),
    "z60": (60, 90, 90, 9.0, 90, 9.0),
    "z80": (80, 120, 120, 12, 120, 12),
    "z100": (100, 150, 150, 15, 150, 15),
    "z150": (150, 225, 225, 23, 225, 23),
    "z200": (200, 300, 300, 30, 300, 30),
}

_IDENTITY: Data = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))
_LOAD0: Data = (0.001, (0.0, 0.0, 0.001), (1.0, 0.0, 0.0, 0.0), 0.0, 0.0, 0.0)


@cache
def predefined() -> dict[str, Value]:
    """Values by name in lower case."""
    table: dict[str, tuple[Type, Data]] = {
        "pi": (NUM, pi),
        "load0": (LOADDATA, _LOAD0),
        "tool0": (TOOLDATA, (True, _IDENTITY, _LOAD0)),
        "wobj0": (WOBJDATA, (False, True, "", _IDENTITY, _IDENTITY)),
        "fine": (ZONEDATA, (True, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
        "vmax": (SPEEDDATA, (VMAX, _V_ORI, _V_LEAX, _V_REAX)),
        # Names for the states of signals.
        **{name: (NUM, 1.0) for name in ("high", "on")},
        **{name: (NUM, 0.0) for name in ("low", "off")},
    }
    table |= {f"v{v}": (SPEEDDATA, (float(v), _V_ORI, _V_LEAX, _V_REAX)) for v in _SPEEDS}
    table |= {f"vrot{v}": (SPEEDDATA, (0.0, 0.0, 0.0, float(v))) for v in (1, 2, 5, 10, 20, 50, 100)}
    table |= {f"vlin{v}": (SPEEDDATA, (0.0, 0.0, float(v), 0.0)) for v in (10, 20, 50, 100, 200, 500, 1000)}
    table |= {name: (ZONEDATA, (False, *map(float, sizes))) for name, sizes in _ZONES.items()}
    return {name: Value(type_, data) for name, (type_, data) in table.items()}


# Predefined data that a program may change.
VARIABLES: dict[str, Type] = {f"reg{i}": NUM for i in range(1, 6)}
