"""One self-contained HTML file: a skeleton, the style, the scripts and one block of data.

The scripts are written by hand: plotting libraries for the browser are some megabytes each, and would be most of the
page. The page may fetch nothing: its policy names the hashes of its own scripts and style, and forbids all else; with
it go style attributes, so what has a place of its own is placed by a class, by SVG attributes or by a script.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import Any

from trajopt_cli import __version__
from trajopt_cli.page.encode import embedded, text

BASE = ("page.js", "charts.js")
"""What every page has: data, clock, theme, transport; charts. More scripts follow, then all that registered starts."""


@dataclass(frozen=True)
class Section:
    """A part of a page. name: its id, for links. heading: of its own. html: its content, escaped by who made it. lead:
    a plain sentence below the heading. keys: another on the use of keyboard and mouse, left out on a telephone."""

    name: str
    heading: str
    html: str
    lead: str = ""
    keys: str = ""


def document(
    title: str, head: str, sections: Sequence[Section], data: Mapping[str, Any], scripts: Sequence[str] = ()
) -> bytes:
    """The page's bytes, the same for the same arguments.

    title: plain text. head: HTML above the sections. data: what the scripts read, JSON; "clock": {"duration": s,
    "cycles": [{"name", "duration"}]} brings the transport, "charts" what elements with data-chart show (see charts.js),
    "arrays" the blocks that charts name. scripts: of the folder assets, behind BASE, in order; names in .css join the
    style. Raises ValueError for numbers that are not finite.
    """
    style = "".join(asset(name) for name in ("page.css", *scripts) if name.endswith(".css"))
    programs = [asset(name) for name in (*BASE, *scripts) if name.endswith(".js")]
    policy = (
        f"default-src 'none'; script-src {' '.join(_hash(one) for one in programs)}; style-src {_hash(style)};"
        " img-src data:; base-uri 'none'; form-action 'none'"
    )
    links = "".join(f'<li><a href="#{text(one.name)}">{text(one.heading)}</a></li>' for one in sections)
    page = [
        "<!doctype html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        '<meta name="color-scheme" content="light dark">',
        f'<meta name="generator" content="trajopt {text(__version__)}">',
        '<link rel="icon" href="data:,">',
        f"<title>{text(title)}</title>",
        f"<style>{style}</style>",
        "</head>",
        "<body>",
        '<a class="skip" href="#main">Skip to content</a>',
        f'<header class="head"><div class="bar"><nav aria-label="Sections"><ul>{links}</ul></nav>'
        '<button type="button" id="theme" class="quiet">Theme: system</button></div>',
        head,
        "</header>",
        '<main id="main">',
        "<noscript><p>Charts, source and the 3-D view need JavaScript. The tables do not.</p></noscript>",
        *(_section(one) for one in sections),
        "</main>",
        _TRANSPORT if "clock" in data else "",
        f'<script type="application/json" id="data">{embedded(data)}</script>',
        *(f"<script>{one}</script>" for one in programs),
        "</body>",
        "</html>",
        "",
    ]
    # a lone surrogate of a program becomes a reference; each by itself, for with an arrow a text takes twice the memory
    return b"\n".join([one.encode(errors="xmlcharrefreplace") for one in page])


@cache
def asset(name: str) -> str:
    """A file of the folder assets. Raises ValueError where it would end its own element."""
    content = files("trajopt_cli.page").joinpath("assets", name).read_text(encoding="utf-8")
    for end in ("</script", "</style", "<!--"):
        if end in content.lower():
            raise ValueError(f"assets/{name} holds {end}, which ends the element it stands in")
    return content


def _hash(content: str) -> str:
    return f"'sha256-{b64encode(sha256(content.encode()).digest()).decode()}'"


def _section(one: Section) -> str:
    lead = f'<p class="lead">{text(one.lead)}</p>' if one.lead else ""
    lead += f'<p class="lead keys">{text(one.keys)}</p>' if one.keys else ""
    name = text(one.name)
    return (
        f'<section id="{name}" aria-labelledby="{name}-heading"><h2 id="{name}-heading">{text(one.heading)}</h2>'
        f"{lead}\n{one.html}\n</section>"
    )


_SPEEDS = "".join(
    f'<option value="{rate}"{" selected" if rate == "1" else ""}>{rate}×</option>' for rate in ("0.1", "0.25", "1", "2")
)
_TRANSPORT = f"""<div id="transport" role="group" aria-label="Playback">
<button type="button" id="play" aria-pressed="false">Play</button>
<input type="range" id="time" min="0" max="1" step="any" value="0" aria-label="Time in the cycle">
<div id="clocks"></div>
<button type="button" id="whole" hidden>Whole cycle</button>
<label>Speed <select id="rate">{_SPEEDS}</select></label>
</div>"""
