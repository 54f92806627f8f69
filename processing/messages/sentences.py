"""Errors and results as sentences in the user's language."""

from __future__ import annotations

from ...core.errors import SemRefError
from ...core.sentences import Sentence, filled
from ..translation import tr
from .numbers import LocalTemplate


def worded(said: SemRefError | Sentence) -> str:
    """Return a sentence in the user's language, with its numbers in the user's locale.

    Args:
        said: An error, or the sentence of a result.
    """
    sentence = said.sentence if isinstance(said, SemRefError) else said
    return filled(sentence, lambda template: LocalTemplate(tr(template)))


def error_probability(confidence: float) -> str:
    """Return the error probability in the user's language: "1 in 1,200", or "below 1 in 10,000"."""
    from ...core.localizer import record

    return worded(record.error_probability(confidence))
