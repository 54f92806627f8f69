"""Map tips: what a feature says when the mouse rests on it, as HTML with QGIS's expressions inside."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

PICTURE_PX = 260
"""Width of a picture in a tip."""


def number(column: str, decimals: int = 0, factor: float = 1, unit: str = "") -> str:
    """Expression of a column's number as the user's locale writes it."""
    value = f'"{column}"' if factor == 1 else f'{factor:g} * "{column}"'
    return f"format_number({value}, {decimals})" + (f" || '\u00a0{unit}'" if unit else "")


def text(column: str) -> str:
    """Expression of a column's text as it may stand in HTML."""
    return _escaped(f'to_string("{column}")')


def file_name(column: str) -> str:
    """Expression of the name of the file whose path a column has."""
    return _escaped(f'file_name("{column}")')


def worded(column: str, words: dict[str, str]) -> str:
    """Expression of the words for a column's key; a key without words, of another version, stands for itself."""
    cases = " ".join(
        f"WHEN \"{column}\" = '{quoted(key)}' THEN '{quoted(escape(said))}'" for key, said in words.items()
    )
    return f"CASE {cases} ELSE {text(column)} END"


def tip(heading: str, rows: Sequence[tuple[str, str]], picture: str = "") -> str:
    """The tip; rows whose expression is NULL are left out.

    Args:
        heading: Expression.
        rows: (title, expression) of each line.
        picture: Column that names a picture; empty for none.
    """
    lines = "".join(_row(title, expression) for title, expression in rows)
    image = _picture(picture) if picture else ""
    return f'<b>[% {heading} %]</b>{image}<table cellpadding="2">{lines}</table>'


def _row(title: str, expression: str) -> str:
    cells = f"'<tr><td>{quoted(escape(title))}</td><td><b>' || ({expression}) || '</b></td></tr>'"
    return f"[% coalesce({cells}, '') %]"


def _picture(column: str) -> str:
    """A picture that is there; one that Qt can't show is an empty line."""
    path = f"replace(\"{column}\", '\\\\', '/')"
    # The sign of escapes first, then what ends an address or an attribute.
    path = f"replace({path}, '%', '%25')"
    path = f"replace({path}, map('\"', '%22', '#', '%23', '<', '%3C', '>', '%3E', '?', '%3F', ' ', '%20'))"
    path = f"regexp_replace({path}, '^/+', '')"
    # Before it is asked whether there is such a file: that would ask another computer.
    elsewhere = f"regexp_match(\"{column}\", '^[/\\\\\\\\]{{2}}|^/vsi|^[A-Za-z][^/\\\\\\\\]+:')"
    tag = f"'<br><img width=\"{PICTURE_PX}\" src=\"file:///' || {path} || '\">'"
    return f"[% CASE WHEN {elsewhere} > 0 THEN '' WHEN file_exists(\"{column}\") THEN {tag} ELSE '' END %]"


def _escaped(expression: str) -> str:
    return f"replace(replace({expression}, '&', '&amp;'), map('<', '&lt;', '>', '&gt;'))"


def quoted(said: str) -> str:
    """A text as it may stand between the quotes of an expression inside [% %]."""
    return said.replace("'", "''").replace("%]", "% ]")
