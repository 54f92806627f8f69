"""Errors: a sentence each, which outlives being said again, sent elsewhere and caught by its base."""

from __future__ import annotations

import pickle

import pytest

from semref.core import errors
from semref.core.errors import DatabaseError, ImageError, SemRefError
from semref.core.sentences import Sentence

KINDS = [kind for kind in vars(errors).values() if isinstance(kind, type) and issubclass(kind, SemRefError)]


@pytest.mark.parametrize("kind", KINDS)
def test_every_error_is_caught_as_one_the_user_can_mend_and_says_its_sentence(kind):
    with pytest.raises(SemRefError) as caught:
        raise kind("labels.no_pixels")
    assert str(caught.value) == "The image has no pixels."
    assert caught.value.sentence == Sentence("labels.no_pixels")


def test_a_text_that_is_no_code_stands_for_itself_braces_included():
    assert str(SemRefError("No {code}.")) == "No {code}."


def test_an_error_can_say_what_another_said():
    said = DatabaseError("localization.rivals", count=1)
    assert str(ImageError(said.sentence)) == str(said)


def test_an_error_keeps_its_sentence_between_processes():
    error = DatabaseError("localization.rivals", count=3)
    assert pickle.loads(pickle.dumps(error)).sentence == error.sentence
