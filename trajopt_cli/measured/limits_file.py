"""The limits in force for a log; and identified ones as a cell file's `limits:`, as a table and as plain data."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np

from trajopt_cli.errors import InputError
from trajopt_cli.limits import JointLimits
from trajopt_cli.measured.identify import Kind, Limit, Seen
from trajopt_cli.measured.reached import Reached
from trajopt_cli.table import TextTable, percent, tabulate
from trajopt_cli.units import slides, unit_of

KEYS = {Kind.SPEED: "velocity", Kind.ACCELERATION: "acceleration", Kind.JERK: "jerk"}
_UNIT = {Kind.SPEED: "/s", Kind.ACCELERATION: "/s²", Kind.JERK: "/s³"}
_ANYWHERE = 200.0  # m: what a rail's stroke is only the cell file knows


def limits_section(limits: Sequence[Limit], logs: Sequence[str]) -> str:
    """The section's text, with what was seen and nothing else; empty where nothing was."""
    lines = []
    for axis in dict.fromkeys(one.axis for one in limits):
        known = [one for one in limits if one.axis == axis and one.value is not None]
        if not known:
            continue
        parts = [f"{KEYS[one.kind]}: {_digits(one)}" for one in known]
        evidence = ", ".join(f"{KEYS[one.kind]} {_interval(one)} ({one.motions} motions)" for one in known)
        source = f"identified from {', '.join(logs)}; 90 % intervals: {evidence}"
        lines.append(f"  {axis}: {{{', '.join(parts)}, source: {json.dumps(source, ensure_ascii=False)}}}")
    if not lines:
        return ""
    head = [
        "# identified by trajopt identify; copy into the cell file. SI units. What a log does not show is left out."
    ]
    if any(one.kind is Kind.JERK and one.value is not None for one in limits):
        head.append("# Jerks are kept by plans only with 'jerk_limits: true' beside this section.")
    return "\n".join([*head, "limits:", *lines]) + "\n"


def _digits(limit: Limit) -> str:
    """As many digits as the interval bears, one more."""
    assert limit.value is not None
    assert limit.low is not None
    assert limit.high is not None
    share = (limit.high - limit.low) / 2 / limit.value
    return f"{limit.value:.{3 if share > 0.05 else 4 if share > 0.005 else 5}g}"


def _interval(limit: Limit) -> str:
    return f"{limit.low:.4g} to {limit.high:.4g}"


def _in_force(limit: Limit, limits: JointLimits) -> float | None:
    values = getattr(limits, KEYS[limit.kind])
    if values is None or (limit.kind is Kind.JERK and not limits.jerk_binds):
        return None
    value = float(values[limits.names.index(limit.axis)])
    return value if value == value else None


def identified_table(found: Sequence[Limit], reached: Sequence[Reached], limits: JointLimits, place: str) -> TextTable:
    """A line per axis and limit, in degrees and millimetres."""
    most = {(one.axis, one.kind): one for one in reached}

    def told(value: float | None, one: Limit, digits: int = 5) -> str:
        return "" if value is None else f"{value / unit_of(one.axis)[0]:.{digits}g}"

    def unit(one: Limit) -> str:
        return unit_of(one.axis)[1] + _UNIT[one.kind]

    def missing(one: Limit) -> str:
        highest = f"; the highest of those that can tell is {told(one.most, one, 4)} {unit(one)}"
        return "" if one.value is not None else one.why + (highest if one.most is not None else "")

    return tabulate(
        f"limits by the log, 90 % intervals, beside those of {place}",
        found,
        {
            "axis": lambda one: one.axis,
            "limit": lambda one: one.kind.value,
            ">identified": lambda one: told(one.value, one),
            ">from": lambda one: told(one.low, one),
            ">to": lambda one: told(one.high, one),
            "unit": unit,
            ">motions": lambda one: "" if one.value is None else str(one.motions),
            ">reached": lambda one: told(most[of].value, one, 4) if (of := (one.axis, one.kind)) in most else "",
            ">in force": lambda one: told(
                most[of].limit if (of := (one.axis, one.kind)) in most else _in_force(one, limits), one, 4
            ),
            ">share": lambda one: (
                percent(most[of].value / most[of].limit, 0) if (of := (one.axis, one.kind)) in most else ""
            ),
            "what is missing": missing,
        },
    )


