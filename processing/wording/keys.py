"""Sentences of core and storage as algorithms say them that have a parameter to mend it with."""

from __future__ import annotations

from typing import Dict, Tuple

SENTENCES_BY_KEY: Dict[str, Tuple[str, str]] = {
    "labels.no_reference_class": (
        "REFERENCE_CLASSES",
        "No class is a reference class; name at least one of {classes} in REFERENCE_CLASSES, or give it the role "
        "“reference” in the class table.",
    ),
    "labels.nothing_in_common": (
        "REFERENCE",
        "The maps have no pixel in common that REFERENCE labels; choose maps of the same ground.",
    ),
}
"""(parameter key, English template) by code: said instead of the code's own template by an algorithm with that key."""
