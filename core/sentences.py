"""A sentence for the user: an English template with its values.

Write the template where the sentence is made: ``raise LabelMapError("{path} has {bands} bands; …", path=path,
bands=bands)`` or ``Sentence("…", …)``. It is the key of its translations; the code that shows the sentence chooses the
language. ``tools/release/update_translations.py`` finds the templates in the source.
"""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from pathlib import PurePath
from typing import Callable
from unicodedata import category


@dataclass(frozen=True, init=False)
class Sentence:
    """One sentence for the user: a template and its values.

    >>> str(Sentence("The best match is {score:.2f}.", score=0.5))
    'The best match is 0.50.'

    Attributes:
        template: English words with ``{named}`` placeholders as for ``str.format``.
        values: (name, value) of each placeholder, sorted by name. A value is a text, a path, a number, another sentence
            (shown in the same language), or a tuple of those (joined with commas).
    """

    template: str
    values: tuple[tuple[str, object], ...]

    def __init__(self, template: str, /, **values: object) -> None:
        """Make the sentence.

        Args:
            template: A literal, or one for each form: ``"{count} place" if count == 1 else "{count} places"``.
            values: Values of the placeholders; a list becomes a tuple.
        """
        frozen = {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}
        object.__setattr__(self, "template", template)
        object.__setattr__(self, "values", tuple(sorted(frozen.items())))

    def __str__(self) -> str:
        """Return the sentence in English."""
        return english(self)


LONGEST_VALUE = 500
"""Characters of a value in a sentence; hardly any path is longer, and of a longer value the ends are enough."""

LONGEST_LIST = 1500
"""Characters after which a list of values is cut: enough for some hundred class names."""

_KEPT_BEFORE, _KEPT_BEHIND = 300, 150
_LARGEST_WHOLE = 10**64


def filled(sentence: Sentence, translated: Callable[[str], str]) -> str:
    """Return the sentence with its values, including sentences among the values.

    Args:
        translated: Returns the translation of an English template.
    """
    shown = {name: _shown(value, translated) for name, value in sentence.values}
    return translated(sentence.template).format(**shown)


def english(value: object) -> str:
    """Return a sentence, or a value of one, in English, for the command line and logs."""
    return str(_shown(value, str))


class _Worded(str):
    """A sentence or list within a sentence; ``{name:clause}`` starts it in lower case, as after a colon."""

    def __format__(self, spec: str) -> str:
        return self[:1].lower() + self[1:] if spec == "clause" else super().__format__(spec)


def _shown(value: object, translated: Callable[[str], str]) -> object:
    """Return a value for ``str.format``; numbers stay numbers for the template's format."""
    if isinstance(value, Sentence):
        return _Worded(filled(value, translated))
    if isinstance(value, tuple):
        return _Worded(_listed(value, translated))
    if isinstance(value, int) and abs(value) >= _LARGEST_WHOLE:
        # Python refuses to write numbers of some thousand digits.
        return "…"
    if isinstance(value, (list, dict, set)):
        # A file has this where another type was expected.
        with contextlib.suppress(ValueError, RecursionError):
            return _Worded(legible(str(value)))
        return "…"
    return _Worded(legible(str(value))) if isinstance(value, (str, PurePath, BaseException)) else value


def _listed(values: tuple, translated: Callable[[str], str]) -> str:
    """Return values joined with commas, with “…” for those beyond ``LONGEST_LIST``."""
    shown: list[str] = []
    room = LONGEST_LIST
    for value in values:
        shown.append(str(_shown(value, translated)))
        room -= len(shown[-1]) + len(", ")
        if room < 0:
            return ", ".join([*shown[:-1], "…"])
    return ", ".join(shown)


def legible(text: str) -> str:
    """Return a text for use in a sentence: in one line, and cut in the middle if it is long."""
    if len(text) > LONGEST_VALUE:
        text = f"{text[:_KEPT_BEFORE]}…{text[-_KEPT_BEHIND:]}"
    return printable(text)


def printable(text: str) -> str:
    """Return a text in one line, which a terminal shows as it is."""
    return text if text.isprintable() else "".join(_printable(sign) for sign in text)


def _printable(sign: str) -> str:
    """Escape control characters, line ends, marks of writing direction, and bytes that are not text."""
    return sign if sign.isprintable() or category(sign) == "Zs" else sign.encode("unicode_escape").decode("ascii")
