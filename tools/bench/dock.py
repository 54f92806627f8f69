"""The dock in a real window: how long QGIS's main thread stands still, and whether anything grows.

    xvfb-run -a -s "-screen 0 1600x1000x24" .venv/bin/python tools/bench dock

Stalls: photos of the sample area, with the model that ships: segmented, localized, then shown one after the other,
laid on the map, kept, inspected; a timer beats every 5 ms, and the longest time between two beats is the stall. In the
first round QGIS and Python load what they need for the first time; the second is what a user feels from then on.
Growth: the plugin loaded and unloaded again and again, each time localizing and showing an image; then label images
localized and shown one by one in one dock.
"""

from __future__ import annotations

import gc
import importlib.util
import os
import subprocess
import sys
import time
from pathlib import Path

from bench import inputs, page, plugin

PAGE = "benchmarks.md"
AREA = "The sample area."
WINDOW = True
"""It needs a real window: without DISPLAY nothing is measured."""

PHOTOS, IMAGES, ROUNDS = 20, 200, 20
QUICK_PHOTOS, QUICK_IMAGES, QUICK_ROUNDS = 2, 3, 2
BEAT_MS = 5
WAIT_S = 600
CUT_PX = 640
WINDOW_WH = (1500, 950)


def measure(run: inputs.Run) -> dict[str, str]:
    if not os.environ.get("DISPLAY"):
        reason = "Not measured: there is no display; run it under xvfb-run."
        return {"dock stalls": reason, "dock growth": reason}
    from qgis.core import QgsApplication

    from semref.processing.provider import register_provider

    folder = run.work / "dock"
    folder.mkdir(exist_ok=True)
    make_sample(folder)
    registry = QgsApplication.processingRegistry()
    registry.removeProvider("semref")  # The plugin registers its own.
    measured = {}
    if run.wants("stalls"):
        stalls = measure_stalls(folder, run.how_many(PHOTOS, QUICK_PHOTOS))
        measured["dock stalls"] = f"{_STALLS}\n\n{stalls}"
    if run.wants("growth"):
        rounds = QUICK_ROUNDS if run.quick else ROUNDS
        growth = measure_growth(folder, run.how_many(IMAGES, QUICK_IMAGES), rounds)
        measured["dock growth"] = f"{_GROWTH}\n\n{growth}"
    # The session takes one away when it ends.
    _KEPT.append(register_provider(registry))
    return measured


_KEPT: list[object] = []
_STALLS = """\
In a real window (1,500 × 950) with the sample project's layers on the canvas. A timer beats every 5 ms in QGIS's main
thread; a stall is the longest time between two beats, own work the longest processor time of the thread between two.
Goal: ≤ 100 ms."""

_GROWTH = "Widgets, items on the canvas, layers of the project, resident memory of QGIS."


def make_sample(folder: Path) -> None:
    """Area, label map and database of *Open the sample project*; what is there is kept."""
    from semref.ui.sample_project import DATABASE_FILE, copy_sample, parameters

    subprocess.run([sys.executable, "-m", "tools.sample"], cwd=inputs.TOOLS.parent, check=True)
    copy_sample(folder)
    if not (folder / DATABASE_FILE).exists():
        plugin.run_algorithm("annotationtodatabase", parameters(folder))


# --- the window ---


def make_window():
    """What a plugin uses of QGIS's window, as the tests have it, with a canvas in the sample's CRS."""
    from qgis.core import QgsCoordinateReferenceSystem

    place = inputs.TOOLS.parent / "tests" / "data" / "stand_in_interface.py"
    spec = importlib.util.spec_from_file_location("stand_in_interface", place)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    interface = module.InterfaceStandIn()
    interface.window.resize(*WINDOW_WH)
    interface.window.show()
    interface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:25832"))
    return interface


def load_plugin(interface):
    """The plugin, its dock not opened yet."""
    from semref.plugin import SemRefPlugin

    loaded = SemRefPlugin(interface)
    loaded.initGui()
    return loaded


def open_dock(interface):
    """The dock, after a click on its button."""
    interface.tool_bar_actions[0].trigger()
    return interface.docks[0]


