"""QML of the default styles of a database's layers, for where there is no QGIS.

What ``processing/exchange/styles.py`` has QGIS write, in as few words as QGIS reads.
"""

from __future__ import annotations

from html import escape

from ...core.labels.class_table import ClassTable
from . import schema
from .titles import SENTENCES_OF_REFERENCES, SENTENCES_OF_WINDOWS

_WINDOW_COLOR = "31,95,191,255"
_DOCTYPE = "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"


def plain_styles(table: ClassTable) -> dict[str, str]:
    """QML by table: thin outlines of windows, dots of landmarks and areas of the overview in the class colors."""
    return {
        schema.WINDOWS: _vector(
            '<renderer-v2 type="singleSymbol">'
            f"<symbols>{_symbol('fill', 0, 'SimpleFill', _WINDOW)}</symbols></renderer-v2>",
            2,
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
        symbols.append(_symbol("marker", number, "SimpleMarker", {**_DOT, "color": _rgba(c.color)}))
    return _vector(
        f'<renderer-v2 type="categorizedSymbol" attr="class"><categories>{"".join(categories)}</categories>'
        f"<symbols>{''.join(symbols)}</symbols></renderer-v2>",
        0,
        SENTENCES_OF_REFERENCES,
    )


def _overview(table: ClassTable) -> str:
    entries = "".join(
        f'<paletteEntry value="{c.value}" color="{c.color}" alpha="255" label="{escape(c.name)}"/>'
        for c in table
        if c.value
    )
    return (
        f'{_DOCTYPE}<qgis version="3.22" styleCategories="Symbology"><pipe>'
        f'<rasterrenderer type="paletted" band="1" opacity="1" alphaBand="-1"><colorPalette>{entries}</colorPalette>'
        "</rasterrenderer></pipe><blendMode>0</blendMode></qgis>\n"
    )


def _vector(renderer: str, geometry: int, titles: dict[str, str]) -> str:
    aliases = "".join(f'<alias field="{name}" name="{escape(text)}"/>' for name, text in titles.items())
    return (
        f'{_DOCTYPE}<qgis version="3.22" styleCategories="Symbology|Fields">{renderer}<blendMode>0</blendMode>'
        f"<featureBlendMode>0</featureBlendMode><aliases>{aliases}</aliases>"
        f"<layerGeometryType>{geometry}</layerGeometryType></qgis>\n"
    )


def _symbol(kind: str, name: int, layer: str, properties: dict[str, str]) -> str:
    """Both ways in which QGIS 3 has written what a symbol layer is like; each version reads one."""
    options = "".join(f'<Option type="QString" name="{key}" value="{value}"/>' for key, value in properties.items())
    older = "".join(f'<prop k="{key}" v="{value}"/>' for key, value in properties.items())
    return (
        f'<symbol type="{kind}" name="{name}" alpha="1" clip_to_extent="1">'
        f'<layer class="{layer}" enabled="1" locked="0" pass="0"><Option type="Map">{options}</Option>{older}</layer>'
        "</symbol>"
    )


def _rgba(color: str) -> str:
    """``#rrggbb`` as QGIS writes it."""
    return ",".join(str(int(color[n : n + 2], 16)) for n in (1, 3, 5)) + ",255"
