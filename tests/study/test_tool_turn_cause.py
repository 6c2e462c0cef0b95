"""What a tool that is free about its axis is worth, as a cause of the saving."""

from __future__ import annotations

from dataclasses import replace

from small_cells import plant_with_rail, plant_without_rail

from trajopt_cli.problem.decision_scope import AS_WRITTEN, EVERYTHING, FIXED_RAIL
from trajopt_cli.study.causes import TOOL_TURN, asked, causes


def test_turns_are_the_last_cause_but_what_is_dropped() -> None:
    found = causes(plant_with_rail(), True, free=True)
    assert [cause.name for cause in found[-2:]] == [TOOL_TURN, "dropped detours"]
    assert [cause.freedom.turn for cause in found] == [False] * (len(found) - 2) + [True, True]
    assert found[-2].freedom == replace(found[-3].freedom, turn=True)


def test_nothing_is_told_of_turns_where_no_tool_is_free() -> None:
    for plant in (plant_with_rail(), plant_without_rail()):
        assert TOOL_TURN not in [cause.name for cause in causes(plant, True)]
        assert asked(causes(plant, True)[-2].freedom, plant, True).turn
        for freedom in (AS_WRITTEN, EVERYTHING, FIXED_RAIL):
            assert asked(freedom, plant, True).turn
            assert asked(freedom, plant, True, True).turn == freedom.turn
