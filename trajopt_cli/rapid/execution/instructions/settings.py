"""Settings that change how the robot moves: modal state, shared by the motions between two changes."""

from __future__ import annotations

from dataclasses import replace

from trajopt_cli.motion import CirPathMode, Settings, Singularity
from trajopt_cli.rapid.data.datatypes import MOTSETDATA, PROGDISP, Value
from trajopt_cli.rapid.data.frames import IDENTITY
from trajopt_cli.rapid.data.predefined import VMAX
from trajopt_cli.rapid.execution.arguments import Effect, Refused, Topic
from trajopt_cli.rapid.execution.context import Context
from trajopt_cli.rapid.execution.current_position import still_moving
from trajopt_cli.rapid.execution.equipment import load
from trajopt_cli.rapid.language.syntax import Expression, ProcedureCall
from trajopt_cli.units import MM
from trajopt_cli.warnings import WarningKind

_LEAST_PATH_LIMIT, _NUM = 0.1, 1e-8  # m/s2, and the rounding of a num
_LEAST_ACCELERATION, _LEAST_RAMP = 20.0, 10.0  # percent; a controller takes lower values as these
_NO_LIMIT = -1.0  # what a controller shows of an acceleration that is not limited
_TOPIC = Topic(__doc__, load=load)


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


def _only(node: ProcedureCall, options: dict[str, bool]) -> str:
    """The one switch that is given, in lower case, "" for none."""
    if len(options) > 1:
        found = " and ".join(f"\\{name}" for name in options)
        raise Refused(f"{node.name} takes one of these, found {found}")
    return next(iter(options), "")


@_TOPIC.instruction(Effect.RUN, r"ConfJ \On \Off", r"ConfL \On \Off")
def _configuration(run: Context, node: ProcedureCall, on: bool = True, off: bool = False) -> None:
    r"""ConfJ or ConfL: on, unless \Off says otherwise."""
    settings = run.settings
    joint = node.name.lower() == "confj"
    change(run, replace(settings, conf_j=not off) if joint else replace(settings, conf_l=not off))


@_TOPIC.instruction(Effect.RUN, r"SingArea \Wrist \LockAxis4 \Off")
def _singularity(run: Context, node: ProcedureCall, **options: bool) -> None:
    kinds = {"wrist": Singularity.WRIST, "lockaxis4": Singularity.LOCK_AXIS_4}
    change(run, replace(run.settings, singularity=kinds.get(_only(node, options), Singularity.OFF)))


@_TOPIC.instruction(Effect.RUN, " ".join(["CirPathMode", *(f"\\{mode.value}" for mode in CirPathMode)]))
def _circle(run: Context, node: ProcedureCall, **options: bool) -> None:
    modes = {mode.value.lower(): mode for mode in CirPathMode}
    change(run, replace(run.settings, circle=modes.get(_only(node, options), CirPathMode.PATH_FRAME)))


@_TOPIC.instruction(Effect.RUN, r"AccSet Acc:num Ramp:num \FinePointRamp:num")
def _acceleration(
    run: Context, node: ProcedureCall, acceleration: float, ramp: float, finepointramp: float = 100.0
) -> None:
    r"""\FinePointRamp: the ramp of the braking to a stop point is Ramp times this share (RAPID reference, AccSet). Like
    Ramp it shapes jerk and leaves the plan as it is."""
    if not 0 < finepointramp <= 100:
        message = f"AccSet takes a \\FinePointRamp above 0 and up to 100 %, found {finepointramp:.6g}"
        raise Refused(message, "FinePointRamp")
    if finepointramp < 100:
        what = (
            f"\\FinePointRamp:={finepointramp:.6g} makes the controller brake more gently to stop points, which takes"
        )
        what += " longer; plans and estimates do not count it"
        run.note("finepointramp", WarningKind.NO_EFFECT, what, node)
    taken = [
        _percent(run, node, given, least) for given, least in ((acceleration, _LEAST_ACCELERATION), (ramp, _LEAST_RAMP))
    ]
    change(run, replace(run.settings, acceleration=taken[0] / 100, ramp=taken[1] / 100))


