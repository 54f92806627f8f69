"""Runs inside desktop QGIS (--code): goes the guide's way from orthophoto and polygons to the first fix, and counts.

SEMREF_WALK names the job, a JSON file that time_walk.py writes: ``tools`` (the folder of this file), ``ground`` (a
folder as tools/sample fills it), ``polygons`` (name of their file there),
``buildings_alone`` (whether all ground without a polygon is something else), ``fields`` (what is written into the
dialog that makes the database, by key), ``picture`` (that ends the walk; empty for none), ``work`` (an empty folder for
what the walk makes), ``python`` (that trains), ``minutes`` (of training) and ``pictures`` (folder).
SEMREF_DESKTOP_RESULT names the JSON file that is written at the end: for each step what was clicked and the seconds
until QGIS was done.
"""

import csv
import json
import math
import os
import sys
import time
import traceback
from contextlib import contextmanager
from pathlib import Path

import qgis.utils
from qgis.core import QgsProject, QgsSettings
from qgis.PyQt.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QAction, QApplication, QDialogButtonBox, QDoubleSpinBox, QLineEdit, QTextEdit

JOB = json.loads(Path(os.environ["SEMREF_WALK"]).read_text(encoding="utf-8"))
sys.path.append(JOB["tools"])
from screenshot_window import Session, settle, wait_until  # noqa: E402 - where it lies the job tells

WINDOW_PX, DIALOG_PX = (1280, 900), (1000, 880)
LIMIT_S, CRITICAL = 3600, 2
messages = []


