from __future__ import annotations

import ast
import pickle
import re
import string
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from source_trees import nodes_of

from semref.core import errors
from semref.core.errors import DatabaseError, SemRefError
from semref.core.sentences import Sentence, english, filled

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "release"))

from update_translations import MAKERS, name_of, templates_of  # noqa: E402

ROOMS = ("core", "storage", "cluster", "training", "processing", "ui")
FILES = [path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py")) if "__pycache__" not in path.parts]

OF_OTHERS = {"ArgumentTypeError", "AttributeError", "BadZipFile", "NotImplementedError", "OperationalError"}
OF_OTHERS |= {"RuntimeError", "ValueError", "error"}
"""Errors of Python and its libraries (``struct.error``, ``sqlite3.OperationalError``)."""

SHOWS = {"pushInfo", "pushWarning", "pushMessage", "reportError", "setProgressText", "setText", "setToolTip"}
SHOWS |= {"setWindowTitle", "setPlaceholderText", "setHelp", "addAction", "information", "warning", "critical"}
SHOWS |= {"question", "about", "info", "success", "error"}
"""Calls that show their texts: feedback, message bar and boxes, widgets."""

NO_PIXELS = Sentence("The image has no pixels.")
TOO_FAR = "The nearest window has distance {distance:.3f}, more than {threshold:g}."
DAMAGED = "{path} is damaged or cut short; copy it again."


def test_a_sentence_is_its_template_with_numbers_in_its_format():
    assert english(NO_PIXELS) == "The image has no pixels."
    said = Sentence(TOO_FAR, distance=0.123456, threshold=0.25)
    assert str(said) == "The nearest window has distance 0.123, more than 0.25."


def test_sentences_among_the_values_are_translated_alike():
    sentence = Sentence("{shown}; {needed}.", shown="This", needed=Sentence("{count} needed", count=2))
    assert english(sentence) == "This; 2 needed."
    assert filled(sentence, lambda template: f"<{template}>") == "<This; <2 needed>.>"


def test_lists_are_joined_with_commas():
    assert english(Sentence("{names}: {none}", names=["a", NO_PIXELS], none=())) == "a, The image has no pixels.: "


def test_equal_sentences_are_one_in_a_set_whatever_the_order_of_their_values():
    one = Sentence("{a} {b}", a=1, b=["x", "y"])
    assert {one, Sentence("{a} {b}", b=("x", "y"), a=1)} == {one}
    assert one != Sentence("{a} {b}", a=2, b=["x", "y"])


def test_after_a_colon_a_sentence_begins_in_lower_case():
    said = Sentence("No fix: {why:clause} {why}", why=NO_PIXELS)
    assert english(said) == "No fix: the image has no pixels. The image has no pixels."


def test_a_missing_value_is_an_error_rather_than_a_gap():
    with pytest.raises(KeyError, match="threshold"):
        english(Sentence(TOO_FAR, distance=0.1))


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("a\n\r\x85b\0c\x1b[2J", "a\\n\\r\\x85b\\x00c\\x1b[2J"),
        ("left\u202eto right\u2028", "left\\u202eto right\\u2028"),
        ("lone \udcff", "lone \\udcff"),
        ("thin\u2009space, é, 日本", "thin\u2009space, é, 日本"),
        (10**5000, "…"),
        (-(10**5000), "…"),
        (12, "12"),
    ],
    ids=range(7),
)
def test_any_value_is_shown_in_one_line(value, said):
    text = english(("x", value))
    assert text == f"x, {said}"
    text.encode("utf-8")


def test_a_long_value_is_cut_in_its_middle_and_a_path_of_usual_length_is_not():
    path = "/folder/" + "x" * 100_000 + "/name.png"
    text = english(Sentence(DAMAGED, path=path))
    assert text.startswith("/folder/xxx") and "x/name.png is damaged" in text and len(text) < 600
    path = "/folder" * 60 + "/name.png"
    assert english(Sentence(DAMAGED, path=path)).startswith(f"{path} is damaged")


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ([0] * 9000, "0, 0, 0"),
        ({"a": ["x\n"] * 9000}, "{'a': ['x\\n', "),
        ({"a": 10**5000}, "…"),
        (("name\n",) * 9000, "name\\n, name\\n, "),
    ],
    ids=["list", "dict", "number of 5,000 digits in a dict", "values with commas"],
)
def test_long_lists_are_cut_too(value, said):
    text = english(Sentence("a model of type {kind}", kind=value))
    assert f"a model of type {said}" in text
    assert "…" in text and len(text) < 1700 and text.isprintable()


