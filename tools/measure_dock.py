"""Measures the dock in a real window: how long QGIS's main thread stands still, and whether anything grows.

    xvfb-run -a -s "-screen 0 1600x1000x24" python tools/measure_dock.py stalls [--images 20]
    xvfb-run -a -s "-screen 0 1600x1000x24" python tools/measure_dock.py growth [--rounds 20] [--images 200]

``stalls``: photos of the sample area, with the model that ships: segmented, localized, then shown one after the other,
laid on the map, kept, inspected; a timer beats every 5 ms, and the longest time between two beats is the stall. In the
first round QGIS and Python load what they need for the first time; the second is what a user feels from then on.
``growth``: the plugin loaded and unloaded --rounds times, each time localizing and showing an image; then
--images label images localized and shown one by one in one dock: widgets, items on the canvas, layers and
memory after each. Prints Markdown. --folder keeps the sample area for the next time.
"""

from __future__ import annotations

import argparse
import gc
import importlib.util
import os
import sys
import tempfile
import threading
import time
import traceback
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from bench.machine import footer, load
from qgis_session import ROOT, qgis_session

BEAT_MS = 5
WAIT_S = 600
CUT_PX = 640
WINDOW_WH = (1500, 950)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("stalls", "growth"))
    parser.add_argument("--images", type=int)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--folder", type=Path)
    parser.add_argument("--tell", type=float, default=0.0, metavar="MS", help="tell where longer stalls come from")
    arguments = parser.parse_args()
    if not os.environ.get("DISPLAY"):
        parser.error("There is no display; run it under xvfb-run.")
    # In qgis_session "offscreen" is only the default: here windows are real.
    os.environ["QT_QPA_PLATFORM"] = "xcb"
    before = load()
    with tempfile.TemporaryDirectory(prefix="semref-dock-") as temporary, qgis_session() as provider:
        from qgis.core import QgsApplication

        folder = arguments.folder or Path(temporary)
        make_sample(folder)
        # The plugin registers its own.
        QgsApplication.processingRegistry().removeProvider(provider)
        if arguments.what == "stalls":
            measure_stalls(folder, arguments.images or 20, arguments.tell / 1000)
        else:
            measure_growth(folder, arguments.images or 200, arguments.rounds)
        from semref.processing.provider import register_provider

        # qgis_session takes one away when it ends.
        kept = register_provider(QgsApplication.processingRegistry())
        command = f"tools/measure_dock.py {arguments.what}"
        print(footer(command, "The sample area.", before), flush=True)
        del kept


def make_sample(folder: Path) -> None:
    """Area, label map and database of *Open the sample project*; what is there is kept."""
    import processing

    from semref.ui.sample_project import steps

    for step in steps(folder):
        if not step.result.exists():
            print(step.text, file=sys.stderr, flush=True)
            processing.run(step.algorithm, step.parameters)


# --- the window ---


