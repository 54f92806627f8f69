"""What is said to the user: the codes in the source, and the tables of templates that hold them."""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterator
from pathlib import Path

from source_trees import for_each, nodes_of

import semref.cluster
import semref.processing
import semref.storage
import semref.training  # noqa: F401  All four add their rooms' sentences.
from semref.core import errors
from semref.core.sentences import Plural
from semref.core.sentences.sentence import _templates
from semref.processing.wording.keys import SENTENCES_BY_KEY

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("core", "storage", "cluster", "training", "processing", "ui")
FILES = [path for room in ROOMS for path in sorted((ROOT / room).rglob("*.py")) if "__pycache__" not in path.parts]
CODE = re.compile(r"[a-z_]+\.[a-z0-9_]+")
SAY = {"Sentence"} | {name for name, kind in vars(errors).items() if isinstance(kind, type)}
"""Names of what is made with a code and its values."""


OF_OTHERS = {
    "AttributeError",
    "ValueError",
    "BadZipFile",
    "RuntimeError",
    "NotImplementedError",
    "error",
    "OperationalError",
}
"""Errors of Python and its libraries (``struct.error``, ``sqlite3.OperationalError``)."""

SHOWS = {"pushInfo", "pushWarning", "pushMessage", "reportError", "setProgressText", "setText", "setToolTip"}
SHOWS |= {"setWindowTitle", "setPlaceholderText", "setHelp", "addAction", "information", "warning", "critical"}
SHOWS |= {"question", "about", "info", "success", "error"}
"""What shows its texts: of feedback, the message bar and boxes, widgets."""


def name_of(function: ast.expr) -> str:
    return getattr(function, "id", getattr(function, "attr", ""))


def is_pair(node: ast.expr | None) -> bool:
    return isinstance(node, ast.Tuple) and len(node.elts) == 2


def literals(nodes: list[ast.expr]) -> Iterator[str]:
    """The texts that stand in the expressions as they are, not in ``tr("…")`` nor as a value of something else."""
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value
        elif isinstance(node, (ast.JoinedStr, ast.BinOp, ast.IfExp)):
            yield from literals([part for part in ast.iter_child_nodes(node) if isinstance(part, ast.expr)])
        elif isinstance(node, ast.Call) and name_of(node.func) == "format":
            yield from literals([node.func.value])


def forms(template) -> tuple[str, ...]:
    return tuple(template) if isinstance(template, Plural) else (template,)


def placeholders(template) -> set[str]:
    """Names of the values that a template takes; those of a plural include ``count``."""
    named = {name for form in forms(template) for _, name, _, _ in string.Formatter().parse(form) if name is not None}
    return named | ({"count"} if isinstance(template, Plural) else set())


def said_in(path: Path) -> list[tuple[int, str, set[str]]]:
    """(line, code, names of its values) wherever the file says a sentence by its code."""
    found = []
    for node in nodes_of(path):
        if not isinstance(node, ast.Call) or not node.args or not isinstance(node.args[0], ast.Constant):
            continue
        code, called = node.args[0].value, getattr(node.func, "id", getattr(node.func, "attr", ""))
        if isinstance(code, str) and CODE.fullmatch(code) and (called in SAY or code in _templates):
            found.append((node.lineno, code, {str(keyword.arg) for keyword in node.keywords}))
    return found


@for_each(FILES)
def test_every_code_is_in_the_table_and_has_the_values_of_its_template(path):
    said = said_in(path)
    assert [(line, code) for line, code, _ in said if code not in _templates] == []
    assert [(line, code, names) for line, code, names in said if names != placeholders(_templates[code])] == []


@for_each(sorted(_templates))
def test_a_template_is_one_room_s_and_names_its_values(code):
    assert CODE.fullmatch(code)
    assert all(name.isidentifier() for name in placeholders(_templates[code]))


@for_each(FILES)
def test_no_error_is_raised_with_a_text(path):
    """An error in English alone; what is no error of ours is a bug's or stands in brackets of one, as GDAL's reason."""
    calls = [node.exc for node in nodes_of(path) if isinstance(node, ast.Raise)]
    ours = [call for call in calls if isinstance(call, ast.Call) and name_of(call.func) not in OF_OTHERS]
    assert [(call.lineno, text) for call in ours for text in literals(call.args) if not CODE.fullmatch(text)] == []


@for_each(FILES)
def test_whatever_is_shown_goes_through_tr(path):
    calls = [node for node in nodes_of(path) if isinstance(node, ast.Call)]
    shown = [
        call
        for call in calls
        if isinstance(call.func, ast.Attribute) and call.func.attr in SHOWS and name_of(call.func.value) != "struct"
    ]
    found = [(call.lineno, text) for call in shown for text in literals(call.args)]
    assert [(line, text) for line, text in found if any(letter.isalpha() for letter in text)] == []


@for_each(FILES)
def test_a_step_is_named_by_a_text_that_can_be_translated(path):
    """``yield f"…", share`` would be shown as it is; ``yield "…", share`` is found by update_translations.py."""
    steps = [node.value.elts[0] for node in nodes_of(path) if isinstance(node, ast.Yield) and is_pair(node.value)]
    assert [step.lineno for step in steps if isinstance(step, ast.JoinedStr)] == []


@for_each(sorted(SENTENCES_BY_KEY))
def test_what_an_algorithm_says_instead_has_the_same_values(code):
    assert placeholders(SENTENCES_BY_KEY[code][1]) <= placeholders(_templates[code])


def test_texts_that_are_shown_without_tr_would_be_found():
    calls = ast.parse('f("a", f"b {c}", tr("d").format(e=f), "g" + h, "i" if j else k, l)').body[0].value.args
    assert list(literals(calls)) == ["a", "b ", "g", "i"]
