"""A cell's own robot: found beside the cell file wherever the command runs, and kept in the results folder."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import InputError
from trajopt_cli.job import cell_of_results, read_job, read_results_job
from trajopt_cli.pipeline.optimize import OptimizedJob, inputs_of, optimize_job, robot_place
from trajopt_cli.problem.plan import Target
from trajopt_cli.problem.plant import build_plant

REPOSITORY = Path(__file__).parents[2]
MODULE = """MODULE one
PROC main()
    MoveAbsJ [[10, 0, 0, 0, 30, 0], [9E9, 9E9, 9E9, 9E9, 9E9, 9E9]], v500, fine, tool0;
ENDPROC
ENDMODULE
"""


@pytest.fixture
def cell(tmp_path, monkeypatch):
    """A program whose cell names robots/mine.yaml, an IRB 140 with a longer lower arm; run from elsewhere."""
    folder = tmp_path / "work"
    (folder / "robots").mkdir(parents=True)
    given = (REPOSITORY / "robots" / "irb140.yaml").read_text().replace("irb140.urdf", "deeper/irb140.urdf")
    (folder / "robots" / "mine.yaml").write_text(given)
    (folder / "robots" / "deeper").mkdir()
    text = (REPOSITORY / "robots" / "irb140.urdf").read_text().replace('"0 0 0.36"', '"0 0 0.46"')
    (folder / "robots" / "deeper" / "irb140.urdf").write_text(text)
    (folder / "one.mod").write_text(MODULE)
    (folder / "one.yaml").write_text('robot: robots/mine.yaml\nstart: {joints: "[0, 0, 0, 0, 30, 0] deg"}\n')
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    return folder / "one.yaml"


def lower_arm(robot):
    return robot.chain[2].X[2, 3]


def test_the_path_of_a_robot_begins_at_the_cell_file(cell):
    assert lower_arm(build_plant(load_cell(cell)).robot) == 0.46


def test_an_absolute_path_stays_what_it_is(cell):
    mine = cell.parent / "robots" / "mine.yaml"
    cell.write_text(cell.read_text().replace("robots/mine.yaml", str(mine)))
    assert load_cell(cell).robot == str(mine)
    assert lower_arm(build_plant(load_cell(cell)).robot) == 0.46


def test_a_robot_that_is_not_there_has_its_line_in_the_cell_file(cell):
    cell.write_text(cell.read_text().replace("mine", "yours"))
    with pytest.raises(InputError, match=r"one\.yaml:1: robot: robot file '\S*robots/yours\.yaml' does not exist"):
        build_plant(load_cell(cell))


def test_a_urdf_that_results_could_not_keep_is_refused(cell):
    mine = cell.parent / "robots" / "mine.yaml"
    mine.write_text(mine.read_text().replace("deeper/irb140.urdf", "../irb140.urdf"))
    with pytest.raises(InputError, match=r"mine\.yaml:6: urdf: '\.\./irb140\.urdf' has to be in this file's folder"):
        build_plant(load_cell(cell))


def test_a_results_folder_keeps_the_robot_and_is_judged_with_it(cell, tmp_path, unrefined):
    job = read_job(cell.with_name("one.mod"))
    done = optimize_job(job, Target.STREAM, tmp_path / "results", lambda *_: None, jobs=1)
    assert isinstance(done, OptimizedJob)
    assert (tmp_path / "results/input/robot/mine.yaml").read_bytes() == (cell.parent / "robots/mine.yaml").read_bytes()
    shutil.rmtree(cell.parent)
    again = read_results_job(tmp_path / "results")
    assert lower_arm(again.plant.robot) == 0.46
    assert again.plant.robot.urdf == tmp_path / "results/input/robot/deeper/irb140.urdf"
    assert build_plant(cell_of_results(tmp_path / "results")).robot.urdf == again.plant.robot.urdf
    np.testing.assert_array_equal(again.plant.limits.lower, job.plant.limits.lower)
    again.plant.robot.urdf.write_text("<robot/>")
    with pytest.raises(InputError, match=r"irb140\.urdf: was changed since the run"):
        read_results_job(tmp_path / "results")


def test_robots_that_ship_are_not_copied():
    job = read_job(REPOSITORY / "programs" / "bench_irb140.mod")
    assert robot_place(job) is None
    assert not [one for one in inputs_of(job).values() if "robot" in one.place]