def turn_events(condition, pause_s: float = 0.002) -> None:
    """Lets Qt work until the condition holds."""
    from qgis.PyQt.QtCore import QCoreApplication

    end = time.monotonic() + WAIT_S
    while not condition():
        if time.monotonic() > end:
            raise SystemExit(f"Not done within {WAIT_S} s.")
        QCoreApplication.processEvents()
        time.sleep(pause_s)


def settle(seconds: float = 0.2) -> None:
    """Also what is to be deleted later."""
    from qgis.PyQt.QtCore import QCoreApplication, QEvent

    end = time.monotonic() + seconds
    turn_events(lambda: time.monotonic() > end)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def localize(dock) -> None:
    dock.content.localize.localize_button.click()
    turn_events(lambda: not dock.content.localize.run.running)


def show(dock, row: int) -> None:
    """Selects a result and waits for its picture."""
    dock.content.localize.results.table.selectRow(row)
    canvas = dock.content.localize.results.image.canvas
    turn_events(lambda: bool(canvas.scene().items()))


# --- stalls ---


class Heartbeat:
    """The longest time that the main thread did not come round, and the longest that it worked meanwhile.

    On a machine that does other things as well the first holds what those took; the second is the thread's own.
    """

    def __init__(self) -> None:
        from qgis.PyQt.QtCore import Qt, QTimer

        self._longest = [0.0, 0.0]
        self._last = time.perf_counter(), time.thread_time()
        self._timer = QTimer()
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self._timer.start(BEAT_MS)

    def _beat(self) -> None:
        now = time.perf_counter(), time.thread_time()
        self._longest = [max(longest, t - last) for longest, t, last in zip(self._longest, now, self._last)]
        self._last = now

    def take(self) -> tuple:
        """Milliseconds of both, since the last time it was asked."""
        self._beat()
        longest, self._longest = self._longest, [0.0, 0.0]
        return tuple(1000 * seconds for seconds in longest)


def measure_stalls(folder: Path, count: int) -> str:
    """A row for each step: the longest stall, the first and the second time."""
    from qgis.core import QgsProject

    from semref.ui.sample_project import fill_project

    interface = make_window()
    extent = fill_project(QgsProject.instance(), folder)
    nodes = QgsProject.instance().layerTreeRoot().findLayers()
    interface.canvas.setLayers([node.layer() for node in nodes if node.isVisible()])
    interface.canvas.setReferencedExtent(extent)
    settle(2.0)
    photos = sorted(str(path) for path in (folder / "photos").glob("*.jpg"))
    photos = [photos[n % len(photos)] for n in range(count)]
    rows: dict = {}
    for _ in range(2):
        for name, longest in stall_round(interface, folder, photos):
            print(name, longest, file=sys.stderr, flush=True)
            rows.setdefault(name, []).append(longest)
    header = ["step", "longest stall, first time (ms)", "of it the thread’s own work", "again (ms)", "own work"]
    return page.table(header, [[name, *(f"{ms:.0f}" for ms in (*both[0], *both[1]))] for name, both in rows.items()])


def stall_round(interface, folder: Path, photos: list):
    """(step, milliseconds) one after the other, in a plugin loaded for it."""
    from qgis.core import QgsProject

    from semref.ui.sample_project import DATABASE_FILE, MODEL

    heart = Heartbeat()
    settle(3.0)
    yield "nothing", heart.take()
    loaded = load_plugin(interface)
    settle(2.0)
    yield "load the plugin", heart.take()
    dock = open_dock(interface)
    settle()
    yield "open the dock", heart.take()
    # Each photo as often as it is asked for: the list holds a file once.
    dock.prepare(str(folder / DATABASE_FILE), str(MODEL), linked(photos, folder))
    settle()
    yield f"add {len(photos)} photos", heart.take()
    localize(dock)
    yield f"segment and localize {len(photos)} photos", heart.take()
    settle(1.0)
    for row in range(len(photos)):
        show(dock, row)
    settle(1.0)
    yield f"show {len(photos)} results one after the other", heart.take()
    for _ in range(2 * len(photos)):
        dock.content.localize.results.after.click()
        settle(0.03)
    turn_events(lambda: bool(dock.content.localize.results.image.canvas.scene().items()))
    yield "go through them with the key held down", heart.take()
    layers = len(QgsProject.instance().mapLayers())
    dock.content.localize.results.drape.click()
    turn_events(lambda: len(QgsProject.instance().mapLayers()) > layers)
    settle()
    yield "lay an image on the map", heart.take()
    dock.content.localize.results.keep.click()
    settle()
    yield "keep the results as a layer", heart.take()
    dock.inspect_window("1440_1120")
    turn_events(lambda: dock.content.inspect.numbers.rowCount() > 0)
    for _ in range(10):
        dock.content.inspect.after.click()
        settle(0.05)
    yield "inspect eleven windows", heart.take()
    loaded.unload()
    settle()
    yield "unload the plugin", heart.take()


