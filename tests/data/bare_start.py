"""Start the plugin and print errors as JSON; tests/qgis/test_bare_start.py runs this with bare/ on PYTHONPATH.

A module that cannot be imported is listed with the chain of imports that led to it.
"""

import importlib
import json
import os
import pkgutil
import sys
import tempfile
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ASKS_FIRST = {"semref.ui.sample_project"}
"""Modules imported by menu entries, which check for packages first."""

errors = []


def note(kind, error, trace):
    frames = [frame for frame in traceback.extract_tb(trace) if frame.filename.startswith(str(ROOT))]
    chain = " → ".join(f"{Path(frame.filename).relative_to(ROOT)}:{frame.lineno}" for frame in frames)
    errors.append(f"{kind.__name__}: {error} ({chain})")


def import_all():
    """Import each module separately, so that a failure does not hide the next one."""
    import semref.ui

    names = [module.name for module in pkgutil.walk_packages(semref.ui.__path__, "semref.ui.", onerror=print)]
    for name in ["semref.plugin", "semref.processing.provider", *names]:
        try:
            if name not in ASKS_FIRST:
                importlib.import_module(name)
        except ImportError as error:
            note(type(error), error, error.__traceback__)


def refusals(algorithm):
    """Return the messages of the toolbox, of a parameter check and of a run; empty if it can run."""
    from qgis.core import (
        QgsProcessingContext,
        QgsProcessingException,
        QgsProcessingFeedback,
        QgsProcessingModelAlgorithm,
    )

    possible, reason = algorithm.canExecute()
    if possible or isinstance(algorithm, QgsProcessingModelAlgorithm):
        # QGIS itself checks the parameters of a model.
        return [reason] if reason else []
    context, feedback = QgsProcessingContext(), QgsProcessingFeedback(False)
    run = algorithm.create()
    told = [reason, run.checkParameterValues({}, context)[1]]
    run.prepare({}, context, feedback)
    try:
        run.runPrepared({}, context, feedback)
    except QgsProcessingException as error:
        told.append(str(error))
    return told


def classified():
    """Return how many of two polygons, a building and a lake, get a class."""
    import processing
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    layer = QgsVectorLayer("Polygon?crs=EPSG:32632&field=building:string&field=natural:string", "osm", "memory")
    for columns in (["yes", None], [None, "water"]):
        feature = QgsFeature(layer.fields())
        feature.setAttributes(columns)
        feature.setGeometry(QgsGeometry.fromWkt("POLYGON((0 0, 9 0, 9 9, 0 0))"))
        layer.dataProvider().addFeature(feature)
    return processing.run("semref:classifyopenstreetmap", {"INPUT": layer, "OUTPUT": "memory:"})["FEATURE_COUNT"]


def started():
    from qgis.core import QgsApplication
    from qgis.PyQt.QtCore import QCoreApplication
    from stand_in_interface import InterfaceStandIn

    from semref.plugin import SemRefPlugin

    iface = InterfaceStandIn()
    iface.window.show()
    plugin = SemRefPlugin(iface)
    plugin.initGui()
    for action in (*iface.tool_bar_actions, *iface.menu_actions[1:]):
        action.trigger()
        QCoreApplication.processEvents()
    dock = iface.docks[0]
    algorithms = QgsApplication.processingRegistry().providerById("semref").algorithms()
    seen = {
        "notice": dock.notice.sentence.text() if dock.notice.isVisible() else "",
        "bar": [item.text() for item in iface.bar.items()],
        "refusals": {algorithm.name(): refusals(algorithm) for algorithm in algorithms},
    }
    seen["classified"] = classified()
    dock.notice.install.click()
    seen["options"] = iface.options_pages_shown
    page = iface.options_factories[0].createWidget(None)
    page.show()
    QCoreApplication.processEvents()
    page.close()
    plugin.unload()
    return seen


def main():
    sys.excepthook = note
    # Python puts the script's folder first; its modules must not replace those of the plugin or QGIS.
    sys.path[:] = [*sys.path[1:], sys.path[0], str(ROOT / "tools")]
    os.environ["QGIS_CUSTOM_CONFIG_PATH"] = tempfile.mkdtemp()
    from qgis.core import QgsApplication

    application = QgsApplication([], True)
    application.initQgis()
    sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
    from processing.core.Processing import Processing
    from qgis.PyQt.QtGui import QDesktopServices

    Processing.initialize()
    QDesktopServices.openUrl = lambda address: True
    from plugin_package import load_plugin_package

    load_plugin_package()
    before = set(sys.modules)
    for name in ("plugin", "processing.provider", "ui.entry"):
        importlib.import_module(f"semref.{name}")
    loads_numpy = "numpy" in set(sys.modules) - before
    import_all()
    seen = {} if errors else started()
    print(json.dumps({"errors": errors, "loads_numpy": loads_numpy, **seen}), flush=True)
    # Other tests check how QGIS quits.
    os._exit(0)


main()
