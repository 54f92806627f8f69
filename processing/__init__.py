"""SemRef's Processing provider and its algorithms, one a file."""

from . import wording

__all__ = ["wording"]
"""Imported for its sentences: an error tells its English text wherever it is caught."""
