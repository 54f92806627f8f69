"""A sentence for the user as a code with values; its English template stands in one table.

An error or a result carries a :class:`Sentence`, so that whoever shows it chooses the language. The templates are
found in dicts named ``SENTENCES``, one module a room (``core/sentences/<room>.py``, ``storage/sentences.py``,
``processing/wording/``), which add themselves to the table when their package is imported.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePath
from typing import Callable, NamedTuple, Union
from unicodedata import category


class Plural(NamedTuple):
    """A template whose words depend on the value ``count``; both forms are translated.

    Attributes:
        one: Said when ``count`` is 1.
        other: Said of every other ``count``.
    """

    one: str
    other: str


Template = Union[str, Plural]


@dataclass(frozen=True, init=False)
class Sentence:
    """One sentence for the user: what is said, and with which values.

    >>> str(Sentence("localization.vector_too_far", distance=2.25, threshold=2))
    'The nearest window has distance 2.250, more than 2.'

    Attributes:
        code: Key of the template, ``room.what_is_wrong``.
        values: (name, value) for each placeholder of the template, by name. A value is a text, a path, a number,
            another sentence (worded in the same language), or a tuple of those (joined with commas).
    """

    code: str
    values: tuple[tuple[str, object], ...]

    def __init__(self, code: str, /, **values: object) -> None:
        """Makes the sentence.

        Args:
            code: Key of the template.
            values: Those that the template names; a list is kept as a tuple.
        """
        frozen = {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}
        object.__setattr__(self, "code", code)
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

_templates: dict[str, Template] = {}


def add(sentences: Mapping[str, Template]) -> None:
    """Adds a room's templates to the table; called once, when the room's package is imported.

    Args:
        sentences: English templates by code, with ``{named}`` placeholders as of ``str.format``.
    """
    _templates.update(sentences)


def template_of(sentence: Sentence) -> str:
    """The English template of a sentence, in the form that its ``count`` asks for.

    A code that no table has stands for itself. It can't happen in shipped code: tests/core/test_sentences.py reads
    every code and its values from the source.
    """
    template = _templates.get(sentence.code)
    if template is None:
        return sentence.code.replace("{", "{{").replace("}", "}}")
    if isinstance(template, Plural):
        return template.one if dict(sentence.values)["count"] == 1 else template.other
    return template


def filled(sentence: Sentence, template: Callable[[Sentence], str]) -> str:
    """The sentence with its values, sentences among the values included.

    Args:
        sentence: What to say.
        template: Words without values for a sentence, in the language wanted.
    """
    return template(sentence).format(**{name: _shown(value, template) for name, value in sentence.values})


def english(said: object) -> str:
    """A sentence, or what may be a value of one, in English, as the command line and logs say it."""
    return str(_shown(said, template_of))


class _Worded(str):
    """A sentence or list within a sentence; ``{name:clause}`` begins it in lower case, as after a colon."""

    def __format__(self, spec: str) -> str:
        return self[:1].lower() + self[1:] if spec == "clause" else super().__format__(spec)


def _shown(value: object, template: Callable[[Sentence], str]) -> object:
    """A value as ``str.format`` takes it; numbers stay numbers for the template's format."""
    if isinstance(value, Sentence):
        return _Worded(filled(value, template))
    if isinstance(value, tuple):
        return _Worded(_listed(value, template))
    if isinstance(value, int) and abs(value) >= _LARGEST_WHOLE:
        # Python refuses to write numbers of some thousand digits.
        return "…"
    if isinstance(value, (list, dict, set)):
        # What a file holds where something else should be.
        with contextlib.suppress(ValueError, RecursionError):
            return _Worded(legible(str(value)))
        return "…"
    return _Worded(legible(str(value))) if isinstance(value, (str, PurePath, BaseException)) else value


def _listed(values: tuple, template: Callable[[Sentence], str]) -> str:
    """Values with commas between them, and a mark for those that there is no room for."""
    shown: list[str] = []
    room = LONGEST_LIST
    for value in values:
        shown.append(str(_shown(value, template)))
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