def seen_lines(
    names: Sequence[str], seen: Sequence[Seen], unused: Sequence[tuple[str, ...]], found: Sequence[Limit]
) -> Iterator[str]:
    """What became of each log, a line each, and what to do with the result."""
    for name, one, columns in zip(names, seen, unused, strict=True):
        left = [f"{one.fitted} fitted"]
        left += [f"{one.not_straight} not along one line in the joints"] if one.not_straight else []
        left += [f"{one.not_ramps} not one ramp up and one down"] if one.not_ramps else []
        left += [f"{one.not_looked_at} more not looked at"] if one.not_looked_at else []
        motions = f"{one.motions} motion{'s' * (one.motions > 1)} between rests, {', '.join(left)}"
        off = f"; times are off by {one.jitter * 1e3:.2f} ms (rms)" if one.fitted else ""
        rows = f"{one.rows} rows every {one.period * 1e3:.3g} ms"
        yield f"{name}: {rows}, {motions if one.motions else 'no motion between two rests'}{off}"
        if columns:
            yield f"{name}: columns not used: {', '.join(columns)}"
    if any(one.kind is Kind.JERK and one.value is not None for one in found):
        yield "accelerations do not jump here: 'jerk_limits: true' in the cell file has plans keep the jerks"
    if any(one.kind is Kind.SPEED and one.value is not None for one in found):
        yield "one speed programmed for all motions of an axis looks the same as its limit: log vmax at 100 % override"
    if all(one.value is None for one in found):
        yield "no limit is identified: that takes motions of several lengths between rests; each is 'reached' or more"


def identified_record(
    found: Sequence[Limit],
    seen: Sequence[Seen],
    logs: Sequence[str],
    limits: JointLimits,
    reached: Sequence[Reached],
    against: Sequence[str],
) -> dict[str, Any]:
    """The same as plain data, SI."""
    return {
        "logs": [
            {
                "file": name, "rows": one.rows, "seconds": one.seconds, "period_s": one.period, "motions": one.motions,
                "fitted": one.fitted, "not_straight": one.not_straight, "not_ramps": one.not_ramps,
                "not_looked_at": one.not_looked_at, "clock_s": one.jitter, "lag_s": one.lags,
            }
            for name, one in zip(logs, seen, strict=True)
        ],
        "limits": [
            {
                "axis": one.axis, "limit": one.kind.value, "value": one.value, "low": one.low, "high": one.high,
                "confidence": 0.9, "motions": one.motions, "why_not": one.why or None, "highest_seen": one.most,
                "in_force": _in_force(one, limits),
            }
            for one in found
        ],
        "reached": [asdict(one) | {"share": one.value / one.limit} for one in reached],
        "contradictions": list(against),
    }  # fmt: skip


def limits_in_force(robot: str | None, cell: Path | None) -> tuple[JointLimits, str]:
    """Limits of all axes in the robot's order, and where they come from, in words.

    Raises InputError where neither or both are named, and as loading them does.
    """
    if (robot is None) == (cell is None):
        raise InputError(
            "say whose axes these are: by --robot NAME ('trajopt robot list') or by --cell FILE.yaml, one of them"
        )
    if cell is not None:
        from trajopt_cli.cell.loader import load_cell
        from trajopt_cli.problem.plant import build_plant

        return build_plant(load_cell(cell)).limits, str(cell)
    from trajopt_cli.robot.description import read
    from trajopt_cli.robot.model import Structure, load_robot
    from trajopt_cli.robot.srs import load_srs

    assert robot is not None
    data, _, _ = read(robot)
    model = load_srs(robot) if data.structure is Structure.SRS else load_robot(robot)
    limits, name = model.profile(), getattr(model, "default_profile", "default")
    rail = np.array([slides(one) for one in limits.names])
    lower, upper = np.where(rail, -_ANYWHERE, limits.lower), np.where(rail, _ANYWHERE, limits.upper)
    return replace(limits, lower=lower, upper=upper), f"{data.name}, profile {name}"
