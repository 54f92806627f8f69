"""Qt names of shipped code are in Qt 6, and custom widgets of ui/ are painted with it."""

import ast
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FILES = [ROOT / "plugin.py", *(path for room in ("processing", "ui") for path in sorted((ROOT / room).rglob("*.py")))]
PREFIX = "qgis.PyQt."
needs_pyqt6 = pytest.mark.skipif(
    not any((Path(entry or ".") / "PyQt6" / "QtCore.pyi").exists() for entry in sys.path),
    reason="PyQt6 is not installed (tools/test_newest.sh installs it)",
)
LOOK_UP = """
import importlib, json, sys
missing = []
for module, names in json.load(sys.stdin):
    places = [importlib.import_module("PyQt6." + module)]
    if names[0] in ("QAction", "QActionGroup", "QShortcut"):
        # Qt 6 moved them; qgis.PyQt.QtWidgets has them still.
        places.append(importlib.import_module("PyQt6.QtGui"))
    found = next((place for place in places if hasattr(place, names[0])), places[0])
    for name in names:
        # An object's variables can't be had from its class.
        if not hasattr(found, name) and not any(name in vars(kind) for kind in getattr(found, "__mro__", ())):
            missing.append([module, *names])
            break
        found = getattr(found, name, None)
print(json.dumps(missing))
"""


def chain(node) -> list[str]:
    """Return the names of `a.b.c`, or nothing for other expressions."""
    names = []
    while isinstance(node, ast.Attribute):
        names.insert(0, node.attr)
        node = node.value
    return [node.id, *names] if isinstance(node, ast.Name) else []


def qt_names(source: str) -> set[tuple[str, tuple[str, ...]]]:
    """(module of Qt, names from a class to a member): imports, `QClass.a.b`, and members of what a function makes with
    `x = QClass(…)` or takes as `x: QClass`."""
    tree = ast.parse(source)
    modules = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(PREFIX):
            modules.update({one.asname or one.name: (node.module[len(PREFIX) :], one.name) for one in node.names})
    found = {(module, (name,)) for module, name in modules.values()}
    for scope in [tree, *(n for n in ast.walk(tree) if isinstance(n, (ast.FunctionDef, ast.ClassDef)))]:
        kinds = {name: name for name in modules} if scope is tree else kinds_in(scope, modules)
        for node in ast.walk(scope):
            names = chain(node)
            split = 2 if names[:1] == ["self"] else 1
            kind = kinds.get(".".join(names[:split]))
            if kind and len(names) > split:
                module, name = modules[kind]
                # Of an instance, check only the member: calls and signals give other classes.
                found.add((module, (name, *names[split:][: None if scope is tree else 1])))
    return found


def kinds_in(scope, modules) -> dict[str, str]:
    """Return the Qt class of each variable of a function, or `self.x` of a class, if it is always the same."""
    kinds = {}
    for node in ast.walk(scope):
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            called = isinstance(node.value, ast.Call) and chain(node.value.func)
            kinds.setdefault(".".join(chain(node.targets[0])), set()).add(
                called[0] if called and len(called) == 1 else ""
            )
        elif isinstance(node, ast.arg):
            kinds.setdefault(node.arg, set()).add(".".join(chain(node.annotation)))
        elif isinstance(node, ast.Call) and chain(node.func) == ["isinstance"]:
            # A variable that is tested for its class may have another one.
            kinds.setdefault(".".join(chain(node.args[0])), set()).add("")
    is_class = isinstance(scope, ast.ClassDef)
    return {
        name: next(iter(found))
        for name, found in kinds.items()
        if len(found) == 1 and found <= set(modules) and name.startswith("self.") == is_class
    }


def missing_in_qt6(names) -> list[str]:
    asked = json.dumps(sorted((module, list(names)) for module, names in names))
    surroundings = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-c", LOOK_UP]
    done = subprocess.run(command, input=asked, capture_output=True, text=True, check=True, env=surroundings)
    return [".".join(found) for found in json.loads(done.stdout)]


@needs_pyqt6
def test_every_qt_name_of_shipped_code_is_in_qt_6():
    used = set().union(*(qt_names(path.read_text(encoding="utf-8")) for path in FILES))
    assert len(used) > 200 and missing_in_qt6(used) == []


@needs_pyqt6
def test_what_qt_6_does_not_have_is_found():
    asked = {("QtGui", ("QFontMetricsF", "width")), ("QtCore", ("Qt", "AlignLeft")), ("QtGui", ("QColor", "rgb"))}
    asked.add(("QtWidgets", ("QStyleOptionViewItem", "fontMetrics")))
    assert missing_in_qt6(asked) == ["QtCore.Qt.AlignLeft", "QtGui.QFontMetricsF.width"]


PROGRAM = Path(__file__).resolve().parents[1] / "data" / "qt6_widgets.py"
PAINTED = {"image_view": 50_000, "components_page": 20_000, "results_list": 10_000, "vector_plot": 5000}
PAINTED |= {"details": 1000, "missing_notice": 1000, "status_line": 500, "empty_list": 500, "row_of_buttons": 350}
PAINTED |= {"empty_plot": 200}
"""Least number of pixels that differ from the background: about a third of those with one style and font."""


@pytest.fixture(scope="module")
def painted(tmp_path_factory):
    profile = tmp_path_factory.mktemp("profile")
    surroundings = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONWARNINGS": "default"}
    command = [sys.executable, str(PROGRAM), str(profile)]
    return subprocess.run(command, capture_output=True, text=True, env=surroundings, timeout=300, check=False)


@needs_pyqt6
def test_the_widgets_are_made_shown_and_used_without_an_error(painted):
    assert painted.returncode == 0, painted.stderr
    assert "Traceback" not in painted.stderr and "QPainter" not in painted.stderr


@needs_pyqt6
@pytest.mark.parametrize("widget", PAINTED)
def test_the_picture_of_a_widget_is_not_empty(painted, widget):
    seen = json.loads(painted.stdout.splitlines()[-1])
    assert set(seen) == set(PAINTED)
    assert seen[widget]["pixels"] >= PAINTED[widget] and seen[widget]["colors"] > 10
