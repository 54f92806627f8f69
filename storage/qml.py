"""Styles of vector layers as QML, for where there is no QGIS: in as few words as QGIS reads."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

DOCTYPE = "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"

POINT, POLYGON = 0, 2
"""QGIS's numbers for kinds of geometry."""


def vector_style(
    renderer: str,
    geometry: int,
    titles: Mapping[str, str],
    tip: str = "",
    words: Mapping[str, Mapping[str, str]] | None = None,
) -> str:
    """QML of a layer.

    Args:
        renderer: The element ``renderer-v2``.
        geometry: POINT or POLYGON.
        titles: Of columns, by their names.
        tip: HTML of the map tip.
        words: For the keys in a column, by its name.
    """
    aliases = "".join(f'<alias field="{name}" name="{escape(text)}"/>' for name, text in titles.items())
    widgets = "".join(_worded(name, found) for name, found in (words or {}).items())
    categories = "Symbology|Fields" + ("|Forms" if widgets else "") + ("|MapTips" if tip else "")
    return (
        f'{DOCTYPE}<qgis version="3.22" styleCategories="{categories}">{renderer}<blendMode>0</blendMode>'
        f"<featureBlendMode>0</featureBlendMode>"
        + (f"<fieldConfiguration>{widgets}</fieldConfiguration>" if widgets else "")
        + f"<aliases>{aliases}</aliases>"
        + (f'<mapTip enabled="1">{escape(tip)}</mapTip>' if tip else "")
        + f"<layerGeometryType>{geometry}</layerGeometryType></qgis>\n"
    )


def symbol(kind: str, name: int, layer: str, properties: Mapping[str, str], opacity: float = 1) -> str:
    """A symbol of one layer, in both ways in which QGIS 3 has written what it is like; each version reads one.

    Args:
        kind: Of the symbol, such as “fill”.
        name: Its number.
        layer: Kind of its layer, such as “SimpleFill”.
        properties: Of its layer.
        opacity: Of the symbol.
    """
    options = "".join(f'<Option type="QString" name="{key}" value="{value}"/>' for key, value in properties.items())
    older = "".join(f'<prop k="{key}" v="{value}"/>' for key, value in properties.items())
    return (
        f'<symbol type="{kind}" name="{name}" alpha="{opacity:g}" clip_to_extent="1">'
        f'<layer class="{layer}" enabled="1" locked="0" pass="0"><Option type="Map">{options}</Option>{older}</layer>'
        "</symbol>"
    )


def rgba(color: str) -> str:
    """``#rrggbb`` as QGIS writes it."""
    return ",".join(str(int(color[n : n + 2], 16)) for n in (1, 3, 5)) + ",255"


def _worded(column: str, words: Mapping[str, str]) -> str:
    entries = "".join(
        f'<Option type="Map"><Option type="QString" name="{escape(text)}" value="{escape(key)}"/></Option>'
        for key, text in words.items()
    )
    return (
        f'<field name="{column}"><editWidget type="ValueMap"><config><Option type="Map">'
        f'<Option type="List" name="map">{entries}</Option></Option></config></editWidget></field>'
    )
