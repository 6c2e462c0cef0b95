"""C_PROGDISP and C_MOTSET: the displacements and motion settings in force, as data that a program may read.

RAPID overview, system data: predefined, read only, kept by the controller. What of a motsetdata nothing here follows is
refused where it is read (UNFOLLOWED in datatypes.py).
"""

from __future__ import annotations

from trajopt_cli.motion import Singularity
from trajopt_cli.rapid.data.datatypes import MOTSETDATA, PROGDISP, Value
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.units import MM

_NO_LIMIT = -1.0  # what a controller shows of an acceleration that is not limited


def publish(run: Context) -> None:
    """Let C_PROGDISP and C_MOTSET hold what is in force now."""
    settings = run.settings
    run.progdisp.value = Value(PROGDISP, (run.position.displacement or IDENTITY, settings.eax_offset))
    override, highest = run.velset
    wrist, axis_4 = (settings.singularity is kind for kind in (Singularity.WRIST, Singularity.LOCK_AXIS_4))
    limits = (settings.path_acceleration, settings.path_deceleration, settings.world_acceleration)
    acc, dec, world = ((limit is not None, _NO_LIMIT if limit is None else limit) for limit in limits)
    run.motset.value = Value(
        MOTSETDATA,
        (
            (override * 100, VMAX if highest is None else highest / MM),
            (settings.acceleration * 100, settings.ramp * 100, 100.0),
            (wrist, axis_4, False, not (wrist or axis_4)),
            (settings.conf_j, settings.conf_l, 0.0, 0.0, 0.0),
            *(100.0, True, 100.0),
            *(*acc, *dec, 0.0, *world, False, False),
        ),
    )
