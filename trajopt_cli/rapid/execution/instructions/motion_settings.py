"""How a move goes, wherever it goes to: tool and work object, speed, zone and time, from an instruction's arguments.

A program of a hundred thousand moves says the same few things again and again. What one says is found again by the
names of its arguments, as long as each name still stands for the very same data.
"""

from __future__ import annotations

from trajopt_cli.motion import Speed
from trajopt_cli.rapid.data.datatypes import LOADDATA
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.arguments import Arguments
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.equipment import data_of, setup_of
from trajopt_cli.rapid.execution.instructions import speed_settings
from trajopt_cli.rapid.execution.position import Known, Manner
from trajopt_cli.rapid.language.syntax import Expression, Name
from trajopt_cli.warnings import WarningKind


def manner(
    run: Context,
    speed: Expression,
    zone: Expression | None,
    tool: Expression,
    args: Arguments,
    fixed: Speed | None = None,
) -> Manner:
    """The manner of a move. zone None: a stop. fixed: in place of the instruction's own speed."""
    if not (isinstance(speed, Name) and isinstance(zone, Name) and isinstance(tool, Name)) or fixed is not None:
        return _manner(run, speed, zone, tool, args, fixed)
    names: tuple[str, ...] = (speed.name, zone.name, tool.name)
    if args.optional:
        wobj = args.optional.get("wobj")
        if not isinstance(wobj, Name) or len(args.optional) > 1:
            return _manner(run, speed, zone, tool, args, None)
        names = (*names, wobj.name)
    position = run.position
    known = position.manners.get(names)
    if known is not None and known.settings is run.settings and known.displacement is position.displacement:
        find = run.find
        for name, data in known.data:
            place = find(name)
            if type(place) is not Datum or place.value.data is not data:
                break
        else:
            return known.manner
    made = _manner(run, speed, zone, tool, args, None)
    places = [run.find(name) for name in names]
    data = tuple([(name, place.value.data) for name, place in zip(names, places, strict=True) if type(place) is Datum])
    if len(data) == len(names):
        position.manners[names] = Known(run.settings, position.displacement, data, made)
    return made


def _manner(
    run: Context, speed: Expression, zone: Expression | None, tool: Expression, args: Arguments, fixed: Speed | None
) -> Manner:
    setup = setup_of(run, tool, args.optional.get("wobj"))
    _note_unplanned(run, speed, args)
    return Manner(
        setup,
        fixed or speed_settings.speed(run, speed, args),
        speed_settings.FINE if zone is None else speed_settings.zone(run, zone, args),
        speed_settings.duration(run, args),
    )


def _note_unplanned(run: Context, place: Expression, args: Arguments) -> None:
    r"""\TLoad, the total load of one move, and \Corr, a sensor's correction of its path: no plan looks at them."""
    node = args.optional.get("tload")
    if node is not None:
        data_of(run, node, LOADDATA, "load", "load0")
        run.note(
            "tload", WarningKind.NO_EFFECT, "\\TLoad changes nothing here; the cell's limits hold for any load", node
        )
    if "corr" in args.optional:
        what = "\\Corr adds what a sensor finds to the path, which is not known here: the path stays as written"
        run.note("corr", WarningKind.NO_EFFECT, what, place)