def test_names_of_all_classes_of_a_table_are_not_cut():
    names = tuple(f"class {n}" for n in range(1, 129))
    assert ", ".join(names) in english(Sentence("{kind}", kind=names))


def literals(nodes: list[ast.expr]) -> Iterator[str]:
    """Return the literal texts of the expressions, without ``tr("…")`` and without arguments of other calls."""
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value
        elif isinstance(node, (ast.JoinedStr, ast.BinOp, ast.IfExp)):
            yield from literals([part for part in ast.iter_child_nodes(node) if isinstance(part, ast.expr)])
        elif isinstance(node, ast.Call) and name_of(node.func) == "format":
            yield from literals([node.func.value])


def placeholders(template: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}


def calls_in(path: Path) -> list[ast.Call]:
    return [node for node in nodes_of(path) if isinstance(node, ast.Call)]


def test_every_sentence_has_the_values_of_its_template():
    wrong = []
    for path in FILES:
        for call in (call for call in calls_in(path) if name_of(call.func) in MAKERS):
            names = {keyword.arg for keyword in call.keywords}
            named = [placeholders(template) for template in templates_of(call)]
            if None not in names and any(one != names for one in named):
                wrong.append((path.name, call.lineno))
    assert wrong == []


def test_a_template_is_a_literal_that_can_be_found():
    """``Sentence(f"…")`` and ``SomeError("…".format(…))`` would have no translation."""
    found = []
    for path in FILES:
        for call in (call for call in calls_in(path) if call.args and name_of(call.func) in MAKERS):
            said = call.args[0]
            is_formatted = isinstance(said, ast.Call) and name_of(said.func) == "format"
            if is_formatted or isinstance(said, (ast.JoinedStr, ast.BinOp)):
                found.append((path.name, call.lineno))
    assert found == []


def test_no_other_error_is_raised_with_a_text():
    """Other errors have English texts only; they are bugs, or reasons in brackets such as GDAL's."""
    found = []
    for path in FILES:
        raised = [node.exc for node in nodes_of(path) if isinstance(node, ast.Raise)]
        others = [one for one in raised if isinstance(one, ast.Call) and name_of(one.func) not in MAKERS | OF_OTHERS]
        found += [(path.name, call.lineno, text) for call in others for text in literals(call.args)]
    assert found == []


def test_whatever_is_shown_goes_through_tr():
    found = []
    for path in FILES:
        shown = [
            call
            for call in calls_in(path)
            if isinstance(call.func, ast.Attribute) and call.func.attr in SHOWS and name_of(call.func.value) != "struct"
        ]
        found += [(path.name, call.lineno, text) for call in shown for text in literals(call.args)]
    assert [one for one in found if re.search(r"[^\W\d_]", one[2])] == []


def test_a_step_is_named_by_a_text_that_can_be_translated():
    """``yield f"…", share`` would be shown untranslated; ``update_translations.py`` finds ``yield "…", share``."""
    found = []
    for path in FILES:
        pairs = [node.value for node in nodes_of(path) if isinstance(node, ast.Yield)]
        steps = [pair.elts[0] for pair in pairs if isinstance(pair, ast.Tuple) and len(pair.elts) == 2]
        found += [(path.name, step.lineno) for step in steps if isinstance(step, ast.JoinedStr)]
    assert found == []


def test_texts_that_are_shown_without_tr_would_be_found():
    calls = ast.parse('f("a", f"b {c}", tr("d").format(e=f), "g" + h, "i" if j else k, l)').body[0].value.args
    assert list(literals(calls)) == ["a", "b ", "g", "i"]


def test_a_raise_leads_to_its_template():
    call = ast.parse('Sentence("one" if count == 1 else "{count} more", count=count)').body[0].value
    assert templates_of(call) == ["one", "{count} more"]


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


TABLE = (ROOT / "core" / "limits.py").read_text(encoding="utf-8")


def test_every_limit_has_a_reason_and_a_use():
    names = set(re.findall(r"^([A-Z]\w+) = ", TABLE, flags=re.MULTILINE))
    assert names == set(re.findall(r"^([A-Z]\w+) = .+  # [^#]+\.$", TABLE, flags=re.MULTILINE)) != set()
    rooms = ("core", "storage", "processing")
    files = [path for room in rooms for path in (ROOT / room).rglob("*.py") if path.name != "limits.py"]
    used = {name for path in files for name in re.findall(r"\blimits\.([A-Z]\w+)", path.read_text(encoding="utf-8"))}
    assert names == used
