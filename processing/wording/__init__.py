"""What codes mean in the user's language; the sentences of processing and ui."""

from ...core.sentences import add
from . import algorithms, exchange, framework, packages

for _room in (algorithms, exchange, framework, packages):
    add(_room.SENTENCES)
