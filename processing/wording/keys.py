"""Sentences of core and storage as algorithms say them that have a parameter to mend it with."""

from __future__ import annotations

from typing import Dict, Tuple

SENTENCES_BY_KEY: Dict[str, Tuple[str, str]] = {}
"""(parameter key, English template) by code: said instead of the code's own template by an algorithm with that key."""
