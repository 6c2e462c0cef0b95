"""The thesis' analysis of a program as a table and as a record, in the units of RAPID: mm, deg, mm/s."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from trajopt_cli.motion import Program
from trajopt_cli.report.stepwise import Analysis, StepMove, StepWait
from trajopt_cli.runs.summary import motion_label
from trajopt_cli.table import TextTable, place, seconds, tabulate
from trajopt_cli.units import DEG, MM

MODEL = (
    "steps of speed through every point, straight or along the arc in carriage-relative space, waits excluded "
    "(Krotký 2014, 4.2); not a motion a robot can do; zones change nothing, ways that corners would cut off are counted"
)


def analysis_record(program: Program, analysis: Analysis) -> dict[str, Any]:
    """The analysis as plain data; velocities are those of the TCP along the carriage's axes."""
    return {
        "model": MODEL,
        "moves": [_move_record(program, move) for move in analysis.moves],
        "waits": [
            {"index": wait.index, "source": str(wait.source), "duration_s": wait.duration} for wait in analysis.waits
        ],
        "arm_s": analysis.arm,
        "rail_s": analysis.rail,
        "cycle_s": analysis.cycle,
        "waits_s": analysis.wait,
    }


def _move_record(program: Program, move: StepMove) -> dict[str, Any]:
    instruction, target = motion_label(program, move.index)
    return {
        "index": move.index,
        "source": str(move.source),
        "instruction": instruction,
        "target": target,
        "carriage_from_mm": [float(value) / MM for value in move.X_BT_0[:3, 3]],
        "carriage_to_mm": [float(value) / MM for value in move.X_BT_1[:3, 3]],
        "world_from_mm": [float(value) / MM for value in move.X_WT_0[:3, 3]],
        "world_to_mm": [float(value) / MM for value in move.X_WT_1[:3, 3]],
        "rail_from_mm": move.rail_0 / MM,
        "rail_to_mm": move.rail_1 / MM,
        "length_mm": move.length / MM,
        "turn_deg": move.angle / DEG,
        "speed_mm_s": move.v_tcp / MM,
        "velocity_mm_s": [float(value) / MM for value in move.velocity],
        "arm_s": move.t_arm,
        "rail_s": move.t_rail,
        "duration_s": move.duration,
    }


def analysis_table(name: str, program: Program, analysis: Analysis) -> TextTable:
    """One line per move and wait, in program order; a wait's time stands in a column of its own."""

    def of_move(text: Callable[[StepMove], str]) -> Callable[[StepMove | StepWait], str]:
        return lambda one: "" if isinstance(one, StepWait) else text(one)

    def axis(i: int) -> Callable[[StepMove | StepWait], str]:
        return of_move(lambda one: _figure(float(one.velocity[i]) / MM))

    entries: list[StepMove | StepWait] = [*analysis.moves, *analysis.waits]
    return tabulate(
        f"{name}: as written, in steps of speed; lengths and axis speeds as the carriage sees them",
        sorted(entries, key=lambda one: one.index),
        {
            "~place": lambda one: place(one.source),
            "instruction": lambda one: motion_label(program, one.index)[0],
            "~target": lambda one: motion_label(program, one.index)[1],
            ">time [s]": of_move(lambda one: seconds(one.duration)),
            ">wait [s]": lambda one: seconds(one.duration) if isinstance(one, StepWait) else "",
            ">length [mm]": of_move(lambda one: _figure(one.length / MM)),
            ">turn [deg]": of_move(lambda one: _figure(one.angle / DEG)),
            ">rail by [mm]": of_move(lambda one: _figure((one.rail_1 - one.rail_0) / MM)),
            ">programmed [mm/s]": of_move(lambda one: _figure(one.v_tcp / MM)),
            **{f">{name} [mm/s]": axis(i) for i, name in enumerate("xyz")},
        },
    )


def sums(analysis: Analysis) -> Iterator[str]:
    """The sums, a line each; where arm and rail move at once the cycle counts the slower of the two."""
    both = analysis.arm + analysis.rail - analysis.cycle
    yield f"arm {analysis.arm:.3f} s"
    yield f"rail {analysis.rail:.3f} s"
    yield f"cycle {analysis.cycle:.3f} s" + (f", arm + rail - both at once {both:.3f} s" if both > 1e-9 else "")
    yield f"waits {analysis.wait:.3f} s, apart"


def _figure(value: float) -> str:
    """One decimal; what stands still stays blank."""
    return f"{value:.1f}" if abs(value) >= 0.05 else ""