class Hand:
    """A person's: each click, drop and written field is counted."""

    def __init__(self) -> None:
        self.clicks = 0

    def click(self, widget) -> None:
        self.clicks += 1
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
        settle(0.3)

    def write(self, widget, text: str) -> None:
        """In place of what stands there."""
        self.clicks += 1
        widget.setFocus()
        widget.selectAll()
        QTest.keyClicks(widget, text)
        QTest.keyClick(widget, Qt.Key.Key_Tab)
        settle(0.1)

    def tick(self, box) -> None:
        """Where its square is, not in the middle of the line."""
        self.clicks += 1
        QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPoint(8, box.height() // 2))
        if not box.isChecked():
            raise RuntimeError(f"“{box.text()}” took no tick")

    def drop(self, widget, paths: list) -> None:
        """Files that are dragged from the system's window of a folder."""
        self.clicks += 1
        # What scrolls takes them where its content is.
        widget = widget.viewport() if hasattr(widget, "viewport") else widget
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        middle = QPointF(widget.width() / 2, widget.height() / 2)
        how = Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        QApplication.sendEvent(widget, QDragEnterEvent(middle.toPoint(), *how))
        QApplication.sendEvent(widget, QDropEvent(middle, *how))
        settle(0.3)


class Walk:
    """The steps that were gone."""

    def __init__(self, session, job: dict) -> None:
        self.session, self.job, self.hand = session, job, Hand()
        self.ground, self.work = Path(job["ground"]), Path(job["work"])
        self.steps = []
        self.seen = {}

    @contextmanager
    def step(self, name: str):
        begun, before = time.monotonic(), self.hand.clicks
        yield
        self.steps.append([name, self.hand.clicks - before, round(time.monotonic() - begun, 1)])

    def go(self) -> dict:
        self.name_python()
        self.open_layers()
        self.train()
        self.make_database()
        self.localize()
        return {"steps": self.steps, **self.seen}

    def name_python(self) -> None:
        """Settings ▸ Options… ▸ SemRef: the dialog waits for its user, so a timer is its user."""
        failed = []

        def fill() -> None:
            dialog = QApplication.activeModalWidget()
            try:
                from semref.ui.packages.training_group import TrainingGroup

                group = dialog.findChild(TrainingGroup)
                self.hand.write(group.python.findChild(QLineEdit), self.job["python"])
                self.hand.click(dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Ok))
            except Exception:
                failed.append(traceback.format_exc())
                dialog.close()

        with self.step("options"):
            # Menu, entry and page.
            self.hand.clicks += 3
            QTimer.singleShot(1500, fill)
            self.session.iface.showOptionsDialog(self.session.window, "SemRefOptions")
        if failed:
            raise RuntimeError(failed[0])

    def open_layers(self) -> None:
        with self.step("layers"):
            self.hand.drop(self.session.window, [self.ground / "orthophoto.tif", self.ground / self.job["polygons"]])
            wait_until(lambda: len(QgsProject.instance().mapLayers()) == 2, "the layers")
            self.hand.clicks += 1
            self.session.window.findChild(QAction, "SemRefDockAction").trigger()
            wait_until(lambda: self.session.dock.isVisible(), "the dock")
        self.session.resize(*WINDOW_PX)

    def train(self) -> None:
        images = self.session.dock.content.localize.images
        model = self.work / "own.onnx"
        with self.step("train"):
            self.hand.click(images.train)
            dialog = images.training
            dialog.setGeometry(0, 0, *DIALOG_PX)
            fields = dialog.mainWidget().wrappers
            self.seen["training_begins_with"] = given(fields, "INPUT", "CLASS_FIELD", "PRIORITY_FIELD", "CLASS_TABLE")
            self.hand.write(field(fields, "MINUTES").findChild(QDoubleSpinBox), str(self.job["minutes"]))
            self.hand.write(line(fields, "OUTPUT"), str(model))
            self.session.take("own_network_train", dialog)
            results = self.run(dialog)
            self.session.take("own_network_trained", dialog)
            self.hand.click(button_of(dialog, "Close"))
        self.seen["mean_iou"] = results.get("MEAN_IOU")
        self.seen["model_in_the_dock"] = images.model_path() == str(model)

    def make_database(self) -> None:
        box = self.session.dock.content.database
        database = self.work / "own.gpkg"
        with self.step("database"):
            self.hand.click(box.make)
            dialog = box.making
            dialog.setGeometry(0, 0, *DIALOG_PX)
            fields = dialog.mainWidget().wrappers
            self.seen["database_begins_with"] = given(fields, "INPUT", "CLASS_FIELD", "PRIORITY_FIELD", "CLASS_TABLE")
            for key, value in self.job["fields"].items():
                self.hand.write(field(fields, key), value)
            if self.job["buildings_alone"]:
                self.hand.write(line(fields, "REFERENCE_CLASSES"), "building")
                self.hand.tick(field(fields, "OTHER_GROUND"))
            self.hand.write(line(fields, "build:Reference database"), str(database))
            self.session.take("own_network_database", dialog)
            self.run(dialog)
            self.hand.click(button_of(dialog, "Close"))
            wait_until(lambda: box.path() == str(database), "the database in the dock")

    def localize(self) -> None:
        tab = self.session.dock.content.localize
        photos = sorted((self.ground / "photos").glob("*.jpg"))
        with self.step("localize"):
            self.hand.drop(tab.images.list, photos)
            wait_until(lambda: tab.localize_button.isEnabled(), "photos in the list")
            self.hand.click(tab.localize_button)
            wait_until(lambda: not tab.run.running, "the localization", LIMIT_S)
        if refused():
            raise RuntimeError(refused())
        shown = tab.results.table.model()
        results = shown.sourceModel()
        findings = [results.finding(row) for row in range(results.rowCount())]
        self.seen |= compared(findings, self.ground / "photos.csv")
        fixes = [row for row, finding in enumerate(findings) if finding.status == "fix"]
        with self.step("look"):
            self.hand.clicks += 1
            tab.results.table.selectRow(shown.mapFromSource(results.index(fixes[0] if fixes else 0, 0)).row())
        if fixes:
            wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
            if self.job["picture"]:
                self.close_what_lies_over()
                self.session.take(self.job["picture"])

    def close_what_lies_over(self) -> None:
        """Windows that are still there, such as QGIS's own with a model's progress, would be in the picture."""
        for widget in QApplication.topLevelWidgets():
            if widget is not self.session.window and widget.isWindow() and widget.isVisible():
                self.seen.setdefault("closed", []).append(f"{type(widget).__name__} {widget.windowTitle()}")
                widget.close()
                widget.hide()
        settle(0.5)

    def run(self, dialog) -> dict:
        ended = []
        dialog.algorithmFinished.connect(lambda succeeded, results: ended.append((succeeded, results)))
        self.hand.click(button_of(dialog, "Ok"))
        wait_until(lambda: ended or refusal(dialog), dialog.windowTitle(), LIMIT_S)
        if not ended or not ended[0][0]:
            said = refusal(dialog) or dialog.findChild(QTextEdit, "txtLog").toPlainText()[-2000:]
            raise RuntimeError(f"{dialog.windowTitle()}: {said}")
        # It says that it is done before its buttons are back.
        wait_until(button_of(dialog, "Close").isEnabled, "the dialog's buttons")
        settle(0.5)
        return ended[0][1]


