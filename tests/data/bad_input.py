"""What the tests of bad input share: algorithms with their outputs, and what a refusal must be."""

from __future__ import annotations

import re

from made_inputs import (
    scattered_objects,
)

RASTERIZE, DECODE, BUILD = "semref:rasterizeannotation", "semref:decodecolorlabels", "semref:builddatabase"
DESCRIBE, LOCALIZE = "semref:describeimage", "semref:localizeimages"
SEGMENT, COMPARE = "semref:segmentimage", "semref:comparelabels"

OUTPUT_NAMES = {
    RASTERIZE: ("OUTPUT", "labels_out.tif"),
    DECODE: ("OUTPUT", "decoded_out.tif"),
    BUILD: ("DATABASE", "area_out.gpkg"),
    DESCRIBE: ("VECTOR", "vector_out.json"),
    LOCALIZE: ("OUTPUT", "positions_out.gpkg"),
    SEGMENT: ("OUTPUT", "segmented_out.tif"),
    COMPARE: ("DISAGREEMENTS", "disagreements_out.gpkg"),
}
QGIS_OWN = ("Incorrect parameter value for ", "Could not load source layer for ", "Could not create layer ")
"""How sentences begin that QGIS says before an algorithm is asked."""

NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
LABELS = scattered_objects(150, 200, 40, seed=2)


def sentence_of(error: Exception) -> str:
    """Return what the user reads, checked to be one to three sentences; QGIS's own end without a full stop."""
    text = str(error).replace("Unable to execute algorithm\n", "")
    assert "Traceback" not in text and "\n" not in text.strip(), text
    assert text.endswith(".") or text.startswith(QGIS_OWN), text
    assert len(re.findall(r"[.!?]\s+[A-Z“]", text)) <= 2, f"more than three sentences: {text}"
    return text
