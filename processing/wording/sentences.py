"""What an error or a result says, in the user's language."""

from __future__ import annotations

from collections.abc import Collection

from ...core.errors import SemRefError
from ...core.sentences import Sentence, filled, template_of
from ..translation import tr
from .keys import EVERYWHERE, SENTENCES_BY_KEY
from .numbers import LocalTemplate


def worded(said: SemRefError | Sentence, keys: Collection[str] = ()) -> str:
    """One sentence in the user's language.

    Args:
        said: An error, or the sentence of a result.
        keys: The parameter keys of the algorithm that says it. What can be mended with one of them is said so: core
            knows no keys, and another algorithm may have none for it.

    Returns:
        The sentence with its values, numbers as the user's locale writes them.
    """
    sentence = said.sentence if isinstance(said, SemRefError) else said
    values = dict(sentence.values)
    if str(values.get("setting", "")).upper() in keys:
        # The name of one of core's settings, of which this algorithm makes a parameter.
        sentence = Sentence(sentence.code, **{**values, "setting": values["setting"].upper()})

    def template(part: Sentence) -> str:
        return LocalTemplate(tr(_template_for(part, keys)))

    return filled(sentence, template)


def _template_for(sentence: Sentence, keys: Collection[str]) -> str:
    key, template = SENTENCES_BY_KEY.get(sentence.code, ("", ""))
    return template if template and (key == EVERYWHERE or key in keys) else template_of(sentence)