def _percent(run: Context, node: ProcedureCall, given: float, least: float) -> float:
    taken = min(max(given, least), 100.0)
    if taken != given:
        what = f"{node.name} takes {least:g}..100 %, found {given:.6g}; taken as {taken:g}"
        run.warn(WarningKind.ASSUMED, what, run.source(node))
    return taken


@_TOPIC.instruction(Effect.RUN, "VelSet Override:num Max:num")
def _velocity(run: Context, node: ProcedureCall, percent: float, highest: float) -> None:
    if not 0 < percent <= 100:
        raise Refused(f"VelSet takes an override of 0..100 %, found {percent:.6g}", "Override")
    if not highest > 0:
        raise Refused(f"VelSet takes a highest speed above 0 mm/s, found {highest:.6g}", "Max")
    run.velset = (percent / 100, highest * MM)
    _pace(run)


def _pace(run: Context) -> None:
    """Speeds as VelSet asks, then that share of them that SpeedRefresh asks."""
    share, highest = run.velset
    v_max = None if highest is None else highest * run.refresh
    change(run, replace(run.settings, override=share * run.refresh, v_max=v_max))


@_TOPIC.instruction(Effect.RUN, "SpeedRefresh Override:num")
def _refresh(run: Context, node: ProcedureCall, percent: float) -> None:
    """SpeedRefresh Override: a share of all speeds, of the move that runs and of those behind it, until another."""
    if not 0 <= percent <= 100:
        message = f"SpeedRefresh takes 0..100 %, found {percent:.6g}"
        raise Refused(message, "Override", "ERR_SPEED_REFRESH_LIM")
    if percent == 0:
        message = "SpeedRefresh 0 stops the robot until another task sets a higher value; leave it out"
        raise Refused(message, "Override")
    if still_moving(run) is not None:
        what = "SpeedRefresh also changes the move that runs at that moment; here it counts from the next move on"
        run.warn(WarningKind.ASSUMED, what, run.source(node))
    run.refresh = percent / 100
    _pace(run)


@_TOPIC.instruction(Effect.RUN, r"PathAccLim AccLim:bool DecelLim:bool \AccMax:expr \DecelMax:expr")
def _path_limits(
    run: Context,
    node: ProcedureCall,
    accelerating: bool,
    braking: bool,
    accmax: Expression | None = None,
    decelmax: Expression | None = None,
) -> None:
    first = _limit(run, node, accelerating, accmax, "AccLim", "AccMax")
    second = _limit(run, node, braking, decelmax, "DecelLim", "DecelMax")
    change(run, replace(run.settings, path_acceleration=first, path_deceleration=second))


def _limit(
    run: Context, node: ProcedureCall, on: bool, value: Expression | None, switch: str, name: str
) -> float | None:
    if not on:
        return None
    if value is None:
        raise Refused(f"{node.name} TRUE needs \\{name} in m/s2", switch)
    limit = run.number(value)
    if not limit >= _LEAST_PATH_LIMIT - _NUM:
        message = f"{node.name} takes \\{name} of at least {_LEAST_PATH_LIMIT:g} m/s2, found {limit:.6g}; a controller "
        raise Refused(f"{message}stops with ERR_ACC_TOO_LOW", name, "ERR_ACC_TOO_LOW")
    return limit


@_TOPIC.instruction(Effect.RUN, r"WorldAccLim \On:num \Off")
def _world_limit(run: Context, node: ProcedureCall, on: float | None = None, off: bool = False) -> None:
    if on is None and not off and not all(arg.forward for arg in node.args):
        raise Refused("WorldAccLim \\On needs a value in m/s2, such as WorldAccLim \\On:=3.5")
    if on is not None and not on > 0:
        raise Refused(f"{node.name} takes an acceleration above 0 m/s2, found {on:.6g}", "On")
    change(run, replace(run.settings, world_acceleration=on))


_TOPIC.instruction(Effect.RUN, "GripLoad Load:load")(
    lambda run, node, carried: change(run, replace(run.settings, load=carried))
)
