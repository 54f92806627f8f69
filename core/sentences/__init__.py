"""What SemRef says to the user: codes with values, worded in English here and in other languages by processing."""

from . import geometry, labels, localization
from .sentence import Plural, Sentence, add, english, filled, template_of

__all__ = ["Plural", "Sentence", "add", "english", "filled", "template_of"]

for _room in (geometry, labels, localization):
    add(_room.SENTENCES)
