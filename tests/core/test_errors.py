import pickle
import re
from pathlib import Path

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


ROOT = Path(__file__).resolve().parents[2]
TABLE = (ROOT / "core" / "limits.py").read_text(encoding="utf-8")


def test_every_limit_has_a_reason_and_a_use():
    names = set(re.findall(r"^([A-Z]\w+) = ", TABLE, flags=re.MULTILINE))
    assert names == set(re.findall(r"^([A-Z]\w+) = .+  # [^#]+\.$", TABLE, flags=re.MULTILINE)) != set()
    rooms = ("core", "storage", "processing")
    files = [path for room in rooms for path in (ROOT / room).rglob("*.py") if path.name != "limits.py"]
    used = {name for path in files for name in re.findall(r"\blimits\.([A-Z]\w+)", path.read_text(encoding="utf-8"))}
    assert names == used