def linked(photos: list, folder: Path) -> list:
    """A file of its own for each photo, with its camera's metadata beside it if it has any."""
    place = folder / "repeated"
    place.mkdir(exist_ok=True)
    made = []
    for number, photo in enumerate(photos):
        path = place / f"photo_{number:03d}{Path(photo).suffix}"
        if not path.exists():
            os.link(photo, path)
        made.append(str(path))
    return made


# --- growth ---


def measure_growth(folder: Path, count: int, rounds: int) -> str:
    """Widgets, items, layers and memory after each step of use."""
    from semref.ui.sample_project import DATABASE_FILE

    interface = make_window()
    images = label_images(folder, count)
    database = str(folder / DATABASE_FILE)
    rows = [counts(interface, "nothing yet")]
    for number in range(1, rounds + 1):
        loaded, dock = load_plugin(interface), open_dock(interface)
        dock.prepare(database, "", images[:1])
        localize(dock)
        show(dock, 0)
        dock.inspect_window("1440_1120")
        turn_events(lambda: dock.content.inspect.numbers.rowCount() > 0)
        loaded.unload()
        del loaded, dock
        settle()
        if number in {1, 2, 5, 10, 15, 20} or number % 20 == 0:
            rows.append(counts(interface, f"{number} × loaded, used and unloaded"))
    loaded, dock = load_plugin(interface), open_dock(interface)
    dock.prepare(database, "", images)
    localize(dock)
    settle()
    rows.append(counts(interface, f"{count} images localized in one dock"))
    for number in range(1, count + 1):
        show(dock, number - 1)
        if number in {1, 10, 50} or number % 50 == 0:
            rows.append(counts(interface, f"{number} of them shown"))
    loaded.unload()
    settle()
    rows.append(counts(interface, "the dock unloaded"))
    return page.table(["after", "widgets", "items on the canvas", "layers", "resident memory (MiB)"], rows)


def label_images(folder: Path, count: int) -> list:
    """Squares of the sample's label map, anywhere, seeded."""
    import numpy as np
    from osgeo import gdal

    from semref.ui.sample_project import LABEL_MAP_FILE

    place = folder / "labels"
    place.mkdir(exist_ok=True)
    source = gdal.Open(str(folder / LABEL_MAP_FILE))
    generator = np.random.default_rng(1)
    paths = []
    for number in range(count):
        corner = generator.integers(0, (source.RasterXSize - CUT_PX, source.RasterYSize - CUT_PX))
        path = place / f"cut_{number:03d}.tif"
        if not path.exists():
            cut = gdal.GetDriverByName("GTiff").Create(str(path), CUT_PX, CUT_PX, 1, options=["COMPRESS=DEFLATE"])
            cut.WriteArray(source.ReadAsArray(*map(int, corner), CUT_PX, CUT_PX))
            del cut
        paths.append(str(path))
    return paths


def counts(interface, after: str) -> list[str]:
    """A row of the table of growth."""
    from qgis.core import QgsProject
    from qgis.PyQt.QtWidgets import QApplication

    gc.collect()
    items = len(interface.canvas.scene().items())
    widgets, layers = len(QApplication.allWidgets()), len(QgsProject.instance().mapLayers())
    print(f"  {after}: {widgets}, {items}, {layers}", file=sys.stderr, flush=True)
    return [after, str(widgets), str(items), str(layers), f"{resident_mib():.0f}"]


def resident_mib() -> float:
    pages = int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20
