"""Files written to break the reader: one line with its place for each, and soon."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import pytest
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, StrictBool, StrictStr, model_validator

from trajopt_cli.errors import InputError
from trajopt_cli.quantity import LENGTH, RATIO, complain, number, numbers, option_value
from trajopt_cli.yaml_file import parse, read_text, refuse_empty, validated

SMALLER = "give the poses in a RAPID program or split the task"
DEEP = "nests sections and lists deeper than 50 levels; no key needs that"
MANY = f"holds more than 200000 keys and values, aliases expanded; {SMALLER}"


def lists_of_lists() -> str:
    first = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n"
    return first + "".join(f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 10))


def merges_of_merges() -> str:
    first = "a0: &a0 {x: 1}\n"
    return first + "".join(f"a{i}: &a{i} {{<<: [{', '.join([f'*a{i - 1}'] * 10)}]}}\n" for i in range(1, 12))


@pytest.mark.parametrize("more", [0, 60_000])  # characters: a long file is read anew
def test_a_text_that_was_read_is_another_one_s_own(more: int) -> None:
    text = f"a: {{b: [1, 2]}}\nc: x  # {'.' * more}\n"
    content, lines = parse(text, "one.yaml", "a key is needed")
    content["a"]["b"].append(3)
    lines["a"] = 9
    again, places = parse(text, "two.yaml", "two keys are needed")
    assert again == {"a": {"b": [1, 2]}, "c": "x"}
    assert places == {"a": 1, "a.b": 1, "a.b.0": 1, "a.b.1": 1, "c": 2}
    for file, needed in (("one.yaml", "a key is needed"), ("two.yaml", "two keys are needed")):
        for wrong, told in (("a: [", f"{file}:1:"), ("", needed)):
            with pytest.raises(InputError) as error:
                parse(wrong, file, needed)
            assert told in str(error.value)


def message(text: str) -> str:
    started = time.perf_counter()
    with pytest.raises(InputError) as caught:
        parse(text, "t.yaml", "a key is needed")
    assert time.perf_counter() - started < 10
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a: 1\nh: 2024-13-45\n", "t.yaml:2: h: 2024-13-45 is not a number, text, list or section"),
        ("h: !!int foo\n", "t.yaml:1: h: foo is not of type !!int; remove the tag"),
        ("h: !!int ''\n", 't.yaml:1: h: "" is not of type !!int; remove the tag'),
        ("h: !!float x\n", "t.yaml:1: h: x is not of type !!float; remove the tag"),
        ("h: !!bool x\n", "t.yaml:1: h: x is not of type !!bool; remove the tag"),
        ("h: " + "1" * 5000, "t.yaml:1: h: needs a finite number, not one of 5000 digits"),
        (
            "a:\n  h: !!python/object/apply:os.system [ls]\n",
            "t.yaml:2: a.h: has the tag !!python/object/apply:os.system; remove it",
        ),
        ("h: !mine 3\n", "t.yaml:1: h: has the tag !mine; remove it"),
        ("h: !!set {a}\n", "t.yaml:1: h: has the tag !!set; remove it"),
        ("h: !!map [1]\n", "t.yaml:1: h: has the tag !!map; remove it"),
        ('h: "\\UFFFFFFFF"\n', "t.yaml: broken YAML: an escape after \\ is not a character"),
        ('h: "\\ud800"\n', 't.yaml:1: h: "\\ud800" holds half of a character (a surrogate)'),
        ("{a: " * 3000, f"t.yaml:1: {DEEP}"),
        ("a: " + "[" * 100_000, f"t.yaml:1: {DEEP}"),
        ("a:\n" + "- " * 50_000, f"t.yaml:2: {DEEP}"),
        ("a: &a [*a]\n", f"t.yaml:1: {DEEP}"),
        ("a: &a {<<: *a}\n", f"t.yaml:1: {DEEP}"),
        (lists_of_lists(), f"t.yaml:1: {MANY}"),
        (merges_of_merges(), f"t.yaml:1: {MANY}"),
        (lists_of_lists() + "? *a9\n: 1\n", "t.yaml:10: a key is a list or a section; keys are text"),
        ("a: [" + "1," * 300_000 + "1]\n", f"t.yaml:1: {MANY}"),
        ("a: 1\n" + "#" * 2_000_000, f"t.yaml: holds 2 MB of text, more than 1 MB; {SMALLER}"),
        ("a: *" + "b" * 5000, "t.yaml:1: broken YAML: found undefined alias '" + "b" * 54 + "..."),
        ("a: 1\n---\nb: 1\n", "expected a single document in the stream, but found another document"),
        ("'': 1\n", 't.yaml:1: key "" is empty, of more than 100 characters, or not printable'),
        ('"a\\nb": 1\n', 't.yaml:1: key "a\\nb" is empty, of more than 100 characters, or not printable'),
        ("a: {~: 1}\n", "t.yaml:1: key a.~ is not text; put it in quotes"),
        ("<<: 3\n", "t.yaml:1: << takes over a section or a list of sections"),
    ],
)
def test_hostile_yaml_is_one_line(text: str, expected: str) -> None:
    said = message(text)
    assert "\n" not in said
    assert len(said) < 200
    assert said.endswith(expected)


def test_the_keys_of_a_path_cannot_grow_without_bound() -> None:
    key = "k" * 90
    assert message(f"{{{key}: " * 7 + "1" + "}" * 7).endswith("the keys together have more than 500 characters")


def test_what_yaml_allows_still_means_the_same() -> None:
    text = (
        "base: &b {x: 1, y: 1000}\nmore: {<<: *b, x: 5, z: 0x10}\nlist: [*b, yes, ~, 1e3, .5, '7', =]\n"
        "again: &b {on: true}\nlast: *b\n"
    )
    content, lines = parse(text, "t.yaml", "a key is needed")
    assert content == {
        "base": {"x": 1, "y": 1000},
        "more": {"x": 5, "y": 1000, "z": 16},
        "list": [{"x": 1, "y": 1000}, "yes", None, 1000.0, 0.5, "7", "="],
        "again": {"on": True},
        "last": {"on": True},
    }
    assert {type(value) for value in content["list"]} == {dict, str, type(None), float}
    assert (lines["more"], lines["more.x"], lines["list.3"], lines["last.on"]) == (2, 2, 3, 4)
    assert parse("%YAML 1.1\n---\na: yes\nb: 012\n", "t.yaml", "")[0] == {"a": True, "b": 10}


def test_a_file_without_end_is_not_read_to_its_end(tmp_path: Path) -> None:
    big = tmp_path / "big.yaml"
    with open(big, "wb") as file:
        file.truncate(3_000_000_000)
    with pytest.raises(InputError, match=r"big\.yaml: holds 3e\+03 MB of text, more than 1 MB; give the poses"):
        read_text(big, "task file")
    with pytest.raises(InputError, match="/dev/zero: holds 1 MB of text"):
        read_text("/dev/zero", "task file")
    with pytest.raises(InputError, match="cannot read the task file: File name too long"):
        read_text(tmp_path / ("n" * 300), "task file")
    dos = tmp_path / "dos.yaml"
    dos.write_bytes(b"a: 1\r\nb: 2\rc: 3\n")
    assert read_text(dos, "task file") == "a: 1\nb: 2\nc: 3\n"


def test_keys_without_a_value_are_refused_where_asked() -> None:
    text = "a: 1\nsensor:\nd:\n  - {e: 1}\n  - {e: }\n  -\nf: null\n"
    content, lines = parse(text, "t.yaml", "")
    with pytest.raises(InputError) as caught:
        refuse_empty(content, lines, "t.yaml")
    ending = "is empty; give it a value or remove it"
    assert str(caught.value).splitlines() == [
        f"t.yaml:2: sensor: {ending}",
        f"t.yaml:5: d.1.e: {ending}",
        f"t.yaml:6: d.2: {ending}",
        f"t.yaml:7: f: {ending}",
    ]
    refuse_empty({"a": [1, {"b": ""}], "c": False}, {}, "t.yaml")


class Whole(BaseModel):
    """Every kind of key that has a message of its own."""

    model_config = ConfigDict(extra="forbid")
    seed: Annotated[int, Field(strict=True, ge=0)] = 1
    count: Annotated[int, Field(strict=True, gt=0)] = 1
    share: Annotated[float, BeforeValidator(number(RATIO))] = 0.0
    size: Annotated[float, BeforeValidator(number(LENGTH))] = 0.0
    sizes: Annotated[tuple[float, ...], BeforeValidator(numbers(LENGTH, 3))] = ()
    names: tuple[StrictStr, ...] = ()
    flag: StrictBool = False
    inner: dict[StrictStr, float] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _together(self) -> Whole:
        if self.seed == 13:
            raise complain("give one of this and that")
        return self


def refusal(text: str) -> str:
    content, lines = parse(text, "t.yaml", "")
    with pytest.raises(InputError) as caught:
        validated(Whole, content, lines, "t.yaml", {})
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("seed: -1", "seed: needs a whole number, zero or more, not -1"),
        ("seed: 1.5", "seed: needs a whole number, not 1.5"),
        ("seed:", "seed: needs a whole number, not nothing"),
        ("seed: true", "seed: needs a whole number, not true"),
        ("count: 0", "count: needs a whole number above zero, not 0"),
        ("names:", "names: needs a list, not nothing"),
        ("names: {a: 1}", "names: needs a list, not a section"),
        ("names: ''", 'names: needs a list, not ""'),
        ("names: '[a, b]'", 'names: needs a list, not the text "[a, b]"; remove the quotes'),
        ("names: [[a]]", "names.0: needs text, not a list"),
        ("names: [1]", "names.0: needs text, not 1"),
        ("flag: {a: {b: 1}}", "flag: needs true or false, not a section"),
        ('flag: "a\\nb"', 'flag: needs true or false, not "a\\nb"'),
        ("inner: ['x']", "inner: needs a section of 'key: value' lines, not a list"),
        ("share: 3 kg", 'share: "3 kg" has a unit; needs a plain number'),
        ("share: '[1]'", 'share: needs a number, not "[1]"'),
        ("size: " + "9" * 400, "size: needs a finite number, not a number of about 401 digits"),
        ("size: -0x" + "f" * 990, "size: needs a finite number, not a number of about 1193 digits"),
        ("size: ''", 'size: needs a number, not ""'),
        ("size: 1e999 m", 'size: needs a finite number, not "1e999 m"'),
        ('size: "1 m\\nb"', "size: unit 'm b' of \"1 m\\nb\" is not one of m, cm, mm"),
        ("sizes: [1, ~, 1]", "sizes: needs a number, not nothing"),
        ("sizes:", "sizes: needs a list of 3 numbers, not nothing"),
        ("sizes: '[1, 1, 1]'", 'sizes: "[1, 1, 1]" lacks a unit: write "[1, 1, 1] m" (cm, mm are read, too)'),
        ("sizes: '[1, 1, 1'", 'sizes: needs a list of 3 numbers, not "[1, 1, 1"; remove the quotes'),
        ("seed: 13", "give one of this and that"),
    ],
)
def test_a_wrong_value_is_spelled_as_in_the_file(text: str, expected: str) -> None:
    assert refusal(text) == f"t.yaml:1: {expected}"


def test_digits_before_a_line_break_take_no_time() -> None:
    started = time.perf_counter()
    assert refusal('size: "' + "1" * 300_000 + '\\nb"').startswith("t.yaml:1: size: unit 'b' of \"111")
    assert time.perf_counter() - started < 5


def test_of_very_many_mistakes_the_first_are_said() -> None:
    said = refusal("names: [" + "1, " * 500 + "]").splitlines()
    assert len(said) == 21
    assert said[-1] == "t.yaml: and 480 more mistakes"


def test_an_option_is_held_to_the_same() -> None:
    with pytest.raises(InputError, match='--max-lag: needs a finite number, not "1e999 mm"'):
        option_value("1e999 mm", LENGTH, "--max-lag")
