"""A sentence for the user: an English template with its values.

The template is written where the sentence is made, ``raise LabelMapError("{path} has {bands} bands; …", path=path,
bands=bands)`` or ``Sentence("…", …)``, and is the key of its translations: whoever shows the sentence chooses the
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
    """One sentence for the user: what is said, and with which values.

    >>> str(Sentence("The best match is {score:.2f}.", score=0.5))
    'The best match is 0.50.'

    Attributes:
        template: English words with ``{named}`` placeholders as of ``str.format``.
        values: (name, value) for each placeholder of the template, by name. A value is a text, a path, a number,
            another sentence (worded in the same language), or a tuple of those (joined with commas).
    """

    template: str
    values: tuple[tuple[str, object], ...]

    def __init__(self, template: str, /, **values: object) -> None:
        """Makes the sentence.

        Args:
            template: A literal, or one for each form: ``"{count} place" if count == 1 else "{count} places"``.
            values: Those that the template names; a list is kept as a tuple.
        """
        frozen = {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}
        object.__setattr__(self, "template", template)
        object.__setattr__(self, "values", tuple(sorted(frozen.items())))

    def __str__(self) -> str:
        """The sentence in English."""
        return english(self)


LONGEST_VALUE = 500
"""Characters of a value in a sentence; paths have hardly more, and of what is longer the ends are enough."""

LONGEST_LIST = 1500
"""Characters after which a list of values is cut: some hundred names of classes are listed whole."""

_KEPT_BEFORE, _KEPT_BEHIND = 300, 150
_LARGEST_WHOLE = 10**64


def filled(sentence: Sentence, translated: Callable[[str], str]) -> str:
    """The sentence with its values, sentences among the values included.

    Args:
        translated: A template in the language wanted, from the English one.
    """
    shown = {name: _shown(value, translated) for name, value in sentence.values}
    return translated(sentence.template).format(**shown)


def english(said: object) -> str:
    """A sentence, or what may be a value of one, in English, as the command line and logs say it."""
    return str(_shown(said, str))


class _Worded(str):
    """A sentence or list within a sentence; ``{name:clause}`` begins it in lower case, as after a colon."""

    def __format__(self, spec: str) -> str:
        return self[:1].lower() + self[1:] if spec == "clause" else super().__format__(spec)


def _shown(value: object, translated: Callable[[str], str]) -> object:
    """A value as ``str.format`` takes it; numbers stay numbers for the template's format."""
    if isinstance(value, Sentence):
        return _Worded(filled(value, translated))
    if isinstance(value, tuple):
        return _Worded(_listed(value, translated))
    if isinstance(value, int) and abs(value) >= _LARGEST_WHOLE:
        # Python refuses to write numbers of some thousand digits.
        return "…"
    if isinstance(value, (list, dict, set)):
        # What a file holds where something else should be.
        with contextlib.suppress(ValueError, RecursionError):
            return _Worded(legible(str(value)))
        return "…"
    return _Worded(legible(str(value))) if isinstance(value, (str, PurePath, BaseException)) else value


def _listed(values: tuple, translated: Callable[[str], str]) -> str:
    """Values with commas between them, and a mark for those that there is no room for."""
    shown: list[str] = []
    room = LONGEST_LIST
    for value in values:
        shown.append(str(_shown(value, translated)))
        room -= len(shown[-1]) + len(", ")
        if room < 0:
            return ", ".join([*shown[:-1], "…"])
    return ", ".join(shown)


def legible(text: str) -> str:
    """A text as it may stand in a sentence, wherever it comes from: in one line, and cut in its middle where long."""
    if len(text) > LONGEST_VALUE:
        text = f"{text[:_KEPT_BEFORE]}…{text[-_KEPT_BEHIND:]}"
    return text if text.isprintable() else "".join(_printable(sign) for sign in text)


def _printable(sign: str) -> str:
    """Controls, line ends, what turns the direction of writing and bytes that are no text as Python's escapes."""
    return sign if sign.isprintable() or category(sign) == "Zs" else sign.encode("unicode_escape").decode("ascii")
