"""The page of an answer that is a table, lines and pictures: sensitivity, place, order."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Mapping

from trajopt_cli.page.document import Section, document
from trajopt_cli.page.encode import text
from trajopt_cli.page.tables import drawn, points
from trajopt_cli.table import TextTable


def answer_page(
    title: str, answer: str, tables: Iterable[TextTable], lines: Iterable[str], pictures: Mapping[str, bytes]
) -> bytes:
    """The page's bytes. answer: the result in a line. lines: what is to be said besides. pictures: files by name, of
    which the .svg ones are shown."""
    shown = {name: content for name, content in pictures.items() if name.endswith(".svg")}
    images = "".join(
        f'<figure class="picture"><img alt="{text(name)}" src="data:image/svg+xml;base64,{data}"></figure>'
        for name, content in shown.items()
        if (data := b64encode(content).decode())
    )
    sections = [Section("answer", "Answer", "".join(map(drawn, tables)) + points(lines), answer)]
    sections += [Section("pictures", "Pictures", images)] if images else []
    return document(f"{title} · trajopt", f"<h1>{text(title)}</h1>", sections, {}, ("picture.css",))