def make_window():
    """What a plugin uses of QGIS's window, as the tests have it, with a canvas in the sample's CRS."""
    from qgis.core import QgsCoordinateReferenceSystem

    spec = importlib.util.spec_from_file_location("semref_gui_tests", ROOT / "tests" / "gui" / "conftest.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    interface = module.make_interface()
    interface.window.resize(*WINDOW_WH)
    interface.window.show()
    interface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:25832"))
    return interface


def load_plugin(interface):
    """The plugin, its dock not opened yet."""
    from semref.plugin import SemRefPlugin

    plugin = SemRefPlugin(interface)
    plugin.initGui()
    return plugin


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

    def __init__(self, told_s: float) -> None:
        """``told_s``: stalls longer than this are told with what Python was doing; 0 for none."""
        from qgis.PyQt.QtCore import Qt, QTimer

        self._longest = [0.0, 0.0]
        self._last = time.perf_counter(), time.thread_time()
        self._timer = QTimer()
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self._timer.start(BEAT_MS)
        if told_s:
            threading.Thread(target=self._tell, args=(told_s,), daemon=True).start()

    def _beat(self) -> None:
        now = time.perf_counter(), time.thread_time()
        self._longest = [max(longest, t - last) for longest, t, last in zip(self._longest, now, self._last)]
        self._last = now

    def take(self) -> tuple:
        """Milliseconds of both, since the last time it was asked."""
        self._beat()
        longest, self._longest = self._longest, [0.0, 0.0]
        return tuple(1000 * seconds for seconds in longest)

    def _tell(self, told_s: float) -> None:
        """In a thread of its own: where Python's threads are at each stall. Only one of them runs Python at a time, so
        that another one's long call may be what the main thread waits for."""
        told = None
        while True:
            time.sleep(0.01)
            if time.perf_counter() - self._last[0] > told_s and self._last != told:
                told = self._last
                for frame in sys._current_frames().values():
                    frames = traceback.extract_stack(frame)[-4:]
                    stack = " < ".join(f"{Path(f.filename).name}:{f.lineno} {f.name}" for f in reversed(frames))
                    print(f"stall: {stack}", file=sys.stderr)
                print(flush=True, file=sys.stderr)


def measure_stalls(folder: Path, count: int, told_s: float) -> None:
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
        for name, longest in stall_round(interface, folder, photos, told_s):
            print(name, longest, file=sys.stderr, flush=True)
            rows.setdefault(name, []).append(longest)
    print("| step | longest stall, first time (ms) | of it the thread’s own work | again (ms) | own work |")
    print("|---|---:|---:|---:|---:|")
    for name, (first, again) in rows.items():
        print(f"| {name} | {first[0]:.0f} | {first[1]:.0f} | {again[0]:.0f} | {again[1]:.0f} |")
    print(flush=True)


def stall_round(interface, folder: Path, photos: list, told_s: float):
    """(step, milliseconds) one after the other, in a plugin loaded for it."""
    from qgis.core import QgsProject

    from semref.ui.sample_project import DATABASE_FILE, MODEL

    heart = Heartbeat(told_s)
    settle(3.0)
    yield "nothing", heart.take()
    plugin = load_plugin(interface)
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
    plugin.unload()
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


def measure_growth(folder: Path, count: int, rounds: int) -> None:
    from semref.ui.sample_project import DATABASE_FILE

    interface = make_window()
    images = label_images(folder, count)
    database = str(folder / DATABASE_FILE)
    print("| after | widgets | items on the canvas | layers | resident memory (MiB) |")
    print("|---|---:|---:|---:|---:|")
    print_counts(interface, "nothing yet")
    for number in range(1, rounds + 1):
        plugin, dock = load_plugin(interface), open_dock(interface)
        dock.prepare(database, "", images[:1])
        localize(dock)
        show(dock, 0)
        dock.inspect_window("1440_1120")
        turn_events(lambda: dock.content.inspect.numbers.rowCount() > 0)
        plugin.unload()
        del plugin, dock
        settle()
        if number in {1, 2, 5, 10, 15, 20} or number % 20 == 0:
            print_counts(interface, f"{number} × loaded, used and unloaded")
    plugin, dock = load_plugin(interface), open_dock(interface)
    dock.prepare(database, "", images)
    localize(dock)
    settle()
    print_counts(interface, f"{count} images localized in one dock")
    for number in range(1, count + 1):
        show(dock, number - 1)
        if number in {1, 10, 50} or number % 50 == 0:
            print_counts(interface, f"{number} of them shown")
    plugin.unload()
    settle()
    print_counts(interface, "the dock unloaded")
    print(flush=True)


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


def print_counts(interface, after: str) -> None:
    from qgis.core import QgsProject
    from qgis.PyQt.QtWidgets import QApplication

    gc.collect()
    items = len(interface.canvas.scene().items())
    widgets, layers = len(QApplication.allWidgets()), len(QgsProject.instance().mapLayers())
    print(f"| {after} | {widgets} | {items} | {layers} | {resident_mib():.0f} |", flush=True)


def resident_mib() -> float:
    pages = int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


if __name__ == "__main__":
    main()
