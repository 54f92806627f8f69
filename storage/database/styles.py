"""QML of the default styles of a database's layers, for where there is no QGIS.

What ``processing/exchange/styles.py`` has QGIS write, in as few words as QGIS reads.
"""

from __future__ import annotations

from html import escape

from ...core.labels.class_table import ClassTable
from ..qml import DOCTYPE, POINT, POLYGON, rgba, symbol, vector_style
from . import schema
from .titles import SENTENCES_OF_REFERENCES, SENTENCES_OF_WINDOWS

_WINDOW_COLOR = "31,95,191,255"


def plain_styles(table: ClassTable) -> dict[str, str]:
    """QML by table: thin outlines of windows, dots of landmarks and areas of the overview in the class colors."""
    return {
        schema.WINDOWS: vector_style(
            '<renderer-v2 type="singleSymbol">'
            f"<symbols>{symbol('fill', 0, 'SimpleFill', _WINDOW)}</symbols></renderer-v2>",
            POLYGON,
            SENTENCES_OF_WINDOWS,
        ),
        schema.REFERENCES: _references(table),
        schema.OVERVIEW: _overview(table),
    }


_WINDOW = {"style": "no", "outline_color": _WINDOW_COLOR, "outline_width": "0.2", "outline_style": "solid"}
_DOT = {"name": "circle", "size": "1.8", "outline_color": "255,255,255,255", "outline_width": "0.2"}


def _references(table: ClassTable) -> str:
    categories, symbols = [], []
    for number, c in enumerate(table.references):
        label = escape(c.name)
        categories.append(f'<category render="true" symbol="{number}" value="{c.value}" label="{label}"/>')
        symbols.append(symbol("marker", number, "SimpleMarker", {**_DOT, "color": rgba(c.color)}))
    return vector_style(
        f'<renderer-v2 type="categorizedSymbol" attr="class"><categories>{"".join(categories)}</categories>'
        f"<symbols>{''.join(symbols)}</symbols></renderer-v2>",
        POINT,
        SENTENCES_OF_REFERENCES,
    )


def _overview(table: ClassTable) -> str:
    entries = "".join(
        f'<paletteEntry value="{c.value}" color="{c.color}" alpha="255" label="{escape(c.name)}"/>'
        for c in table
        if c.value
    )
    return (
        f'{DOCTYPE}<qgis version="3.22" styleCategories="Symbology"><pipe>'
        f'<rasterrenderer type="paletted" band="1" opacity="1" alphaBand="-1"><colorPalette>{entries}</colorPalette>'
        "</rasterrenderer></pipe><blendMode>0</blendMode></qgis>\n"
    )
