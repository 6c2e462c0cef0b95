"""Settings that change how the robot moves: modal state, shared by the motions between two changes."""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.motion import CirPathMode, Settings, Singularity
from trajopt_cli.rapid.data.datatypes import MOTSETDATA, PROGDISP, Value
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.arguments import Arguments, bind
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import still_moving
from trajopt_cli.rapid.execution.equipment import load
from trajopt_cli.rapid.execution.instructions.effect import Effect, Topic
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_LEAST_PATH_LIMIT, _NUM = 0.1, 1e-8  # m/s2, and the rounding of a num
_LEAST_ACCELERATION, _LEAST_RAMP = 20.0, 10.0  # percent; a controller takes lower values as these
_NO_LIMIT = -1.0  # what a controller shows of an acceleration that is not limited


def change(run: Context, settings: Settings) -> None:
    """Make settings those of the next moves; equal ones stay the same object."""
    if settings != run.settings:
        run.settings = settings
    publish(run)


def publish(run: Context) -> None:
    """Let C_PROGDISP and C_MOTSET hold what is in force, for a program to read (RAPID overview, system data).

    What of a motsetdata nothing here follows is refused where it is read (UNFOLLOWED in datatypes.py).
    """
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


def _exclusive(run: Context, node: ProcedureCall, args: Arguments, *names: str) -> None:
    given = [name for name in names if name in args.optional]
    if len(given) > 1:
        found = " and ".join(f"\\{name}" for name in given)
        raise run.error(node, f"{node.name} takes one of these, found {found}")


def _configuration(run: Context, node: ProcedureCall) -> None:
    r"""ConfJ or ConfL: on, unless \Off says otherwise."""
    on = "off" not in bind(run, node, (), ("On", "Off")).optional
    joint = node.name.lower() == "confj"
    change(run, replace(run.settings, conf_j=on) if joint else replace(run.settings, conf_l=on))


def _singularity(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("Wrist", "LockAxis4", "Off"))
    _exclusive(run, node, args, "wrist", "lockaxis4", "off")
    kind = Singularity.OFF
    if "wrist" in args.optional:
        kind = Singularity.WRIST
    elif "lockaxis4" in args.optional:
        kind = Singularity.LOCK_AXIS_4
    change(run, replace(run.settings, singularity=kind))


def _circle(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, (), tuple(mode.value for mode in CirPathMode))
    _exclusive(run, node, args, *(mode.value.lower() for mode in CirPathMode))
    given = next((mode for mode in CirPathMode if mode.value.lower() in args.optional), CirPathMode.PATH_FRAME)
    change(run, replace(run.settings, circle=given))


def _acceleration(run: Context, node: ProcedureCall) -> None:
    r"""\FinePointRamp: the ramp of the braking to a stop point is Ramp times this share (RAPID reference, AccSet). Like
    Ramp it shapes jerk and leaves the plan as it is."""
    args = bind(run, node, ("Acc", "Ramp"), ("FinePointRamp",))
    acc, ramp = args.required
    if (fine := args.optional.get("finepointramp")) is not None:
        share = run.number(fine)
        if not 0 < share <= 100:
            raise run.error(fine, f"AccSet takes a \\FinePointRamp above 0 and up to 100 %, found {share:.6g}")
        if share < 100:
            what = f"\\FinePointRamp:={share:.6g} makes the controller brake more gently to stop points, which takes"
            run.note(
                "finepointramp", WarningKind.NO_EFFECT, f"{what} longer; plans and estimates do not count it", node
            )
    change(
        run,
        replace(
            run.settings,
            acceleration=_percent(run, node, acc, _LEAST_ACCELERATION) / 100,
            ramp=_percent(run, node, ramp, _LEAST_RAMP) / 100,
        ),
    )


def _percent(run: Context, node: ProcedureCall, value: Expression, least: float) -> float:
    given = run.number(value)
    taken = min(max(given, least), 100.0)
    if taken != given:
        run.warn(
            WarningKind.ASSUMED,
            f"{node.name} takes {least:g}..100 %, found {given:.6g}; taken as {taken:g}",
            run.source(value),
        )
    return taken


