"""What codes of the core mean, in the user's language."""

from ...core.sentences import add
from . import exchange, framework

for _room in (exchange, framework):
    add(_room.SENTENCES)
