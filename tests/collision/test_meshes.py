"""Mesh files that cannot be meant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from trajopt_cli.collision.meshes import load_mesh
from trajopt_cli.errors import InputError
from trajopt_cli.shapes import MeshFile


def test_a_vertex_that_is_no_number_is_told_with_the_file(tmp_path: Path) -> None:
    rows = ["solid t", "facet normal 0 0 1", "outer loop"]
    rows += ["vertex 0 0 0", "vertex 1 0 0", "vertex nan 1 0", "endloop", "endfacet", "endsolid t"]
    file = tmp_path / "odd.stl"
    file.write_text("\n".join(rows) + "\n")
    with pytest.raises(InputError, match=r"odd\.stl has a vertex that is not finite"):
        load_mesh(MeshFile("t", file, np.eye(4), 1.0))