def _velocity(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, ("Override", "Max"))
    percent, highest = (run.number(value) for value in args.required)
    if not 0 < percent <= 100:
        raise run.error(args.required[0], f"VelSet takes an override of 0..100 %, found {percent:.6g}")
    if not highest > 0:
        raise run.error(args.required[1], f"VelSet takes a highest speed above 0 mm/s, found {highest:.6g}")
    run.velset = (percent / 100, highest * MM)
    _pace(run)


def _pace(run: Context) -> None:
    """Speeds as VelSet asks, then that share of them that SpeedRefresh asks."""
    share, highest = run.velset
    v_max = None if highest is None else highest * run.refresh
    change(run, replace(run.settings, override=share * run.refresh, v_max=v_max))
    run.position.speeds.clear()


def _refresh(run: Context, node: ProcedureCall) -> None:
    """SpeedRefresh Override: a share of all speeds, of the move that runs and of those behind it, until another."""
    (argument,) = bind(run, node, ("Override",)).required
    percent = run.number(argument)
    if not 0 <= percent <= 100:
        raise run.fault(argument, "ERR_SPEED_REFRESH_LIM", f"SpeedRefresh takes 0..100 %, found {percent:.6g}")
    if percent == 0:
        raise run.error(argument, "SpeedRefresh 0 stops the robot until another task sets a higher value; leave it out")
    if still_moving(run) is not None:
        what = "SpeedRefresh also changes the move that runs at that moment; here it counts from the next move on"
        run.warn(WarningKind.ASSUMED, what, run.source(node))
    run.refresh = percent / 100
    _pace(run)


def _path_limits(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, ("AccLim", "DecelLim"), ("AccMax", "DecelMax"))
    first, second = args.required
    change(
        run,
        replace(
            run.settings,
            path_acceleration=_limit(run, node, first, args, "AccMax"),
            path_deceleration=_limit(run, node, second, args, "DecelMax"),
        ),
    )


def _limit(run: Context, node: ProcedureCall, switch: Expression, args: Arguments, name: str) -> float | None:
    if not run.condition(switch):
        return None
    value = args.optional.get(name.lower())
    if value is None:
        raise run.error(switch, f"{node.name} TRUE needs \\{name} in m/s2")
    limit = run.number(value)
    if not limit >= _LEAST_PATH_LIMIT - _NUM:
        message = f"{node.name} takes \\{name} of at least {_LEAST_PATH_LIMIT:g} m/s2, found {limit:.6g}; a controller "
        raise run.fault(value, "ERR_ACC_TOO_LOW", f"{message}stops with ERR_ACC_TOO_LOW")
    return limit


def _positive(run: Context, node: ProcedureCall, value: Expression) -> float:
    limit = run.number(value)
    if not limit > 0:
        raise run.error(value, f"{node.name} takes an acceleration above 0 m/s2, found {limit:.6g}")
    return limit


def _world_limit(run: Context, node: ProcedureCall) -> None:
    args = bind(run, node, (), ("On", "Off"))
    value = args.optional.get("on")
    if "on" in args.optional and value is None:
        raise run.error(node, "WorldAccLim \\On needs a value in m/s2, such as WorldAccLim \\On:=3.5")
    limit = None if value is None else _positive(run, node, value)
    change(run, replace(run.settings, world_acceleration=limit))


def _grip_load(run: Context, node: ProcedureCall) -> None:
    (argument,) = bind(run, node, ("Load",)).required
    change(run, replace(run.settings, load=load(run, argument)))


INSTRUCTIONS: Topic = {
    Effect.RUN: {
        "ConfJ": _configuration,
        "ConfL": _configuration,
        "AccSet": _acceleration,
        "VelSet": _velocity,
        "SpeedRefresh": _refresh,
        "SingArea": _singularity,
        "PathAccLim": _path_limits,
        "WorldAccLim": _world_limit,
        "GripLoad": _grip_load,
        "CirPathMode": _circle,
    }
}
