"""Identified limits as the `limits:` section of a cell file."""

from __future__ import annotations

import json
from collections.abc import Sequence

from trajopt_cli.measured.identify import Kind, Limit

KEYS = {Kind.SPEED: "velocity", Kind.ACCELERATION: "acceleration", Kind.JERK: "jerk"}


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
