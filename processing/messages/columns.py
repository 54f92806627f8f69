"""Words in the user's language for the keys in columns of layers."""

from __future__ import annotations

from collections.abc import Collection

from ...core.localization import Method, Status
from ..translation import tr
from .annotation_messages import kind_titles, severity_words
from .sentences import worded


def status_words() -> dict[str, str]:
    """Return the words for each key of ``status``, also of images that cannot be read."""
    return {**{status.key: worded(status.title) for status in Status}, "error": tr("cannot be read")}


def verdict_words() -> dict[str, str]:
    """Return the words for each key of ``verdict``, from the worst to the best."""
    return {
        "hardly_ever": tr("hardly ever"),
        "sometimes": tr("sometimes"),
        "often": tr("often"),
        "reliably": tr("reliably"),
        "very_reliably": tr("very reliably"),
    }


def column_words(names: Collection[str]) -> dict[str, dict[str, str]]:
    """Return the words by key of each column with keys; ``names``: columns of a layer."""
    methods = {method.key: worded(method.title) for method in Method}
    trials = {"map": tr("image of the map"), "mirrored": tr("mirrored image")}
    words = {
        "status": status_words(),
        "method": methods,
        "source": {"own": tr("own position"), "flight": tr("flight")},
        "verdict": verdict_words(),
        "severity": severity_words(),
        "kind": kind_titles() if "severity" in names else trials,
        "road": methods,
    }
    return {name: found for name, found in words.items() if name in names}
