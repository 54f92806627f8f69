"""MkDocs hooks: all decisions in the menu, weights of pages in the search, and formulas as MathML without a script."""

import html
import re
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert

WEIGHTS = {"Tutorials": 4, "How-to": 4, "Reference": 1.5}
"""Weights in the search by section of the menu; pages for users come before those for contributors."""

_FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)


def on_config(config: Any) -> None:
    """Add the decisions to the last section of the menu."""
    names = sorted(path.name for path in Path(config.docs_dir, "decisions").glob("*.md"))
    (last,) = config.nav[-1].values()
    last.append({"All decisions": [f"decisions/{name}" for name in names if name != "README.md"]})


def on_page_markdown(markdown: str, page: Any, **_: Any) -> None:
    """Set the weight of a page."""
    page.meta["search"] = {"boost": WEIGHTS.get(page.ancestors[-1].title, 0.5)}


def on_page_content(content: str, **_: Any) -> str:
    """Replace the formulas of a page, as pymdownx.arithmatex marks them."""
    return _FORMULA.sub(lambda found: _mathml(html.unescape(found[3]), is_block=found[2] == "["), content)


def _mathml(latex: str, is_block: bool) -> str:
    return convert(latex.strip(), display="block" if is_block else "inline")
