"""Known databases and models – of the project, the dock, the models folder, recent use – and their button."""

from __future__ import annotations

import os
from functools import partial
from typing import NamedTuple

from qgis.core import QgsApplication, QgsProject, QgsSettings
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtWidgets import QMenu, QToolButton

from ...processing.inspection.models import model_files, models_folder
from ...processing.translation import tr
from ..layer_files import project_databases
from ..project_state import MODEL_SETTING, remembered_database
from ..widgets.controls import tool_button
from ..widgets.texts import plain_tip

_RECENT = {"database": "semref/recent/databases", "model": "semref/recent/models"}
_MOST_RECENT = 8
"""As many as QGIS lists of recent projects."""

DATABASE, MODEL = _RECENT


class Known(NamedTuple):
    """Files under one heading: (name, path) each."""

    heading: str
    files: list[tuple[str, str]]


def note_used(kind: str, path: str) -> None:
    """Put a file on top of the recently used ones."""
    if path and os.path.isfile(path):
        others = [known for known in _recent(kind) if known != path]
        QgsSettings().setValue(_RECENT[kind], [path, *others][:_MOST_RECENT])


def known_files(kind: str) -> list[Known]:
    """Return the known files, each once, under the first heading that applies; empty headings are left out."""
    if kind == DATABASE:
        of_project = [(name, path) for path, name in project_databases(QgsProject.instance()).items()]
        first = Known(tr("In the project"), of_project), Known(tr("Chosen in the dock"), _named([dock_file(kind)]))
    else:
        folder = [str(path) for path in model_files(models_folder())]
        first = Known(tr("Chosen in the dock"), _named([dock_file(kind)])), Known(tr("Models folder"), _named(folder))
    seen: set[str] = set()
    found = []
    for heading, files in (*first, Known(tr("Used recently"), _named(_recent(kind)))):
        fresh = [(name, path) for name, path in files if os.path.realpath(path) not in seen]
        seen.update(os.path.realpath(path) for _, path in fresh)
        if fresh:
            found.append(Known(heading, fresh))
    return found


def dock_file(kind: str) -> str:
    """Return the file that the dock uses or used last; empty if it does not exist."""
    path = remembered_database() if kind == DATABASE else QgsSettings().value(MODEL_SETTING, "", type=str)
    return path if os.path.isfile(path) else ""


def _recent(kind: str) -> list[str]:
    stored = QgsSettings().value(_RECENT[kind], [])
    # Qt stores a list of one entry as a text.
    return [stored] if isinstance(stored, str) else [path for path in stored or [] if isinstance(path, str)]


def _named(paths: list[str]) -> list[tuple[str, str]]:
    return [(os.path.splitext(os.path.basename(path))[0], path) for path in paths if path and os.path.isfile(path)]


class KnownButton(QToolButton):
    """Button with a menu of known files; the chosen file goes into the box."""

    def __init__(self, box: QgsFileWidget, kind: str) -> None:
        super().__init__(box)
        self._kind = kind
        text = (
            tr("Choose a database from the project or from recent ones")
            if kind == DATABASE
            else tr("Choose a model from the models folder or from recent ones")
        )
        tool_button("/mActionOpenTable.svg" if kind == MODEL else "/mIconDbSchema.svg", text, made=self)
        self.setObjectName("SemRefKnown")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.files = QMenu(self)
        self.files.setToolTipsVisible(True)
        self.setMenu(self.files)
        self.files.aboutToShow.connect(self.list_files)
        box.layout().addWidget(self)

    def list_files(self) -> None:
        """Fill the menu with the files that are known now."""
        self.files.clear()
        icon = QgsApplication.getThemeIcon("/mIconVector.svg" if self._kind == DATABASE else "/mIconFile.svg")
        for heading, files in known_files(self._kind):
            self.files.addSection(heading)
            for name, path in files:
                # A single ampersand would underline the next letter.
                action = self.files.addAction(icon, name.replace("&", "&&"))
                action.setToolTip(plain_tip(path))
                action.setCheckable(True)
                action.setChecked(path == self.parent().filePath())
                action.triggered.connect(partial(self._take, path))
        if self.files.isEmpty():
            nothing = tr("No database yet") if self._kind == DATABASE else tr("No model yet")
            self.files.addAction(nothing).setEnabled(False)

    def _take(self, path: str, *_checked) -> None:
        self.parent().setFilePath(path)
