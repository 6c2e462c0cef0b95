"""All of chapter 6 at once: the table of experiments, and the run that takes them in turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

from trajopt_cli.iiwa.experiments.collision import Collision, collision
from trajopt_cli.iiwa.experiments.feed_scheduling import Dosing, dosing
from trajopt_cli.iiwa.experiments.following import FollowTable, damping, speed, stiffness
from trajopt_cli.iiwa.experiments.force_error import ForceErrors, force_error
from trajopt_cli.iiwa.experiments.guiding import Guided, Zeroed, guiding, zeroing
from trajopt_cli.iiwa.experiments.loop_time import LoopTimes, loop_time
from trajopt_cli.iiwa.experiments.setup import Bench
from trajopt_cli.iiwa.experiments.stability import StabilityMap, stability
from trajopt_cli.iiwa.experiments.steps import Steps, all_axes, force_damping, force_stiffness, orientation
from trajopt_cli.iiwa.world.mujoco_world import available
from trajopt_cli.iiwa.world.worlds import Engine
from trajopt_cli.robot.srs import load_srs
from trajopt_cli.workers import in_turns

ROBOT = "iiwa7"


@dataclass(frozen=True, eq=False)
class Experiments:
    """Every experiment's answer under its name in EXPERIMENTS; engine: the world that moved the flange."""

    engine: Engine
    force_stiffness: Steps
    force_damping: Steps
    orientation: Steps
    all_axes: Steps
    force_error: ForceErrors
    guiding: Guided
    zeroing: Zeroed
    stability: StabilityMap
    speed: FollowTable
    stiffness: FollowTable
    damping: FollowTable
    collision: Collision
    loop_time: LoopTimes
    dosing: Dosing

    @property
    def stepped(self) -> tuple[Steps, ...]:
        """6.1.1 to 6.1.4."""
        return self.force_stiffness, self.force_damping, self.orientation, self.all_axes


EXPERIMENTS: dict[str, Callable[[Bench], Any]] = {
    "force_stiffness": force_stiffness,
    "force_damping": force_damping,
    "orientation": orientation,
    "all_axes": all_axes,
    "force_error": force_error,
    "guiding": guiding,
    "zeroing": zeroing,
    "stability": stability,
    "speed": speed,
    "stiffness": stiffness,
    "damping": damping,
    "collision": collision,
    "loop_time": loop_time,
    "dosing": dosing,
}
_ALONE = "loop_time"
# The longest first, so that neither of two processes waits long for the other.
_ORDER = ("dosing", "collision", "force_damping", "force_stiffness")


def run_experiments(listen: Callable[[str], None], engine: Literal["auto", "spring", "mujoco"] = "auto") -> Experiments:
    """All of chapter 6. listen: hears which experiment begins.

    engine: what moves the arm; auto is MuJoCo where it is installed. Raises InputError for mujoco where it is not.
    """
    bench = bench_of(engine)
    listen(_ALONE)
    # before a second process takes its share of the machine
    times = EXPERIMENTS[_ALONE](bench)
    names = [*_ORDER, *(name for name in EXPERIMENTS if name not in (*_ORDER, _ALONE))]
    tasks: Mapping[str, Callable[[Callable[[str], None]], Any]] = {name: partial(_one, name, bench) for name in names}
    answers = in_turns(tasks, listen)
    return Experiments(engine=bench.engine, loop_time=times, **answers)


def bench_of(engine: Literal["auto", "spring", "mujoco"]) -> Bench:
    """The arm in an engine's world. Raises InputError for MuJoCo where it is not installed."""
    best = Engine.SPRING if available() is None else Engine.MUJOCO
    chosen = best if engine == "auto" else Engine(engine)
    bench = Bench(load_srs(ROBOT), chosen)
    bench.check()
    return bench


def _one(name: str, bench: Bench, tell: Callable[[str], None]) -> Any:
    tell(name)
    return EXPERIMENTS[name](bench)
