"""The page as a file: complete in itself, the same every time, and nothing in a program's text can break out of it."""

from __future__ import annotations

import json
import re
from base64 import b64decode, b64encode
from hashlib import sha256
from html.parser import HTMLParser

import numpy as np
import pytest

from trajopt_cli.page.document import BASE, Section, document
from trajopt_cli.page.encode import block, text
from trajopt_cli.page.tables import points, table

HOSTILE = "</script><script>alert(1)</script><!-- \u2028 \udc80 \"' &amp; <b>"


class Reader(HTMLParser):
    """Elements with their attributes, and what each script and style holds."""

    def __init__(self) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.held: list[tuple[str, str]] = []
        self.words = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        tag = self.elements[-1][0] if self.elements else ""
        if tag in ("script", "style") and data.strip():
            self.held.append((tag, data))
        else:
            self.words += data


def read(page: bytes) -> Reader:
    reader = Reader()
    reader.feed(page.decode())
    return reader


def a_page(words: str = "plain") -> bytes:
    shown = Section("one", words, points([words]) + table(words, ["a", ">b"], [[words, "1"]]), words)
    return document(words, f"<h1>{text(words)}</h1>", [shown], {"words": words, "y": block([1.5, -2.0])})


def test_a_block_is_little_endian_float32_with_its_shape() -> None:
    values = np.arange(6.0).reshape(2, 3) / 7
    made = block(values.T)  # not contiguous
    assert made["shape"] == [3, 2]
    assert np.array_equal(np.frombuffer(b64decode(made["f32"]), "<f4"), values.T.astype("<f4").ravel())
    assert b64decode(block(1.0)["f32"]) == b"\x00\x00\x80\x3f"
    with pytest.raises(ValueError, match="1 of 2 numbers are not finite"):
        block([1.0, np.nan])


def test_hostile_text_stays_text() -> None:
    plain, hostile = read(a_page()), read(a_page(HOSTILE))
    assert [tag for tag, _ in hostile.elements] == [tag for tag, _ in plain.elements]
    held = next(content for (tag, content) in hostile.held if content.startswith("{"))
    assert json.loads(held)["words"] == HOSTILE
    assert hostile.words.count("alert(1)") == 8  # title, h1, link, heading, lead, list, caption, cell


def test_the_page_asks_for_nothing_and_its_policy_names_its_own_scripts() -> None:
    page = read(a_page())
    for tag, attributes in page.elements:
        assert "src" not in attributes, tag
        assert not str(attributes.get("href", "#")).startswith(("http", "//")), attributes
        assert "style" not in attributes
        assert not any(name.startswith("on") for name in attributes), attributes
    policy = next(a["content"] for _, a in page.elements if a.get("http-equiv") == "Content-Security-Policy")
    assert policy is not None
    assert policy.startswith("default-src 'none'; ")
    assert "unsafe" not in policy
    programs = [content for tag, content in page.held if tag == "script" and not content.startswith("{")]
    styles = [content for tag, content in page.held if tag == "style"]
    assert len(programs) == len(BASE)
    for content in (*programs, *styles):
        assert f"'sha256-{b64encode(sha256(content.encode()).digest()).decode()}'" in policy
        assert not re.search(r"https?://|\bfetch\(|XMLHttpRequest|WebSocket|import\(|@import", content)


def test_the_same_arguments_give_the_same_bytes() -> None:
    assert a_page(HOSTILE) == a_page(HOSTILE)
    assert a_page("one") != a_page("two")


def test_a_page_of_a_cycle_can_be_played() -> None:
    names = {a.get("id") for _, a in read(document("t", "", [], {"clock": {"duration": 1.0, "cycles": []}})).elements}
    assert {"transport", "play", "time", "rate", "clocks", "data", "main", "theme"} <= names
    assert "transport" not in {a.get("id") for _, a in read(a_page()).elements}
