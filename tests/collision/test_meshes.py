"""Mesh files that cannot be meant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.errors import InputError
from trajopt_cli.proximity.meshes import load_mesh
from trajopt_cli.shapes import MeshFile


def test_a_vertex_that_is_no_number_is_told_with_the_file(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """And the library says nothing of its own."""
    rows = ["solid t", "facet normal 0 0 1", "outer loop"]
    rows += ["vertex 0 0 0", "vertex 1 0 0", "vertex nan 1 0", "endloop", "endfacet", "endsolid t"]
    file = tmp_path / "odd.stl"
    file.write_text("\n".join(rows) + "\n")
    with pytest.raises(InputError, match=r"odd\.stl has a vertex that is not finite"):
        load_mesh(MeshFile("t", file, np.eye(4), 1.0))
    assert capfd.readouterr() == ("", "")


def test_numbers_of_an_obj_may_begin_with_a_point(tmp_path: Path) -> None:
    file = tmp_path / "wedge.OBJ"
    file.write_text("# .5\nv .1 .25 -.5\nv 1. 0 0\nv\t0 1 .75e-1\nv 0 0 1\nf 1 2 3\nf 1/1/1 2//2 4\n")
    mesh = load_mesh(MeshFile("t", file, np.eye(4), 2.0))
    np.testing.assert_allclose(mesh.vertices, 2 * np.array([[0.1, 0.25, -0.5], [1, 0, 0], [0, 1, 0.075], [0, 0, 1]]))
    assert len(mesh.triangles) == 2


@pytest.mark.parametrize(("text", "why"), [("v .1 0 0\nf 1 2 9\n", "vertex index out of range"), ("", "too small")])
def test_an_obj_that_is_none_is_told_by_its_own_name(text: str, why: str, tmp_path: Path) -> None:
    file = tmp_path / "odd.obj"
    file.write_text(text)
    with pytest.raises(InputError, match=why) as told:
        load_mesh(MeshFile("t", file, np.eye(4), 1.0))
    assert str(file) in str(told.value)
