"""The walk with *Set up an area* to the first position as a scene of screenshot_session.py, with counted clicks.

Keys of its job, which time_walk.py writes:

- ``ground``: a folder with orthophoto.tif, photos and photos.csv;
- ``polygons``: the name of the polygon file in it;
- ``work``: an empty folder for outputs;
- ``python``, ``minutes``: the Python of the training environment, and the time limit of the training, 0 for none;
- ``model``: a model to choose in the dialog; may be empty.

The result has ``steps``: name, clicks, seconds and processor seconds of each.
"""

import csv
import math
import re
import resource
import time
from contextlib import contextmanager
from pathlib import Path

from qgis.core import QgsProject, QgsSettings
from qgis.PyQt.QtCore import QMimeData, QPointF, Qt, QUrl
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QAction, QApplication, QLineEdit
from screenshot_window import WINDOW, Session
from walking import settle, wait_until

DIALOG_PX = (620, 480)


def walk(session: Session) -> None:
    # The training environment is installed.
    QgsSettings().setValue("semref/options/training_python", session.job["python"])
    steps = Walk(session)
    steps.open_layers()
    steps.set_up()
    steps.look()


class Walk:
    """The steps of the walk. It operates the window like a person, and counts each click, drop and text field."""

    def __init__(self, session: Session) -> None:
        self.session, self.job, self.clicks = session, session.job, 0
        self.ground, self.work = Path(self.job["ground"]), Path(self.job["work"])
        self.seen = session.seen
        self.steps = self.seen["steps"] = []

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

    @contextmanager
    def step(self, name: str):
        begun, before, processor = time.monotonic(), self.clicks, processor_seconds()
        yield
        used = round(processor_seconds() - processor, 1)
        self.steps.append([name, self.clicks - before, round(time.monotonic() - begun, 1), used])

    def open_layers(self) -> None:
        with self.step("layers"):
            self.drop(self.session.window, [self.ground / "orthophoto.tif", self.ground / self.job["polygons"]])
            wait_until(lambda: len(QgsProject.instance().mapLayers()) == 2, "the layers")
            # Menu, submenu and entry.
            self.clicks += 3
            self.session.window.findChild(QAction, "SemRefSetUpAction").trigger()
            wait_until(lambda: self.session.dock.setting_up is not None, "the dialog")
        self.session.resize(*WINDOW)

    def set_up(self) -> None:
        dialog = self.session.dock.setting_up
        dialog.setGeometry(0, 0, *DIALOG_PX)
        with self.step("fields"):
            self.write(dialog.photos.findChild(QLineEdit), str(self.ground / "photos"))
            if self.job["minutes"]:
                self.write(dialog.minutes, f"{self.job['minutes']:g}")
            if self.job["model"]:
                self.write(dialog.model.findChild(QLineEdit), self.job["model"])
            self.write(dialog.folder.findChild(QLineEdit), str(self.work / "results"))
            wait_until(dialog.start.isEnabled, "the summary")
        self.seen["summary"] = dialog.summary.text()
        self.session.take("own_area_dialog", dialog)
        with self.step("run"):
            self.click(dialog.start)
            while dialog.isVisible() and dialog._run.running:
                settle(1)
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
            self.clicks += 1
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
