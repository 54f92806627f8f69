"""Walk with *Set up an area* to the first position inside desktop QGIS (--code), and count clicks.

SEMREF_WALK names the job, a JSON file that time_walk.py writes. Its keys are:

- ``tools``: the folder of this file;
- ``ground``: a folder with orthophoto.tif, photos and photos.csv;
- ``polygons``: the name of the polygon file in it;
- ``work``: an empty folder for outputs;
- ``python``, ``minutes``: the Python of the training environment, and the time limit of the training, 0 for none;
- ``model``: a model to choose in the dialog; may be empty;
- ``pictures``: the folder of the pictures.

SEMREF_DESKTOP_RESULT names the JSON file that is written at the end: the clicks and seconds of each step.
"""

import csv
import json
import math
import os
import re
import resource
import sys
import time
import traceback
from contextlib import contextmanager
from pathlib import Path

import qgis.utils
from qgis.core import QgsProject, QgsSettings
from qgis.PyQt.QtCore import QMimeData, QPointF, Qt, QTimer, QUrl
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QAction, QApplication, QLineEdit

JOB = json.loads(Path(os.environ["SEMREF_WALK"]).read_text(encoding="utf-8"))
sys.path.append(JOB["tools"])
from screenshot_window import Session, settle, wait_until  # noqa: E402 - its folder is in the job

WINDOW_PX, DIALOG_PX = (1280, 900), (620, 480)
LIMIT_S = 3600
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
        begun, before, processor = time.monotonic(), self.hand.clicks, processor_seconds()
        yield
        used = round(processor_seconds() - processor, 1)
        self.steps.append([name, self.hand.clicks - before, round(time.monotonic() - begun, 1), used])

    def go(self) -> dict:
        # The training environment is installed.
        QgsSettings().setValue("semref/options/training_python", self.job["python"])
        self.open_layers()
        self.set_up()
        self.look()
        return {"steps": self.steps, **self.seen}

    def open_layers(self) -> None:
        with self.step("layers"):
            self.hand.drop(self.session.window, [self.ground / "orthophoto.tif", self.ground / self.job["polygons"]])
            wait_until(lambda: len(QgsProject.instance().mapLayers()) == 2, "the layers")
            # Menu, submenu and entry.
            self.hand.clicks += 3
            self.session.window.findChild(QAction, "SemRefSetUpAction").trigger()
            wait_until(lambda: self.session.dock.setting_up is not None, "the dialog")
        self.session.resize(*WINDOW_PX)

    def set_up(self) -> None:
        dialog = self.session.dock.setting_up
        dialog.setGeometry(0, 0, *DIALOG_PX)
        with self.step("fields"):
            self.hand.write(dialog.photos.findChild(QLineEdit), str(self.ground / "photos"))
            if self.job["minutes"]:
                self.hand.write(dialog.minutes, f"{self.job['minutes']:g}")
            if self.job["model"]:
                self.hand.write(dialog.model.findChild(QLineEdit), self.job["model"])
            self.hand.write(dialog.folder.findChild(QLineEdit), str(self.work / "results"))
            wait_until(dialog.start.isEnabled, "the summary")
        self.seen["summary"] = dialog.summary.text()
        self.session.take("own_area_dialog", dialog)
        with self.step("run"):
            self.hand.click(dialog.start)
            wait_until(lambda: not dialog.isVisible() or not dialog._run.running, "the end of the run", LIMIT_S)
        if dialog.isVisible():
            raise RuntimeError(dialog.summary.text())
        report = (self.work / "results" / "report.html").read_text(encoding="utf-8")
        self.seen["expected"] = re.search(r"If the model finds [^<]*", report)[0]

    def look(self) -> None:
        tab = self.session.dock.content.localize
        findings = tab.results.list.findings
        self.seen |= compared(findings, self.ground / "photos.csv")
        fixes = [row for row, finding in enumerate(findings) if finding.status == "fix"]
        with self.step("look"):
            self.hand.clicks += 1
            tab.results.list.setCurrentRow(fixes[0] if fixes else 0)
        if fixes:
            wait_until(lambda: tab.results.image.canvas.scene().items(), "the selected image")
        self.close_what_lies_over()
        self.session.take("own_area_position")

    def close_what_lies_over(self) -> None:
        """Close other windows, such as QGIS's progress dialog, before taking the picture."""
        for widget in QApplication.topLevelWidgets():
            if widget is not self.session.window and widget.isWindow() and widget.isVisible():
                self.seen.setdefault("closed", []).append(f"{type(widget).__name__} {widget.windowTitle()}")
                widget.close()
                widget.hide()
        settle(0.5)


def compared(findings: list, truth: Path) -> dict:
    """Return the number of fixes, and how many are within their 95 % radius and within three times this radius."""
    with truth.open(encoding="utf-8", newline="") as file:
        places = {row["image"]: (float(row["x"]), float(row["y"])) for row in csv.DictReader(file)}
    fixes = [finding for finding in findings if finding.status == "fix"]
    off = [math.dist((fix.x, fix.y), places[fix.name]) for fix in fixes]
    within = sum(distance <= fix.error_95 for distance, fix in zip(off, fixes))
    return {"photos": len(findings), "fixes": len(fixes), "within_radius": within, "off_m": [round(d, 2) for d in off]}


def processor_seconds() -> float:
    """Return the processor time of QGIS and of the trainings that have ended."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


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
