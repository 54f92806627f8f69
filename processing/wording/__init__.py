"""What codes of the core mean, in the user's language."""

from ...core.sentences import add
from . import exchange

for _room in (exchange,):
    add(_room.SENTENCES)
