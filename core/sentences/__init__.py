"""What SemRef says to the user: codes with values, worded in English here and in other languages by processing."""

from . import assessment, database, flight, geometry, labels, localization, onboard, segmentation
from .sentence import Plural, Sentence, add, english, filled, legible, template_of

__all__ = ["Plural", "Sentence", "add", "english", "filled", "legible", "template_of"]

for _room in (assessment, database, flight, geometry, labels, localization, onboard, segmentation):
    add(_room.SENTENCES)
