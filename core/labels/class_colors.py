"""Colors of classes: water is blue, forest green, in whatever language or nomenclature they are named.

The words are those of land-cover nomenclatures (OpenStreetMap's tags, LCDB, CORINE, Urban Atlas) and of everyday names
in English, German, Spanish and French. Colors follow the custom of maps. Classes that are often neighbors have
lightnesses that color-blind people can distinguish.
"""

from __future__ import annotations

import colorsys
import functools
import hashlib
import re
from collections.abc import Iterable

# Colors for classes without a usual one: Paul Tol's "muted" scheme, which color-blind people can distinguish.
_PALETTE = (
    "#cc6677",
    "#332288",
    "#ddcc77",
    "#117733",
    "#88ccee",
    "#882255",
    "#44aa99",
    "#999933",
    "#aa4499",
    "#dddddd",
)

_LANDMARK = True

_KINDS: tuple[tuple[str, bool, str], ...] = (
    ("#bdbdbd", not _LANDMARK, "unlabeled unlabelled unknown unbekannt nodata clouds? other sonstige otros?"),
    ("#8a5a44", _LANDMARK, "quarry mine mines mineral extraction dump landfill steinbruch abbau cantera carrière"),
    ("#e8f3fa", not _LANDMARK, "snow ice glaciers? schnee eis gletscher nieve neige"),
    ("#8fc1c9", _LANDMARK, "wetlands? marsh marshes swamp bogs? peat mangrove saline salines sumpf moor humedal mud"),
    ("#3a87c8", _LANDMARK, "waters? wasser gewässer agua eau lakes? ponds? rivers? stream sea ocean reservoir basin"),
    ("#3a87c8", _LANDMARK, "see fluss fluß bach teich río lago laguna rivière lac étang canals? lagoons? dock pool"),
    ("#c8372d", _LANDMARK, "buildings? gebäude haus häuser houses? roofs? edificios? bâtiments? greenhouse garages?"),
    ("#c8372d", _LANDMARK, "structures"),
    ("#5d6268", not _LANDMARK, "railways? rail bahn gleis ferrocarril"),
    ("#7a7f86", not _LANDMARK, "roads? streets? strasse straße straßen transport highway transit carretera camino"),
    ("#7a7f86", not _LANDMARK, "asphalt pavement paved parking ports? airports? runway pier impervious routes? rue"),
    ("#a678b4", not _LANDMARK, "industrial commercial retail gewerbe industrie comercial military construction"),
    ("#7ec46a", _LANDMARK, "pitch sports? leisure recreation golf parks? parkland gardens? cemetery green friedhof"),
    ("#d89a8f", not _LANDMARK, "built builtup urban residential settlement siedlung stadt urbano urbain artificial"),
    ("#c58a3d", _LANDMARK, "orchards? vineyards? olive fruit berry plantations? nursery perennial obst wein vergers?"),
    ("#e4c65a", not _LANDMARK, "crops? cropland arable cultivated cultivation farmland farmyard agriculture farm rice"),
    ("#e4c65a", not _LANDMARK, "agricultural acker ackerland feld felder cultivos? cultures? fields?"),
    ("#b7d97a", not _LANDMARK, "grass grasses grasslands? meadows? pastures? herbaceous herbfield tussock lawn"),
    ("#b7d97a", not _LANDMARK, "wiese weide grünland gras prado pasto prairie pâture herbe greenfield village"),
    ("#5c9a3c", not _LANDMARK, "scrub shrubs? shrubland heath heathland moors? gorse broom fern fernland bush manuka"),
    ("#5c9a3c", not _LANDMARK, "gebüsch busch heide matorral garrigue lande flax flaxland matagouri sclerophyllous"),
    ("#1f7a3a", not _LANDMARK, "forests? forested woods? woodland trees? hardwoods? coniferous wald bosque forêt bois"),
    ("#4f9d57", not _LANDMARK, "vegetation vegetated grün"),
    ("#cfae84", _LANDMARK, "bare barren beach beaches sands? dunes? gravel shingle unpaved soil boden suelo sol"),
    ("#a89c8c", _LANDMARK, "rocks? scree cliff stone landslide fels kies schotter roca roche burnt burned"),
)
"""(color, whether its regions usually are landmarks, words); the first kind that matches a name counts."""


@functools.cache
def _pattern(words: str) -> re.Pattern:
    return re.compile(r"(?:" + "|".join(words.split()) + r")\b", re.IGNORECASE)


def known_color(name: str) -> str | None:
    """Return the usual color ``#rrggbb`` of a class; None for an unknown name."""
    kind = _kind(name)
    return kind and kind[0]


def default_color(value: int) -> str:
    """Return a color ``#rrggbb`` for a class without one, the same every time."""
    if 0 <= value <= len(_PALETTE):
        return _PALETTE[value - 1]
    return "#" + hashlib.sha256(str(value).encode("ascii")).hexdigest()[:6]


def chosen_colors(classes: Iterable[tuple[int, str]]) -> list[str]:
    """Return a color ``#rrggbb`` for each (value, name): the usual one of its name, or any; the same every time."""
    return shades([known_color(name) or default_color(value) for value, name in classes])


def is_usual_landmark(name: str) -> bool:
    """Return whether regions of such a class usually are compact and permanent, as buildings and ponds are."""
    kind = _kind(name)
    return kind is not None and kind[1]


def _kind(name: str) -> tuple[str, bool] | None:
    """Return the first kind that matches one of the name's words."""
    words = [word for word in re.split(r"[^\w]+|_", name) if word]
    for color, is_landmark, known in _KINDS:
        if any(_pattern(known).fullmatch(word) for word in words):
            return color, is_landmark
    return None


def shades(colors: Iterable[str]) -> list[str]:
    """Return the colors; a repeated one in another shade each time, alternately lighter and darker."""
    given: list[str] = []
    counts: dict[str, int] = {}
    for color in colors:
        again = counts.get(color, 0)
        counts[color] = again + 1
        given.append(_shade(color, again))
    return given


def _shade(color: str, number: int) -> str:
    """Return a shade of a color: 0 is the color itself, then lighter, darker, much lighter, much darker."""
    if not number:
        return color
    red, green, blue = (int(color[n : n + 2], 16) / 255 for n in (1, 3, 5))
    hue, lightness, saturation = colorsys.rgb_to_hls(red, green, blue)
    step = 0.09 * ((number + 1) // 2) * (1 if number % 2 else -1)
    mixed = colorsys.hls_to_rgb((hue + 0.012 * number) % 1, min(max(lightness + step, 0.12), 0.9), saturation)
    return "#" + "".join(f"{round(255 * part):02x}" for part in mixed)
