"""Whoever teaches a point anew moves all that the program makes of it, in the exported text as in the given one."""

from __future__ import annotations

import random

import pytest
from small_cells import plant_with_rail
from touch_up import differences, export, random_program, read, taught, touch_up

from trajopt_cli.problem.editable import Loops
from trajopt_cli.scenario import Scenario

NO = Scenario()
PLANT = plant_with_rail()
SEEDS = 25  # benchmarks/bench_touch_up.py tries more


@pytest.mark.parametrize("seed", range(SEEDS))
def test_every_pose_of_an_export_moves_with_its_points(seed: int) -> None:
    assert touch_up(seed, PLANT) == []


def test_copies_of_points_would_be_noticed() -> None:
    """An approach that is written out in numbers stays where it was."""
    move = "MoveL Offs(p,-40,0,0),v500,fine,tool0;"
    literal = "[[500,200,450],[1,0,0,0],[0,0,0,0],[{},9E9,9E9,9E9,9E9,9E9]]"
    given = f"MODULE m\nPERS robtarget p:={literal.format(150)};\nPROC main()\n{move}\nENDPROC\nENDMODULE\n"
    program = read(given, PLANT, NO)
    exported, intents = export(program, PLANT, NO, random.Random(1), Loops.KEEP)
    new = read(taught(given), PLANT, NO)
    assert differences(new, read(taught(exported), PLANT, NO), PLANT, intents) == []
    rail = intents[0].rail[0]
    copied = given.replace("Offs(p,-40,0,0)", literal.format(rail).replace("500", "460"))
    assert differences(program, read(copied, PLANT, NO), PLANT, intents) == []
    (said,) = differences(new, read(taught(copied), PLANT, NO), PLANT, intents)
    assert said.startswith("m.mod:4:1: ")


def test_random_programs_have_what_is_to_be_tried() -> None:
    text = "".join(random_program(random.Random(seed)) for seed in range(SEEDS))
    for word in ("Offs(p", "RelTool(", "WObj:=w2", "FOR i", "WHILE", "serve ", "grip;", "pNow:=", "fUp(", "ps{i",
                 "WaitTime", "PDispSet", "EOffsSet", "uframe.trans.x:="):  # fmt: skip
        assert word in text
