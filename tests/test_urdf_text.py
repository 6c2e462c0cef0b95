"""What no URDF is, is refused before it is looked at further."""

from __future__ import annotations

from pathlib import Path

import pytest

from trajopt_cli import urdf_text
from trajopt_cli.errors import InputError


def test_a_file_too_large_is_refused_as_such(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(urdf_text, "MAX_BYTES", 3_000_000)
    file = tmp_path / "a.urdf"
    file.write_text("<robot name='a'>" + " " * 2_999_976 + "</robot>")
    assert file.stat().st_size == 3_000_000
    assert urdf_text.read_robot_element(file).get("name") == "a"
    file.write_text(file.read_text() + " ")
    with pytest.raises(InputError, match=r"a\.urdf: is larger than 3 MB: keep meshes in files of their own"):
        urdf_text.read_robot_element(file)


def test_elements_without_end_are_refused_before_they_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(urdf_text, "MAX_ELEMENTS", 100)
    file = tmp_path / "a.urdf"
    for depth, many, what in (
        (50, 0, None),
        (51, 0, "elements 51 deep"),
        (1, 99, None),
        (1, 100, "more than 100 elements"),
    ):
        file.write_text(f"<robot name='a'>{'<a>' * (depth - 1)}{'</a>' * (depth - 1)}{'<b/>' * many}</robot>")
        if what is None:
            assert urdf_text.read_robot_element(file).tag == "robot"
        else:
            with pytest.raises(InputError, match=rf"a\.urdf: has {what}: no robot has; give the URDF of one robot"):
                urdf_text.read_robot_element(file)


@pytest.mark.parametrize(
    ("inside", "what"),
    [
        ("\n<link name='${prefix}base'/>", r"2: is xacro, not yet a URDF \(\$\{prefix\}base\)"),
        ("\n<link name='$(arg side)'/>", r"2: is xacro, not yet a URDF \(\$\(arg side\)\)"),
        (
            "\n\n<xacro:arm xmlns:xacro='http://ros.org/wiki/xacro'/>",
            r"3: is xacro, not yet a URDF \(<xacro:arm>\)",
        ),
        ("\n<xacro:arm/>", r"2: is xacro, not yet a URDF \(<xacro:arm>\)"),
    ],
)
def test_xacro_is_told(tmp_path: Path, inside: str, what: str) -> None:
    file = tmp_path / "a.urdf"
    file.write_text(f"<robot name='a'>{inside}</robot>")
    with pytest.raises(InputError, match=what):
        urdf_text.read_robot_element(file)
