"""Reasons that name the network, because it is the most likely cause of a missing position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..localization import Localization, shown_landmarks
from ..sentences import Sentence


def name_network(found: Localization, trained_on: Sequence[str] | None, classes: Sequence[str]) -> Localization:
    """Return the result with a reason that states what the network found and, at its end, was trained on.

    Args:
        trained_on: Places; None for label images, empty if the network does not state them.
        classes: Names of the database's landmark classes.
    """
    if found.is_fix or found.reason is None or trained_on is None:
        return found
    reason = _counted_by_network(found.reason, tuple(classes))
    if trained_on:
        ground = Sentence("The network was trained on: {places}.", places=tuple(trained_on))
        reason = Sentence("{first} {second}", first=reason, second=ground)
    return replace(found, reason=reason)


def _counted_by_network(sentence: Sentence, classes: tuple[str, ...]) -> Sentence:
    """Replace "the image shows" by "the network found" in a sentence and the sentences in it."""
    values = {
        name: _counted_by_network(value, classes) if isinstance(value, Sentence) else value
        for name, value in sentence.values
    }
    count = values.get("count")
    if isinstance(count, int) and sentence in (shown_landmarks(count), shown_landmarks(count, whole=True)):
        return Sentence(
            "The network found {count} landmark ({classes})"
            if count == 1
            else "The network found {count} landmarks ({classes})",
            count=count,
            classes=classes,
        )
    return Sentence(sentence.template, **values)
