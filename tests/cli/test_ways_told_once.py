"""Ways around that both plans go are told in one line."""

from __future__ import annotations

from trajopt_cli.pipeline.optimize import _said_once
from trajopt_cli.problem.plan import Target

COLUMN, BOTH = "t.mod:4:1: MoveJ p goes around 'column'", "t.mod:6:1: MoveJ q goes around 'column', 'fence'"


def test_what_both_plans_go_around_is_one_line() -> None:
    stream = (COLUMN, "t.mod:6:1: MoveJ q goes around 'column'", "stopped by Ctrl-C: the best plan so far")
    rapid = (f"{COLUMN} by 2 points", f"{BOTH} by 1 point", "another")
    assert list(_said_once({Target.STREAM: stream, Target.RAPID: rapid})) == [
        f"stream and rapid: {COLUMN}, rapid by 2 points",
        f"rapid: {BOTH} by 1 point",
        "rapid: another",
        "stream: t.mod:6:1: MoveJ q goes around 'column'",  # not the same bodies
        "stream: stopped by Ctrl-C: the best plan so far",
    ]
    assert list(_said_once({Target.STREAM: (COLUMN,), Target.RAPID: (COLUMN,)})) == [f"stream and rapid: {COLUMN}"]
