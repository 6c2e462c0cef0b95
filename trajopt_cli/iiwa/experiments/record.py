"""The experiments' numbers as plain data: SI, units in the names; what a clock measured stands apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from trajopt_cli.iiwa.controller.feed_schedule import FeedRow
from trajopt_cli.iiwa.experiments.catalogue import Experiments
from trajopt_cli.iiwa.experiments.collision import Collision, Touching
from trajopt_cli.iiwa.experiments.feed_scheduling import Dosing
from trajopt_cli.iiwa.experiments.following import FollowTable
from trajopt_cli.iiwa.experiments.force_error import ForceErrors
from trajopt_cli.iiwa.experiments.guiding import Guided, Zeroed
from trajopt_cli.iiwa.experiments.loop_time import LoopTimes
from trajopt_cli.iiwa.experiments.published import FLANGE_EARLIER
from trajopt_cli.iiwa.experiments.setup import Tracking
from trajopt_cli.iiwa.experiments.stability import StabilityMap
from trajopt_cli.iiwa.experiments.steps import StepRun, Steps, worst_sentences, worst_tracking


def record(experiments: Experiments) -> dict[str, Any]:
    """Everything but the series. "measured" holds times that differ from run to run; the rest is the same each time."""
    one = experiments
    return {
        "engine": one.engine.value,
        **{steps: _steps(getattr(one, steps)) for steps in ("force_stiffness", "force_damping")},
        **{steps: _steps(getattr(one, steps)) for steps in ("orientation", "all_axes")},
        "flange_worst": _tracking(worst_tracking(one.stepped)),
        "flange_worst_notes": list(worst_sentences(one.stepped)),
        "flange_worst_of_the_earlier_work_m": dict(zip(("largest", "mean"), FLANGE_EARLIER, strict=True)),
        "force_error": _force_error(one.force_error),
        "guiding": _guiding(one.guiding),
        "zeroing": _zeroing(one.zeroing),
        "stability": _stability(one.stability),
        **{table: _following(getattr(one, table)) for table in ("speed", "stiffness", "damping")},
        "collision": _collision(one.collision),
        "dosing": _dosing(one.dosing),
        "loop_time": _head(one.loop_time) | {"thesis_worst_s": one.loop_time.thesis_worst},
        "measured": {"loop_time": _loop_time(one.loop_time)},
    }


_Section = Steps | ForceErrors | Guided | Zeroed | StabilityMap | FollowTable | Collision | Dosing | LoopTimes


def _head(one: _Section) -> dict[str, Any]:
    return {"section": one.section, "title": one.title, "notes": list(one.sentences)}


def _following(table: FollowTable) -> dict[str, Any]:
    return _head(table) | {
        "varied": table.varied,
        "unit": table.unit,
        "speed_along_each_axis_m_s": table.speed,
        "speed_along_edges_m_s": table.edge_speed,
        "drawn": table.drawn,
        "rows": [
            {
                "value": case.value,
                "thesis_deviation_m": case.thesis,
                "deviation_on_diagonal_m": case.diagonal,
                "relative_difference": case.residual,
                "deviation_on_edges_m": case.edges,
            }
            for case in table.cases
        ],
        "largest_relative_difference": table.worst,
    }


def _steps(steps: Steps) -> dict[str, Any]:
    return _head(steps) | {"world": steps.world, "runs": [_step_run(run) for run in steps.runs]}


def _step_run(run: StepRun) -> dict[str, Any]:
    return {
        "label": run.label,
        "k": run.k,
        "d": run.d,
        "axes": [
            {
                "axis": one.axis,
                "force": one.force,
                "steady": one.steady,
                "force_over_stiffness": one.expected,
                "overshoot": one.overshoot,
                "overshoot_of_the_continuous_law": one.overshoot_expected,
                "settling_s": one.settling,
            }
            for one in run.answers
        ],
        "flange": _tracking(run.tracking),
    }


def _tracking(tracking: Sequence[Tracking]) -> list[dict[str, Any]] | None:
    """How the flange followed; None where the world's flange is exact."""
    rows = [
        {
            "axis": one.axis,
            "largest": one.maximum,
            "mean": one.mean,
            "thesis_largest": one.thesis_maximum,
            "thesis_mean": one.thesis_mean,
        }
        for one in tracking
    ]
    return rows or None


