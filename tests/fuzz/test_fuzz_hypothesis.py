"""Documents that hypothesis puts together from the keys that files may have: well-formed, wrong in what they say."""

from __future__ import annotations

import json
from typing import Any

import pytest
from fuzz_oracle import guarded
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from trajopt_cli.cell.loader import parse_cell
from trajopt_cli.cell.schema import cell_schema
from trajopt_cli.iiwa.task.loader import parse_task
from trajopt_cli.joint_csv import read_csv_text


def keys(schema: Any) -> set[str]:
    """All names of keys in a JSON schema."""
    if isinstance(schema, list):
        return {key for one in schema for key in keys(one)}
    if not isinstance(schema, dict):
        return set()
    own = set(schema.get("properties", {})) if isinstance(schema.get("properties"), dict) else set()
    return own | {key for one in schema.values() for key in keys(one)}


KEYS = sorted(keys(cell_schema()))
SCALARS = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(st.characters(exclude_categories=["Cs"]), max_size=8),
    st.sampled_from(["irb140", "irb140_rail", "iiwa7", "a", "30 deg", "0.5 m", "[0, 0, 0, 0, 30, 0] deg", "10 mm"]),
)  # fmt: skip
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.sampled_from(KEYS), inner, max_size=4),
    max_leaves=12,
)
NUMBERS = st.one_of(
    st.floats().map(repr), st.integers().map(str), st.sampled_from(["", " 1", "1e-320", "1_0", "0x1", "+1", "٣", "-0"])
)
ALWAYS_THE_SAME = settings(
    derandomize=True, database=None, deadline=None, max_examples=100, suppress_health_check=[*HealthCheck]
)


@pytest.fixture(scope="module")
def base() -> dict[str, Any]:
    return {"robot": "irb140", "start": {"joints": [0, 0, 0, 0, 0.5, 0]}}


@ALWAYS_THE_SAME
@given(st.dictionaries(st.sampled_from(KEYS), VALUES, max_size=5))
def test_any_cell_is_read_or_refused(base: dict[str, Any], more: dict[str, Any]) -> None:
    ended = guarded(lambda: str(parse_cell(json.dumps({**base, **more}), "c.yaml") and "read"))
    assert ended.finding is None, ended.finding


@ALWAYS_THE_SAME
@given(st.dictionaries(st.sampled_from(KEYS), VALUES, max_size=5))
def test_any_task_is_read_or_refused(more: dict[str, Any]) -> None:
    ended = guarded(lambda: str(parse_task(json.dumps({"robot": "iiwa7", **more}), "t.yaml") and "read"))
    assert ended.finding is None, ended.finding


@ALWAYS_THE_SAME
@given(st.lists(st.lists(NUMBERS, min_size=3, max_size=3), max_size=6))
def test_any_rows_are_read_or_refused(rows: list[list[str]]) -> None:
    text = "\n".join(["t [s],joint_1 [rad],joint_1 [rad/s]", *(",".join(row) for row in rows)])
    ended = guarded(lambda: str(read_csv_text(text, "j.csv") and "read"))
    assert ended.finding is None, ended.finding
