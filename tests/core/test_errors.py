"""Errors have one sentence, also when repeated, sent between processes and caught by their base class."""

from __future__ import annotations

import pickle

import pytest

from semref.core import errors
from semref.core.errors import DatabaseError, SemRefError
from semref.core.sentences import Sentence

KINDS = [kind for kind in vars(errors).values() if isinstance(kind, type) and issubclass(kind, SemRefError)]


@pytest.mark.parametrize("kind", KINDS)
def test_every_error_is_a_user_error_with_its_sentence(kind):
    with pytest.raises(SemRefError) as caught:
        raise kind("The image has no pixels.")
    assert str(caught.value) == "The image has no pixels."
    assert caught.value.sentence == Sentence("The image has no pixels.")


def test_an_error_keeps_its_sentence_between_processes():
    error = DatabaseError("{count} other positions fit almost as well as the best one.", count=3)
    assert pickle.loads(pickle.dumps(error)).sentence == error.sentence