def _force_error(errors: ForceErrors) -> dict[str, Any]:
    return _head(errors) | {
        "sensors_drawn": errors.sensors,
        "axes": [
            {
                "axis": one.axis,
                "thesis_largest_N": dict(zip(errors.columns, one.thesis, strict=True)),
                "thesis_median_N": one.thesis_median,
                "largest_median_N": one.median,
                "largest_of_all_N": one.greatest,
                "bound_N": one.bound,
            }
            for one in errors.rows
        ],
    }


def _guiding(guided: Guided) -> dict[str, Any]:
    return _head(guided) | {
        "world": guided.world,
        "pushes": [
            {
                "axis": lead.axis,
                "start_s": lead.start,
                "end_s": lead.end,
                "way_m": lead.way,
                "force_times_time_over_damping_m": lead.expected,
                "top_speed_m_s": lead.speed,
                "top_speed_of_the_continuous_law_m_s": lead.speed_expected,
                "aside_m": lead.aside,
            }
            for lead in guided.leads
        ],
        "speed_left_m_s": guided.left,
    }


def _zeroing(zeroed: Zeroed) -> dict[str, Any]:
    return _head(zeroed) | {
        "world": zeroed.world,
        "free_axis": zeroed.axis.tolist(),
        "direction": zeroed.direction.tolist(),
        "angle_rad": zeroed.angle,
        "aside_m": zeroed.aside,
        "length_m": zeroed.length,
        "flange_angle_rad": zeroed.flange_angle,
        "flange_aside_m": zeroed.flange_aside,
    }


def _stability(found: StabilityMap) -> dict[str, Any]:
    return _head(found) | {
        "m_kg": found.m,
        "period_s": found.h,
        "share_denied": found.denied,
        "settings": [
            {
                "section": one.section,
                "k": one.k,
                "d": one.d,
                "m": one.m,
                "verdict": one.verdict.name.lower(),
                "largest_period_s": one.h_max,
            }
            for one in found.settings
        ],
    }


def _collision(collision: Collision) -> dict[str, Any]:
    return _head(collision) | {"task": collision.task, "runs": [_touching(run) for run in collision.runs]}


def _touching(run: Touching) -> dict[str, Any]:
    return {
        "world": run.world,
        "first_touch_s": run.first,
        "largest_excursion_in_z_m": run.excursion,
        "largest_excursion_at_s": run.excursion_at,
        "controllers_excursion_in_z_m": run.controller,
        "largest_normal_force_N": run.normal,
        "largest_normal_force_at_s": run.normal_at,
        "largest_force_across_z_N": run.across,
        "largest_friction_on_top_N": run.friction,
        "largest_believed_normal_force_N": run.believed,
        "deepest_m": run.deepest,
        "crossings": run.crossings,
        "stop": run.stop or None,
    }


def _dosing(dosing: Dosing) -> dict[str, Any]:
    return _head(dosing) | {
        "task": dosing.task,
        "bound_m": dosing.bound,
        "rows": [_feed_row(row) for row in dosing.rows],
        "lower_bound_s": dosing.least,
        "steady_lag_m": dosing.steady,
        "lag_with_ramps_and_speed_m": dosing.ramped,
    }


def _feed_row(row: FeedRow) -> dict[str, Any]:
    return {
        "feeding": row.feeding.value,
        "duration_s": row.duration,
        "arrived_s": row.arrived,
        "largest_lag_m": row.lag.maximum,
        "largest_lag_at_s": row.lag.time,
        "mean_lag_m": row.lag.mean,
    }


def _loop_time(times: LoopTimes) -> dict[str, Any]:
    return {
        "language": times.language,
        "periods": times.periods,
        "parts": [
            {"part": part.name, "least_s": part.least, "mean_s": part.mean, "longest_s": part.most}
            for part in times.parts
        ],
    }
