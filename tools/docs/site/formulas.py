"""MkDocs hook: writes formulas as MathML, which browsers show without a script."""

from __future__ import annotations

import html
import re
from typing import Any

from latex2mathml.converter import convert

_FORMULA = re.compile(r'<(span|div) class="arithmatex">\\([(\[])(.*?)\\[)\]]</\1>', re.DOTALL)


def on_page_content(content: str, **_: Any) -> str:
    """Replace the formulas of a page, as pymdownx.arithmatex marks them."""
    return _FORMULA.sub(lambda found: _mathml(html.unescape(found[3]), is_block=found[2] == "["), content)


def _mathml(latex: str, is_block: bool) -> str:
    return convert(latex.strip(), display="block" if is_block else "inline")
