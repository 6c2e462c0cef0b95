"""How every picture looks, and how a figure becomes the same bytes every time.

Colours are those of Okabe and Ito (2008), chosen for colour-blind readers; each comes with a line style of its own so
that a grey print can be read too. Figures are made without pyplot: no window, no list of open figures.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from io import BytesIO
from typing import Any, Literal

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

BLACK, GREY, PALE = "#000000", "#5f5f5f", "#e4e4e4"
BLUE, VERMILLION, GREEN, ORANGE, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7", "#56b4e9"

# What matplotlib takes for a line: a name, or an offset and the lengths of strokes and gaps.
LineStyle = Literal["-"] | tuple[float, tuple[float, ...]]
# Colour and line style of x, y, z and of joints 1 to 6.
AXIS_STYLES: tuple[tuple[str, LineStyle], ...] = ((BLUE, "-"), (VERMILLION, (0, (5, 1.5))), (GREEN, (0, (1.5, 1.2))))
JOINT_STYLES: tuple[tuple[str, LineStyle], ...] = (
    (BLACK, "-"),
    (VERMILLION, (0, (6, 1.5))),
    (BLUE, (0, (1.5, 1.2))),
    (GREEN, (0, (6, 1.5, 1.5, 1.5))),
    (PURPLE, "-"),
    (ORANGE, (0, (3, 1.2))),
)
LIMIT = {"color": GREY, "linestyle": (0, (4, 3)), "linewidth": 1.1}

WIDTH = 11.0  # in; printed at half of it every text still has half of the sizes below
DPI = 110
_EDGE = 0.012  # of the width, beside headings
_LETTERS = 6  # that are kept of a first part at least
TITLE, TEXT, SMALL, LEAST = 15.0, 13.0, 11.5, 10.5  # pt
ROUND = [1, 2, 5, 10]
"""Ticks are these times a power of ten apart."""

_SETTINGS: dict[Any, Any] = {
    "font.family": "DejaVu Sans",  # comes with matplotlib: the same glyphs on every machine
    "font.size": TEXT,
    "axes.labelsize": TEXT,
    "axes.titlesize": TEXT,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "legend.fontsize": SMALL,
    "legend.frameon": False,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.8,
    "lines.linewidth": 1.8,
    "hatch.linewidth": 1.0,
    "axes.formatter.useoffset": False,
    "path.simplify": True,  # long curves are thinned to a ninth of a pixel; the data of the figure stay whole
    "svg.fonttype": "path",  # a viewer needs no font
    "svg.hashsalt": "trajopt",  # else ids in the file are random
}
# Which backend shows figures is the caller's business: these are never touched.
_NOT_OURS = {"backend", "backend_fallback", "interactive", "toolbar", "webagg.port"}


@contextmanager
def house_style() -> Iterator[None]:
    """Matplotlib's defaults with the settings above, whatever the user's matplotlibrc says; put back afterwards."""
    ours = {name: value for name, value in matplotlib.rcParamsDefault.items() if name not in _NOT_OURS}
    with matplotlib.rc_context({**ours, **_SETTINGS}):
        yield


def new_figure(height: float, heading: str, below: str = "") -> Figure:
    """An empty figure WIDTH x height in, its heading and the line below it at the top left, either shortened in its
    middle where it is wider than the page; layout is automatic."""
    figure = Figure(figsize=(WIDTH, height), dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    room = (0.72 if below else 0.45) / height
    layout = figure.get_layout_engine()
    assert layout is not None
    layout.set(rect=(0, 0, 1, 1 - room), w_pad=0.1, h_pad=0.06)  # type: ignore[call-arg]
    _shortened(figure.text(_EDGE, 1 - 0.1 / height, heading, size=TITLE, weight="bold", va="top"))
    if below:
        _shortened(figure.text(_EDGE, 1 - 0.38 / height, below, size=TEXT, color=GREY, va="top"))
    return figure


def _shortened(text: Text) -> None:
    """Take letters out of a text's first part, as of a program's long name, until it fits the page's width."""
    first, dot, rest = text.get_text().partition(" · ")
    figure = text.get_figure()
    assert figure is not None
    room = (1 - _EDGE) * figure.bbox.x1

    def keep(letters: int) -> None:
        text.set_text(f"{first[: letters // 2]}…{first[-(letters - letters // 2) :]}{dot}{rest}")

    low, high = _LETTERS, len(first)
    if high <= low or text.get_window_extent().x1 <= room:
        return
    while high - low > 1:
        middle = (low + high) // 2
        keep(middle)
        low, high = (middle, high) if text.get_window_extent().x1 <= room else (low, middle)
    keep(low)


def settle(figure: Figure) -> None:
    """Lay the figure out once; afterwards nothing moves, so that text can be measured and drawing is quick."""
    layout = figure.get_layout_engine()
    assert layout is not None
    layout.execute(figure)
    figure.set_layout_engine(None)  # "none" would keep a placeholder, for which each file is drawn twice
    for axes in figure.axes:
        # the solver of the layout leaves other last digits in other processes, and ids in the file are made of them
        axes.set_position(np.round(axes.get_position(original=True).bounds, 6).tolist())
        axes.apply_aspect()  # otherwise left to the first drawing


def name_limit(axes: Axes, value: float, text: str, below: bool = False) -> None:
    """A thin dashed line across at value, named at its right end, above the line or below it."""
    axes.axhline(value, **LIMIT)  # type: ignore[arg-type]
    axes.annotate(
        text, (1, value), (-3, -3 if below else 3), xycoords=("axes fraction", "data"), textcoords="offset points",
        ha="right", va="top" if below else "bottom", size=SMALL, color=GREY,
    )  # fmt: skip


def files(name: str, figure: Figure, title: str) -> dict[str, bytes]:
    """A settled figure as name.svg and name.png; the same figure gives the same bytes."""
    svg, png = BytesIO(), BytesIO()
    figure.savefig(svg, format="svg", metadata={"Date": None, "Creator": None, "Title": title})
    # Default packing takes a third longer and saves 3 % of the size.
    packing = {"compress_level": 3}
    figure.savefig(png, format="png", dpi=DPI, metadata={"Software": None, "Title": title}, pil_kwargs=packing)
    return {f"{name}.svg": svg.getvalue(), f"{name}.png": png.getvalue()}
