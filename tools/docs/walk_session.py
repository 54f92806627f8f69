"""Walk from orthophoto and polygons to the first fix inside desktop QGIS (--code), and count clicks.

SEMREF_WALK names the job, a JSON file that time_walk.py writes. Its keys are:

- ``tools``: the folder of this file;
- ``ground``: a folder with the files of tools/sample;
- ``polygons``: the name of the polygon file in it;
- ``buildings_alone``: whether ground without a polygon has the class “other”;
- ``fields``: texts for the dialog that builds the database, by key;
- ``picture``: the last picture of the walk; may be empty;
- ``work``: an empty folder for outputs;
- ``python``, ``minutes``: the Python for the training, and its time limit;
- ``pictures``: the folder of the pictures.

SEMREF_DESKTOP_RESULT names the JSON file that is written at the end: the clicks and seconds of each step.
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
from screenshot_window import Session, settle, wait_until  # noqa: E402 - its folder is in the job

WINDOW_PX, DIALOG_PX = (1280, 900), (1000, 880)
LIMIT_S, CRITICAL = 3600, 2
messages = []


class Hand:
    """Operate the window like a person, and count each click, drop and text field."""

    def __init__(self) -> None:
        self.clicks = 0

    def click(self, widget) -> None:
        self.clicks += 1
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton)
        settle(0.3)

    def write(self, widget, text: str) -> None:
        """Replace the text of a field."""
        self.clicks += 1
        widget.setFocus()
        widget.selectAll()
        QTest.keyClicks(widget, text)
        QTest.keyClick(widget, Qt.Key.Key_Tab)
        settle(0.1)

    def tick(self, box) -> None:
        """Click the check box itself, not the middle of the line."""
        self.clicks += 1
        QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=QPoint(8, box.height() // 2))
        if not box.isChecked():
            raise RuntimeError(f"“{box.text()}” cannot be checked")

    def drop(self, widget, paths: list) -> None:
        """Drop files from a folder window of the system."""
        self.clicks += 1
        # A scroll area accepts drops at its content.
        widget = widget.viewport() if hasattr(widget, "viewport") else widget
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        middle = QPointF(widget.width() / 2, widget.height() / 2)
        how = Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        QApplication.sendEvent(widget, QDragEnterEvent(middle.toPoint(), *how))
        QApplication.sendEvent(widget, QDropEvent(middle, *how))
        settle(0.3)


class Walk:
    """The steps of the walk."""

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
        """Open Settings ▸ Options… ▸ SemRef. The dialog is modal, so a timer operates it."""
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
        """Close other windows, such as QGIS's progress dialog, before taking the picture."""
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
        # The dialog reports the end before its buttons are active.
        wait_until(button_of(dialog, "Close").isEnabled, "the dialog's buttons")
        settle(0.5)
        return ended[0][1]


def compared(findings: list, truth: Path) -> dict:
    """Return the number of fixes, and how many are within their 95 % radius and within three times this radius."""
    with truth.open(encoding="utf-8", newline="") as file:
        places = {row["image"]: (float(row["x"]), float(row["y"])) for row in csv.DictReader(file)}
    fixes = [finding for finding in findings if finding.status == "fix"]
    off = [math.dist((fix.x, fix.y), places[fix.name]) for fix in fixes]
    within = sum(distance <= fix.error_95 for distance, fix in zip(off, fixes))
    return {"photos": len(findings), "fixes": len(fixes), "within_radius": within, "off_m": [round(d, 2) for d in off]}


def refused() -> str:
    """Return the error text of QGIS's message bar."""
    return "; ".join(item.text() for item in qgis.utils.iface.messageBar().items() if int(item.level()) == CRITICAL)


def given(fields: dict, *keys: str) -> dict:
    """Return the initial value of a field of a dialog: text, or whether it has a value."""
    return {key: str(fields[key].parameterValue() or "") for key in keys}


def field(fields: dict, key: str):
    return fields[key].wrappedWidget()


def line(fields: dict, key: str) -> QLineEdit:
    """Return the field for a text or the path of an output."""
    wrapper = fields[key]
    widget = wrapper.wrappedWidget() if hasattr(wrapper, "wrappedWidget") else wrapper
    return widget if isinstance(widget, QLineEdit) else widget.findChild(QLineEdit)


def button_of(dialog, name: str):
    """Return the button Run. In some versions of QGIS it is the OK button."""
    if name == "Ok":
        return dialog.buttonBox().button(QDialogButtonBox.StandardButton.Ok) or dialog.runButton()
    return dialog.buttonBox().button(getattr(QDialogButtonBox.StandardButton, name))


def refusal(dialog) -> str:
    """Return the message of a dialog that does not start."""
    item = dialog.messageBar().currentItem()
    return "" if item is None else item.text()


def run() -> None:
    try:
        result = session()
    except Exception:
        result = {"error": traceback.format_exc()}
    result["messages"] = messages
    Path(os.environ["SEMREF_DESKTOP_RESULT"]).write_text(json.dumps(result, indent=1), encoding="utf-8")
    # Do not ask whether to save the project.
    QgsSettings().setValue("app/askToSaveMemoryLayers", False)
    QgsSettings().setValue("qgis/askToSaveProjectChanges", False)
    QgsProject.instance().clear()
    qgis.utils.iface.actionExit().trigger()


def session() -> dict:
    window = Session(JOB)
    window.tidy()
    return {**Walk(window, JOB).go(), "taken": window.taken}


def note_exception(kind, value, trace, text, *arguments, **options) -> None:
    """Replace QGIS's dialog, which would wait for a click."""
    messages.append("".join(traceback.format_exception(kind, value, trace)))


qgis.utils.showException = note_exception
# The window is complete only while its event loop runs.
QTimer.singleShot(3000, run)
