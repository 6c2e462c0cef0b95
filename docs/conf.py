"""How the manual is built: `sphinx-build -W docs site`. It needs no network, neither for building nor for reading."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from generated import filled, with_subscripts
from rapid_lexer import RapidLexer
from sphinx.application import Sphinx

import trajopt_cli

project = "trajopt"
author = "trajopt contributors"
copyright = "trajopt contributors, MIT licence"
version = release = trajopt_cli.__version__

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx_copybutton"]
myst_heading_anchors = 3
highlight_language = "none"
default_role = "code"  # docstrings quote names as Markdown does
autodoc_class_signature = "separated"
autodoc_preserve_defaults = True
add_module_names = False  # trajopt_cli gives them all
python_maximum_signature_line_length = 90

html_theme = "furo"
html_title = f"trajopt {release}"
html_static_path = ["_static"]
html_css_files = ["wide.css"]
html_copy_source = False
html_show_sphinx = False
copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True


def setup(app: Sphinx) -> None:
    """Fill the generated parts in before a page is parsed; know RAPID."""
    app.add_lexer("rapid", RapidLexer)
    app.connect("source-read", _read)


def _read(_app: Sphinx, page: str, source: list[str]) -> None:
    source[0] = with_subscripts(source[0]) if page == "mathematics" else filled(source[0])
