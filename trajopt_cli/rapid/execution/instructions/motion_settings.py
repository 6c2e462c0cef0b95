r"""How a move goes, wherever it goes to: tool and work object, speed, zone and time, from an instruction's arguments.

Speeddata with \V and \T, zonedata with \Z and \Inpos, in SI units. A program of a hundred thousand moves says the same
few things again and again: what one says is found again by the names of its arguments, as long as each name still
stands for the very same data.
"""

from __future__ import annotations

from math import isfinite

from trajopt_cli.motion import Speed, Zone
from trajopt_cli.rapid.data.datatypes import LOADDATA, SPEEDDATA, ZONEDATA
from trajopt_cli.rapid.data.scope import Datum
from trajopt_cli.rapid.execution.arguments import Arguments
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.equipment import data_of, setup_of, value_of
from trajopt_cli.rapid.execution.position import Known, Manner
from trajopt_cli.rapid.language.syntax import Expression, Name
from trajopt_cli.units import DEG, MM
from trajopt_cli.warnings import WarningKind

FINE = Zone("fine", stop=True)
# stoppointdata that every controller has.
STOP_POINTS = frozenset(
    (
        *("inpos20", "inpos50", "inpos100", "stoptime0_5", "stoptime1_0", "stoptime1_5"),
        *("fllwtime0_5", "fllwtime1_0", "fllwtime1_5"),
    )
)


def speed_of(run: Context, node: Expression, args: Arguments, external: bool = False) -> Speed:
    r"""Speed in SI with VelSet applied; \V replaces the TCP speed. external: the TCP speed does not count."""
    name, data = run.text(node), value_of(run, node, SPEEDDATA).data
    override = args.optional.get("v")
    v_tcp, v_ori, v_leax, v_reax = data
    if override is not None:
        v_tcp = run.number(override)
    if not external and "t" not in args.optional and not v_tcp > 0:
        of = name if override is None else "\\V"
        raise run.error(override or node, f"TCP speed {v_tcp:.6g} mm/s of {of} must be above 0")
    settings = run.settings
    share = settings.override
    values = (v_tcp * MM * share, v_ori * DEG * share, v_leax * MM * share, v_reax * DEG * share)
    if not all(isfinite(v) and v >= 0 for v in values):
        raise run.error(node, f"speeddata {name} has a negative speed")
    if settings.v_max is not None and values[0] > settings.v_max:
        return Speed(name, settings.v_max, *values[1:])
    return Speed(name, *values)


def duration_of(run: Context, args: Arguments) -> float | None:
    r"""The programmed time \T [s]; VelSet slows it down as it does speeds."""
    node = args.optional.get("t")
    if node is None:
        return None
    seconds = run.number(node)
    if not seconds > 0:
        raise run.error(node, f"duration \\T:={seconds:.6g} s must be above 0")
    return seconds / run.settings.override


def zone_of(run: Context, node: Expression, args: Arguments) -> Zone:
    r"""Accuracy; \Inpos makes a stop of any zone, \Z replaces the radius of the TCP's path."""
    name, data = run.text(node), value_of(run, node, ZONEDATA).data
    finep, *sizes = data
    if "inpos" in args.optional:
        return Zone(name, stop=True, criterion=_criterion(run, node, args))
    if finep:
        return Zone(name, stop=True)
    override = args.optional.get("z")
    if override is not None:
        sizes[0] = run.number(override)
    radius, path_ori, path_eax, ori, leax, reax = sizes
    if not radius >= 0:
        raise run.error(override or node, f"zone radius {radius:.6g} mm must not be negative")
    if min(sizes) < 0:
        raise run.error(node, f"zonedata {name} has a negative size")
    return Zone(
        name,
        stop=False,
        radius=radius * MM,
        path_ori=path_ori * MM,
        path_eax=path_eax * MM,
        ori=ori * DEG,
        leax=leax * MM,
        reax=reax * DEG,
    )


def _criterion(run: Context, node: Expression, args: Arguments) -> str:
    given = args.optional["inpos"]
    if given is None:
        raise run.error(node, "\\Inpos needs stoppointdata, such as \\Inpos:=inpos50")
    if isinstance(given, Name) and given.name.lower() not in STOP_POINTS and run.find(given.name) is None:
        known = ", ".join(sorted(STOP_POINTS))
        raise run.error(given, f"stoppointdata '{given.name}' is not declared in the program; predefined: {known}")
    return run.text(given)


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
        fixed or speed_of(run, speed, args),
        FINE if zone is None else zone_of(run, zone, args),
        duration_of(run, args),
    )


def _note_unplanned(run: Context, place: Expression, args: Arguments) -> None:
    r"""\TLoad, the total load of one move, and \Corr, a sensor's correction of its path: no plan looks at them."""
    node = args.optional.get("tload")
    if node is not None:
        data_of(run, node, LOADDATA)
        what = "\\TLoad changes nothing here; the cell's limits hold for any load"
        run.note("tload", WarningKind.NO_EFFECT, what, node)
    if "corr" in args.optional:
        what = "\\Corr adds what a sensor finds to the path, which is not known here: the path stays as written"
        run.note("corr", WarningKind.NO_EFFECT, what, place)
