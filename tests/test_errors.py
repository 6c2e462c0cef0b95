"""What an error prints: a page at most, in lines that a terminal can show."""

from __future__ import annotations

from trajopt_cli.errors import InputError, InputErrorGroup, terminal_text


def test_of_a_line_without_end_the_ends_are_shown() -> None:
    error = InputError(f"'{'a' * 5000}' is unknown; give another", file="f" * 3000, line=3)
    assert len(str(error)) < 1000
    assert str(error).startswith("fff")
    assert str(error).endswith("aaa' is unknown; give another")
    assert terminal_text("x" * 1000) == "x" * 1000
    assert terminal_text(f"{'x' * 999}\n{'y' * 999}").count("x") == 999


def test_what_a_terminal_would_obey_is_written_as_an_escape() -> None:
    assert terminal_text("a\x1b[31mb\x9b\r\tc\nd\udc80") == "a\\x1b[31mb\\x9b\\r\tc\nd\\udc80"
    assert str(InputError("of \x07", file="\x1b]0;x")) == "\\x1b]0;x: of \\x07"
    assert InputError("no 'a\nb'", file="c\nd", excerpt="e\n^").shown() == "c\\nd: no 'a\\nb'\ne\n^"


def test_of_many_mistakes_a_page_is_shown_with_their_number() -> None:
    few = InputErrorGroup([InputError(f"mistake {k}", file="f", line=k, excerpt="    x\n    ^") for k in range(20)])
    assert few.shown().count("mistake") == few.shown().count("^") == 20
    many = InputErrorGroup([InputError(f"mistake {'m' * 300}", file="f", line=k) for k in range(40)])
    assert 3000 < len(many.shown()) < 3600
    *lines, last = many.shown().splitlines()
    assert last == f"{40 - len(lines)} more are not shown; correct these first"
    assert len(many.errors) == str(many).count("\n") + 1 == 40
    alone = InputErrorGroup([InputError("x", excerpt="x\n" * 3000), InputError("y")])
    assert alone.shown().endswith("\n1 more are not shown; correct these first")
