"""Sentences of core and storage as algorithms say them that have a parameter to mend it with."""

from __future__ import annotations

from typing import Dict, Tuple

EVERYWHERE = ""
"""Instead of a key: said by every algorithm and window, since what helps is in reach of all."""

SENTENCES_BY_KEY: Dict[str, Tuple[str, str]] = {
    "labels.no_reference_class": (
        "REFERENCE_CLASSES",
        "No class is a reference class; name at least one of {classes} in REFERENCE_CLASSES, or give it the role "
        "“reference” in the class table.",
    ),
    "storage.sizes_without_georeference": (
        "REFERENCE",
        "REFERENCE has {width} × {height} pixels and PREDICTED {other_width} × {other_height}, and not both have a "
        "georeference; compare images of one size or two georeferenced maps.",
    ),
    "storage.no_overlap": (
        "REFERENCE",
        "REFERENCE and PREDICTED don't overlap; choose maps of the same ground.",
    ),
    "storage.no_geopackage": (
        EVERYWHERE,
        "{path} is not a GeoPackage; choose a database made by “Build reference database”.",
    ),
    "storage.foreign_database": (
        EVERYWHERE,
        "{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference "
        "database”.",
    ),
    "storage.bands_for_labels": (
        EVERYWHERE,
        "{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.",
    ),
    "labels.nothing_in_common": (
        "REFERENCE",
        "The maps have no pixel in common that REFERENCE labels; choose maps of the same ground.",
    ),
}
"""(parameter key, English template) by code: said instead of the code's own template by an algorithm with that key."""
