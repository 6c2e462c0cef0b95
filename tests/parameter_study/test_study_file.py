"""The study file: what varies, from what is written to the points' cells; and every mistake at its line and key."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tiny import STUDY, written

from trajopt_cli.cell.loader import load_cell
from trajopt_cli.errors import InputError
from trajopt_cli.parameter_study.cell_keys import put, si_unit, units_at, value_at
from trajopt_cli.parameter_study.point import cell_at, job_at
from trajopt_cli.parameter_study.price import price
from trajopt_cli.parameter_study.study_file import Study, read_study
from trajopt_cli.problem.plant import build_plant
from trajopt_cli.units import MM


def study_of(folder: Path, vary: str, more: str = "") -> Study:
    return read_study(written(folder, f"programs: [tiny.mod]\nvary: {vary}\n{more}"))


def test_a_grid_has_every_combination_once_and_the_columns_carry_units(tmp_path: Path) -> None:
    study = read_study(written(tmp_path))
    every = [study.design.point(i).values for i in range(len(study.design))]
    speeds = [float(f"{one:.9g}") for one in np.linspace(0.5, 1.5, 40)]
    assert every == [(a, b) for a in speeds for b in (1.0, 2.0, 3.0)]
    names = [column.name for column in study.inputs.columns]
    assert names[:4] == ["point", "program", "limits.joint_1.velocity_rad_per_s", "tcp.speed_m_per_s"]


@pytest.mark.parametrize("method", ["latin_hypercube", "sobol", "random"])
def test_samples_have_their_distributions_and_follow_from_the_seed(tmp_path: Path, method: str) -> None:
    vary = "{tool_radius: {uniform: [10 mm, 30 mm]}, start.joints.1: {normal: {mean: 0, sigma: 2 deg}}}"
    more = f"sampling: {{{method}: 1024, seed: %d}}"
    study = study_of(tmp_path, vary, more % 1)
    values = np.array([study.design.point(i).values for i in range(1024)])
    assert values[:, 0].mean() == pytest.approx(0.02, abs=1e-3)
    assert values[:, 0].std() == pytest.approx(0.02 / np.sqrt(12), rel=0.1)
    assert values[:, 1].std() == pytest.approx(np.radians(2), rel=0.1)
    again = study_of(tmp_path, vary, more % 1)
    assert [again.design.point(i) for i in range(9)] == [study.design.point(i) for i in range(9)]
    other = study_of(tmp_path, vary, more % 2)
    assert other.design.point(0) != study.design.point(0)
    if method == "latin_hypercube":  # one point in each of as many strips
        assert sorted(np.floor((values[:, 0] - 0.01) / 0.02 * 1024 + 1e-6).astype(int)) == [*range(1024)]


def test_a_levels_cell_is_the_one_that_a_file_with_it_gives(tmp_path: Path) -> None:
    """Held against the cell file written by hand."""
    study = study_of(
        tmp_path, "{limits.joint_1.acceleration: [5], tcp: [{speed: 1, acceleration: 9, source: me}], settle: [50 ms]}"
    )
    cell = cell_at(study.inputs, dict(zip(study.inputs.keys, study.design.point(0).values, strict=True)))
    (tmp_path / "tiny.yaml").write_text(
        "robot: irb140\nstart: {joints: '[0, 0, 0, 0, 90, 0] deg'}\nsettle: 0.05\n"
        "limits: {joint_1: {acceleration: 5, source: x}}\ntcp: {speed: 1, acceleration: 9, source: me}\n"
    )
    other = load_cell(tmp_path / "tiny.yaml")
    assert (cell.settle, cell.tcp) == (other.settle, other.tcp)
    np.testing.assert_array_equal(build_plant(cell).limits.acceleration, build_plant(other).limits.acceleration)


def test_targets_and_work_objects_stand_off_by_what_the_point_says(tmp_path: Path) -> None:
    study = study_of(
        tmp_path, "{target.*.*: {uniform: [-3 mm, 3 mm]}, place.table.x: [20 mm]}", "sampling: {random: 3}"
    )
    assert study.inputs.keys == ("target.p_in.x", "target.p_in.y", "target.p_in.z", "place.table.x")
    point = study.design.point(2)
    move = job_at(study.inputs, point).program.motions[0]
    off = np.array([point.values[0] + 0.02, *point.values[1:3]])
    np.testing.assert_allclose(move.X_WT[:3, 3], np.array([500, 0, 600]) * MM + off, atol=1e-8)
    assert 0 < np.abs(point.values[:3]).max() <= 3e-3


def test_scale_starts_from_what_is_in_force(tmp_path: Path) -> None:
    study = study_of(tmp_path, "{limits.*.acceleration: {scale: 20 %}}", "sampling: {latin_hypercube: 50}")
    now = build_plant(load_cell(tmp_path / "tiny.yaml")).limits.acceleration
    values = np.array([study.design.point(i).values for i in range(50)]) / now
    assert values.shape == (50, 6)
    assert 0.8 <= values.min() < 0.81
    assert 1.19 < values.max() <= 1.2


@pytest.mark.parametrize(
    ("vary", "more", "line", "said"),
    [
        ("{limits.joint_1.speed: [1]}", "", 2, "vary.limits.joint_1.speed.list.0: unknown key; known: lower"),
        ("{limits.joint_9.velocity: [1]}", "", 2, "joint_9"),
        ("{tcp.speed: [1, 2, -3]}", "", 2, "vary.tcp.speed.list.2: needs a number above zero, not -3"),
        ("{tcp.speed: [1 kg]}", "", 2, "unit 'kg'"),
        ("{robot: [irb140, irb999]}", "", 2, "vary.robot.list.1: "),
        ("{start.joints.1: {uniform: [0, 90]}}", "sampling: {random: 9}", 2, "if deg are meant"),
        ("{tool_radius: {uniform: [1 mm, 2 mm]}}", "", 2, "has no levels for a grid"),
        ("{tool_radius: {range: [1 mm, 2 mm]}}", "", 2, "range and count go together"),
        ("{tool_radius: {list: [1], scale: 2 %}}", "", 2, "has list and scale"),
        ("{signals.di1: {scale: 2 %}}", "sampling: {random: 9}", 2, "has no number now"),
        ("{target.p_out.x: [1 mm]}", "", 2, "known: p_in"),
        ("{place.table.up: [1 mm]}", "", 2, "up"),
        ("{place.chair.x: [1 mm]}", "", 2, "known: table"),
        ("{tcp.speed: [1]}", "answer: [rapid]", 3, "answer: unknown key; did you mean 'answers'?"),
        ("{tcp.speed: [1]}", "effort: quick", 3, "effort: needs first_legal, full or a time"),
        ("{tcp.speed: [1]}", "sampling: {random: 0}", 3, "sampling.random: needs a whole number"),
        ("{tcp.speed: [1]}", "price: 3 * tcp.sped", 3, "price: tcp.sped is no key"),
        ("{tcp.speed: [1]}", "price: __import__('os')", 3, "price: does not take"),
        ("{tcp.speed: [1]}", "limits: {time: 3 kg}", 3, "limits.time: "),
    ],
)
def test_a_mistake_is_told_with_file_line_and_key(tmp_path: Path, vary: str, more: str, line: int, said: str) -> None:
    with pytest.raises(InputError) as told:
        study_of(tmp_path, vary, more)
    assert str(told.value).startswith(f"{tmp_path / 'study.yaml'}:{line}: "), told.value
    assert said in str(told.value)


def test_keys_know_their_units_and_lists_their_items() -> None:
    units = {
        key: si_unit(units_at(key)) for key in ("limits.rail.jerk", "rail.stroke.high", "waits.di1", "settle.fine")
    }
    assert units == {"limits.rail.jerk": "m/s3", "rail.stroke.high": "m", "waits.di1": "s", "settle.fine": "s"}
    data = {"rail": {"stroke": "[0, 2000] mm"}}
    put(data, "rail.stroke.low", -0.2)
    put(data, "rail.frame.position.z", 0.5)
    assert data == {"rail": {"stroke": [-0.2, 2.0], "frame": {"position": [0, 0, 0.5]}}}
    assert value_at(data, "rail.stroke.high") == 2.0


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("300 * (rail.stroke.high - rail.stroke.low) + 5", 665.0),
        ("{'a': 10, 'b': 20}[robot] / 4", 5.0),
        ("max(1, -2) if rail.stroke.high > 2 else 0", 1.0),
    ],
)
def test_a_price_is_worked_out(text: str, value: float) -> None:
    values = {"rail.stroke.high": 2.2, "rail.stroke.low": 0.0, "robot": "b"}
    assert price(text, values.get) == pytest.approx(value)


def test_a_programs_levels_are_checked_for_every_program(tmp_path: Path) -> None:
    written(tmp_path, STUDY.replace("[tiny.mod]", "[tiny.mod, tiny.mod]"))
    with pytest.raises(InputError, match="names a program twice"):
        read_study(tmp_path / "study.yaml")


def test_a_range_through_zero_has_a_zero(tmp_path: Path) -> None:
    text = "programs: [tiny.mod]\nvary: {place.base.z: {range: [-200 mm, 100 mm], count: 4}}\n"
    study = read_study(written(tmp_path, text))
    assert [study.design.point(i).values for i in range(4)] == [(-0.2,), (-0.1,), (0.0,), (0.1,)]


@pytest.mark.long
@pytest.mark.parametrize("library", ["pyarrow", "distributed"])
def test_without_the_extra_one_line_says_what_to_install(tmp_path: Path, library: str) -> None:
    written(tmp_path)
    text = "import sys; sys.modules[sys.argv[1]] = None; from trajopt_cli.cli import run; sys.exit(run(sys.argv[2:]))"
    command = [sys.executable, "-c", text, library, "study", "study.yaml"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert done.stderr == f"{library} is not installed: pip install 'trajopt-cli[study]'\n"


@pytest.mark.parametrize(
    ("name", "text"), [("a.mod", "MODULE A\nENDMODULE\n"), ("b.yaml", "robot: irb140\nlimits: {}\n")]
)
def test_another_kind_of_file_is_told_by_its_kind(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    kind = {"a.mod": "RAPID program", "b.yaml": "cell file"}[name]
    with pytest.raises(InputError, match=f"{kind}, not a study file"):
        read_study(tmp_path / name)
    with pytest.raises(InputError, match="study file, not a cell file"):
        load_cell(written(tmp_path))
