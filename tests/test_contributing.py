"""CONTRIBUTING.md is true: its floors are those that the test on imports holds, and the files it names are there."""

from __future__ import annotations

import re
from pathlib import Path

from test_architecture import FLOORS, INNER

REPOSITORY = Path(__file__).parents[1]
TEXT = (REPOSITORY / "CONTRIBUTING.md").read_text(encoding="utf-8")
GLOSSARY = (REPOSITORY / "docs/glossary.md").read_text(encoding="utf-8")
WORDS = {
    *("waypoint", "segment", "leg", "run", "station", "stop", "fly-by", "coordinated", "free rail", "warm start"),
    *("back-off", "velocity", "branch", "configuration", "turn", "coupling", "plan", "problem", "finding"),
    *("lower bound", "gap"),
}


def rows(section: str, text: str = TEXT) -> list[list[str]]:
    """The cells of the table in one section, without its head."""
    lines = [line for line in text.split(f"# {section}\n")[1].split("\n## ")[0].splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines[2:]]


def test_the_floors_are_those_of_the_test_on_imports() -> None:
    told = {int(floor): set(re.findall(r"`(\w+)`", rooms)) for floor, rooms, _ in rows("Rooms and floors")}
    assert told == {i: set(floor) for i, floor in enumerate(FLOORS)}


def test_the_rooms_inside_iiwa_are_told_in_their_order() -> None:
    inner = [room for floor in INNER["iiwa"] for room in floor]
    places = [re.search(rf"the iiwa job:[^|]*?\b{room}\b", TEXT) for room in inner]
    assert all(places)
    assert [place.end() for place in places if place] == sorted(place.end() for place in places if place)


def test_every_file_it_names_is_there() -> None:
    named = re.findall(r"`((?:trajopt_cli|tests|results|robots|docs)/[\w./]+|\w+\.md)`", TEXT)
    assert len(named) > 10
    for name in named:
        assert (REPOSITORY / name).exists() or "NAME" in name, name


def test_the_glossary_has_the_fields_words_in_order() -> None:
    words = [row[0] for row in rows("Glossary", GLOSSARY)]
    assert words == sorted(words, key=str.lower)
    assert {part for word in words for part in word.split(", ")} >= WORDS


def test_it_stays_short() -> None:
    assert len(TEXT.splitlines()) < 150
