"""Shared parts of the tests of bad input: algorithms with their outputs, and the check of a refusal."""

import re

from made_inputs import scattered_objects

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
"""Beginnings of QGIS's own messages, which come before the algorithm runs."""

LABELS = scattered_objects(150, 200, 40, seed=2)
WINDOWS = {"REFERENCE_CLASSES": "1;2;3", "WINDOW_SIZE": 100, "STRIDE": 50, "MINIMUM_AREA": 30}


def sentence_of(error: Exception) -> str:
    """Return the message for the user, checked to be one sentence; QGIS's own messages end without a full stop."""
    text = str(error).replace("Unable to execute algorithm\n", "")
    assert "Traceback" not in text and "\n" not in text.strip(), text
    assert text.endswith(".") or text.startswith(QGIS_OWN), text
    assert len(re.findall(r"[.!?]\s+[A-Z“]", text)) <= 2, f"more than three sentences: {text}"
    return text
