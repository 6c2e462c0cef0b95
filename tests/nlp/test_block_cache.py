"""Where blocks come from, and what the user is told of it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from trajopt_cli.native.machine import machine
from trajopt_cli.native.store import Store
from trajopt_cli.nlp import block_cache as module
from trajopt_cli.nlp.block_cache import Native, evaluation_notices, library


@pytest.fixture
def fresh() -> Iterator[None]:
    library.cache_clear()
    yield
    library.cache_clear()


def test_nothing_is_said_where_all_is_well(fresh: None) -> None:
    assert isinstance(library(), Native)
    assert [*evaluation_notices()] == []


def test_code_that_cannot_be_kept_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    ours = Native(machine(), Store(tmp_path / "file"))
    ours.store.write("key", {})
    monkeypatch.setattr(module, "library", lambda: ours)
    assert [*evaluation_notices()] == [
        f"compiled code cannot be kept and is made anew in every run: {tmp_path}/file: File exists"
    ]