def compared(findings: list, truth: Path) -> dict:
    """How many fixes there are, and how many of them lie within the radius that they tell, or three times it."""
    with truth.open(encoding="utf-8", newline="") as file:
        places = {row["image"]: (float(row["x"]), float(row["y"])) for row in csv.DictReader(file)}
    fixes = [finding for finding in findings if finding.status == "fix"]
    off = [math.dist((fix.x, fix.y), places[fix.name]) for fix in fixes]
    within = sum(distance <= fix.error_95 for distance, fix in zip(off, fixes))
    return {"photos": len(findings), "fixes": len(fixes), "within_radius": within, "off_m": [round(d, 2) for d in off]}


def refused() -> str:
    """What QGIS's message bar says in red."""
    return "; ".join(item.text() for item in qgis.utils.iface.messageBar().items() if int(item.level()) == CRITICAL)


def given(fields: dict, *keys: str) -> dict:
    """What a dialog begins with: text, or whether there is something."""
    return {key: str(fields[key].parameterValue() or "") for key in keys}


def field(fields: dict, key: str):
    return fields[key].wrappedWidget()


def line(fields: dict, key: str) -> QLineEdit:
    """Where a text or the path of an output is written."""
    wrapper = fields[key]
    widget = wrapper.wrappedWidget() if hasattr(wrapper, "wrappedWidget") else wrapper
    return widget if isinstance(widget, QLineEdit) else widget.findChild(QLineEdit)


def button_of(dialog, name: str):
    """Run is QGIS's Ok, in some versions a button of its own."""
    if name == "Ok":
        return dialog.buttonBox().button(QDialogButtonBox.StandardButton.Ok) or dialog.runButton()
    return dialog.buttonBox().button(getattr(QDialogButtonBox.StandardButton, name))


def refusal(dialog) -> str:
    """What a dialog says that does not even begin."""
    item = dialog.messageBar().currentItem()
    return "" if item is None else item.text()


def run() -> None:
    try:
        result = session()
    except Exception:
        result = {"error": traceback.format_exc()}
    result["messages"] = messages
    Path(os.environ["SEMREF_DESKTOP_RESULT"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
    # Nothing of the walk is to be kept, and nobody is there to say so.
    QgsSettings().setValue("app/askToSaveMemoryLayers", False)
    QgsSettings().setValue("qgis/askToSaveProjectChanges", False)
    QgsProject.instance().clear()
    qgis.utils.iface.actionExit().trigger()


def session() -> dict:
    window = Session(JOB)
    window.tidy()
    return {**Walk(window, JOB).go(), "taken": window.taken}


def note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """In place of QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))


qgis.utils.showException = note_exception
# The window is complete only when its event loop runs.
QTimer.singleShot(3000, run)
