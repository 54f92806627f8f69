"""Paint the custom widgets of ui/ in Qt 6, without QGIS: a program for tests/core/test_qt6_names.py.

    python qt6_widgets.py PROFILE [PICTURES]

Prints JSON: by widget, how many colors its picture has and how many pixels are not the commonest one; pictures are
kept in the folder PICTURES. Anything that Qt 6 refuses ends it with a traceback.
"""

import importlib
import importlib.util
import json
import os
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]
SIZE_WH = (420, 320)


def load_plugin() -> None:
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    sys.modules["semref"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["semref"])


def module(name: str):
    return importlib.import_module(f"semref.{name}")


def vector_plot():
    ray = module("processing.inspection.window").Ray
    plot = module("ui.tabs.inspect.vector_plot").VectorPlot()
    rays = [ray("building", "#e3211c", length, 0.5, turn, 90.0) for turn, length in ((0, 1.0), (1.4, 0.7), (3.9, 0.4))]
    plot.show_rays(rays, [ray("water", "#1f6fd6", 0.8, 0.5, turn + 0.2, 90.0) for turn in (0, 1.4, 3.9)])
    return plot


def empty_plot():
    plot = module("ui.tabs.inspect.vector_plot").VectorPlot()
    plot.clear("Choose a window.")
    return plot


def status_line():
    line = module("ui.widgets.progress").StatusLine()
    line.show_text("a file with a very long name " * 10 + ".png")
    return line


def image_view():
    """Return an image view with photo, labels and landmarks, zoomed by the wheel."""
    from PyQt6.QtCore import QPoint, QPointF, Qt
    from PyQt6.QtGui import QWheelEvent
    from PyQt6.QtWidgets import QApplication

    picture = module("ui.tabs.localize.picture")
    inspected = module("processing.inspection.image").InspectedImage
    landmarks = module("core.landmarks.landmarks").extract_landmarks
    labels = np.zeros((200, 300), np.uint8)
    for n in range(12):
        row, column = 20 + 50 * (n // 4), 30 + 60 * (n % 4)
        labels[row : row + 14, column : column + 20] = 1 + n % 2
    found = landmarks(labels, (1, 2), 20.0)
    seen = inspected(labels, found, None)
    colors = {1: (227, 33, 28), 2: (31, 111, 214)}
    photo = np.full((200, 300, 4), 255, np.uint8)
    photo[..., 1] = np.arange(300, dtype=np.uint16) % 256
    names = {value: "#{:02x}{:02x}{:02x}".format(*rgb) for value, rgb in colors.items()}
    shown = picture.ImagePicture(
        "photo.png", picture.picture_of(photo), picture.label_picture(labels, colors), seen, names
    )
    view = module("ui.tabs.localize.image_view").ImageView()
    view.resize(*SIZE_WH)
    view.show_picture(shown, [tuple(center) for center in found.centers_xy[:4].tolist()])
    view.show()
    surface = view.canvas.viewport()
    place = QPointF(view.canvas.mapFromScene(*found.centers_xy[0].tolist()))
    none = Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier
    wheel = (QPoint(), QPoint(0, 120), *none, Qt.ScrollPhase.NoScrollPhase, False)
    QApplication.sendEvent(surface, QWheelEvent(place, QPointF(surface.mapToGlobal(place)), *wheel))
    return view


def findings() -> list:
    make = module("ui.findings").Finding
    nothing = dict.fromkeys(make.__dataclass_fields__)
    nothing.update(possible=(), labels="", image="/flight/photo_01.png", status="no_match", reason="Nothing fits.")
    fix = {"status": "fix", "confidence": 0.97, "error_95": 2.5, "heading": 12.0, "method": "constellation"}
    vector = {**fix, "method": "topology vector", "distance": 0.12, "window": "0_160"}
    return [make(**{**nothing, **changed}) for changed in (fix, vector, {})]


def results_list():
    made = module("ui.tabs.localize.results_list").ResultsList()
    made.show_findings(findings())
    made.step(1)
    return made


def empty_list():
    return module("ui.tabs.localize.results_list").ResultsList()


def details():
    shown = module("ui.tabs.localize.results").Details()
    shown.show_finding(findings()[1])
    return shown


def components_page():
    from PyQt6.QtWidgets import QWidget

    page = module("ui.packages.components_page")
    installer = module("ui.packages.component_installer").ComponentInstaller()
    # It has a widget of QGIS.
    page.TrainingGroup = lambda _installer: QWidget()
    made = page.ComponentsPage(installer, installer)
    installer.outputRead.emit("ERROR: something\n")
    installer.failed.emit("It failed.")
    return made


def missing_notice():
    notice = module("ui.packages.missing_notice")
    notice.missing = lambda packages: list(packages)
    return notice.MissingNotice()


def row_of_buttons():
    from PyQt6.QtWidgets import QWidget

    buttons, layouts = module("ui.widgets.controls"), module("ui.widgets.layouts")
    made = QWidget()
    row = layouts.row_of(
        buttons.tool_button("/mActionAdd.svg", "Add", True), (buttons.tool_button("/mActionRemove.svg", "Remove"), 1)
    )
    made.setLayout(layouts.narrow(row))
    buttons.shortcut("Ctrl+Right", made)
    return made


WIDGETS = (
    vector_plot, empty_plot, status_line, image_view, results_list, empty_list, details, components_page,
    missing_notice, row_of_buttons,
)  # fmt: skip


def painted(widget, name: str, pictures: str) -> dict[str, int]:
    """Return the picture of a widget after the event loop has shown it."""
    from PyQt6.QtGui import QImage
    from PyQt6.QtWidgets import QApplication

    widget.resize(*SIZE_WH)
    widget.show()
    for _ in range(5):
        QApplication.processEvents()
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
    if pictures:
        image.save(os.path.join(pictures, f"{name}.png"))
    bits = image.constBits()
    bits.setsize(image.sizeInBytes())
    pixels = np.frombuffer(bits, np.uint32)
    _, counts = np.unique(pixels, return_counts=True)
    return {"colors": len(counts), "pixels": int(len(pixels) - counts.max())}


def main(profile: str, pictures: str = "") -> None:
    import qt6_shim
    from PyQt6.QtWidgets import QApplication

    qt6_shim.install(profile)
    load_plugin()
    application = QApplication([])
    found = {make.__name__: painted(make(), make.__name__, pictures) for make in WIDGETS}
    application.processEvents()
    print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
