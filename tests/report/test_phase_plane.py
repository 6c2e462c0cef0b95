"""The plane of one axis' state: parabolas, switches and times in closed form."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.cli import run
from trajopt_cli.report.phase_plane import fastest_curve, phase_figure
from trajopt_cli.report.style import house_style

PROGRAM = str(Path(__file__).parents[2] / "programs" / "hinge_line.mod")


@pytest.mark.parametrize(("D", "V", "A"), [(0.5, 10.0, 2.0), (-0.5, 10.0, 2.0), (0.5, 0.4, 2.0), (-1.2, 0.3, 5.0)])
def test_a_course_switches_on_the_curve_and_keeps_its_speed(D: float, V: float, A: float) -> None:
    s, v = fastest_curve(D, V, A)
    assert (s[0], v[0]) == (-D, 0)
    assert (s[-1], v[-1]) == pytest.approx((0, 0), abs=1e-12)
    peak = min(V, np.sqrt(A * abs(D)))
    assert np.abs(v).max() == pytest.approx(peak)
    # speeding up from -D (eq. 3.11), braking on s = -v |v| / 2A (eq. 3.12), and top speed between
    up, down = np.abs(v) ** 2 / (2 * A) - np.abs(s + D), np.abs(v) ** 2 / (2 * A) - np.abs(s)
    on = np.isclose(up, 0, atol=1e-12) | np.isclose(down, 0, atol=1e-12) | np.isclose(np.abs(v), peak)
    assert on.all()


def test_regions_part_at_the_curve_and_every_move_ends_at_the_origin() -> None:
    with house_style():
        figure = phase_figure([(3, 0.2, 1.0), (7, -0.1, 0.1)], 2.0, "x", "p")
    (axes,) = figure.axes
    lines = {str(line.get_gid()): np.asarray(line.get_xydata()) for line in axes.lines}
    curve = lines["switching curve"]
    np.testing.assert_allclose(curve[:, 0], -curve[:, 1] * np.abs(curve[:, 1]) / 4, atol=1e-12)
    for name in ("move 3", "move 7"):
        np.testing.assert_allclose(lines[name][-1], 0, atol=1e-12)
    assert {str(one.get_gid()) for one in axes.collections} == {"A", "D"}


def test_the_command_draws_an_axis_and_refuses_one_that_is_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["analyse", PROGRAM, "--axis", "x", "--plots", str(tmp_path / "p"), "--quiet"]) == 0
    assert {path.name for path in (tmp_path / "p").iterdir()} == {"phase_plane.svg", "phase_plane.png"}
    assert run(["analyse", PROGRAM, "--axis", "x"]) == 2
    assert run(["analyse", PROGRAM, "--plots", str(tmp_path / "q")]) == 2
    assert "--axis" in capsys.readouterr().err
