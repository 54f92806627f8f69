"""Everything of SemRef that has a face in QGIS, to be looked at: tabs of the dock, dialogs, lists, layers' styles."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QApplication, QMenu, QScrollArea
from screenshot_scenes import (
    CORRECT,
    INSPECT,
    INSPECTED_WINDOW,
    LOCALIZE,
    NARROW,
    TALL,
    checked_with_mistakes,
    localized,
    localized_flight,
    toolbox,
)
from screenshot_window import DOCK_WIDTH, WINDOW, Session, settle, wait_until

PHOTOS = 4
DIALOG = 900, 860
LONGEST_DIALOG = 2400

OUTPUTS = "outputs"
"""Folder in the sample's of layers that look_outputs.py made there."""


def tabs(session: Session) -> None:
    """Each tab of the dock, before anything was done and with results, as wide as usual and as narrow as it gets."""
    for tab, name in ((LOCALIZE, "localize"), (INSPECT, "inspect"), (CORRECT, "correct")):
        session.show_tab(tab)
        session.resize(WINDOW[0], TALL)
        grab(session, f"tab_{name}_0_empty", session.dock)
    issues = with_issues(session)
    images = session.dock.content.localize.images
    # As many as it takes to see a list.
    images.list.show_only(images.paths()[:PHOTOS])
    for width, kind in ((DOCK_WIDTH, "tab"), (NARROW, "narrow"), (760, "wide")):
        session.resize(WINDOW[0], TALL, width)
        localized(session)
        grab(session, f"{kind}_localize", session.dock)
        session.dock.inspect_window(INSPECTED_WINDOW)
        wait_until(lambda: session.dock.content.inspect._window is not None, "the inspected window")
        grab(session, f"{kind}_inspect", session.dock)
        session.show_tab(CORRECT)
        tab = session.dock.content.correct
        tab.layer.setLayer(issues)
        tab.mend.setChecked(True)
        wait_until(lambda: tab.places.rowCount() > 1, "the list of issues")
        settle(1.0)
        tab.places.selectRow(1)
        grab(session, f"{kind}_correct", session.dock)
    session.resize(*WINDOW)


def flight(session: Session) -> None:
    """The first tab with a flight in it."""
    session.resize(WINDOW[0], TALL, 500)
    with localized_flight(session) as tab:
        tab.results.table.selectRow(3)
        grab(session, "tab_localize_flight", session.dock)
    session.resize(*WINDOW)


def window(session: Session) -> None:
    """The whole window, with results, issues and the toolbox."""
    localized(session)
    session.take("window_localize")
    session.show_tab(CORRECT)
    session.show_everything()
    session.take("window_correct")
    toolbox(session)


def menus(session: Session) -> None:
    """The plugin's menu."""
    found = [menu for menu in session.window.findChildren(QMenu) if menu.title().replace("&", "") == "SemRef"]
    for menu in found:
        menu.ensurePolished()
        menu.adjustSize()
        save(session, "menu", menu.grab())


def dialogs(session: Session) -> None:
    """The dialog of each algorithm and model, whole, with all that is folded unfolded."""
    import processing

    for algorithm in QgsApplication.processingRegistry().providerById("semref").algorithms():
        dialog = processing.createAlgorithmDialog(algorithm.id(), {})
        dialog.setGeometry(0, 0, *DIALOG)
        dialog.show()
        settle(0.2)
        for box in dialog.findChildren(QgsCollapsibleGroupBox):
            box.setCollapsed(False)
        settle(0.1)
        areas = [area for area in dialog.findChildren(QScrollArea) if area.widget() is not None]
        missing = max([area.widget().height() - area.viewport().height() for area in areas], default=0)
        dialog.setGeometry(0, 0, DIALOG[0], min(LONGEST_DIALOG, DIALOG[1] + max(0, missing)))
        grab(session, f"dialog_{algorithm.name()}", dialog)
        dialog.close()
        dialog.deleteLater()


def windows(session: Session) -> None:
    """SemRef's own windows: models, class table, options."""
    from semref.processing.inspection.class_tables import preset_rows
    from semref.ui.class_table.editor import ClassTableEditor
    from semref.ui.models.model_list import ModelsDialog

    for made, name in ((ModelsDialog(), "window_models"), (ClassTableEditor(preset_rows(0)), "window_class_table")):
        made.show()
        grab(session, name, made)
        made.close()
        made.deleteLater()

    def take() -> None:
        dialog = QApplication.activeModalWidget()
        dialog.setGeometry(0, 0, 980, 900)
        grab(session, "window_options", dialog)
        dialog.close()

    QTimer.singleShot(1500, take)
    session.iface.showOptionsDialog(session.window, "SemRefOptions")


def layers(session: Session) -> None:
    """Each output on the map, alone over the label map, as its file says that it looks."""
    project = QgsProject.instance()
    folder = Path(session.job["sample"]) / OUTPUTS
    session.dock.hide()
    for path in sorted(folder.iterdir()):
        found = opened(path)
        if not found:
            continue
        for layer in found:
            project.addMapLayer(layer, False)
            project.layerTreeRoot().insertLayer(0, layer)
            node = project.layerTreeRoot().findLayer(layer)
            node.setExpanded(True)
        session.iface.mapCanvas().setExtent(
            session.iface.mapCanvas()
            .mapSettings()
            .layerExtentToOutputExtent(found[0], found[0].extent().buffered(0.05 * found[0].extent().width()))
        )
        session.iface.mapCanvas().refresh()
        session.take(f"layer_{path.stem}")
        project.removeMapLayers([layer.id() for layer in found])


def opened(path: Path) -> list:
    """The layers of a file with their default styles; none of what is no layer."""
    if path.suffix in (".tif", ".png"):
        return [layer for layer in [QgsRasterLayer(str(path), path.stem)] if layer.isValid()]
    if path.suffix != ".gpkg":
        return []
    whole = QgsVectorLayer(str(path), path.stem, "ogr")
    names = [text.split("!!::!!")[1] for text in whole.dataProvider().subLayers()] or [""]
    kept = [name for name in names if name in ("references", "windows")] or names[:1]
    return [
        QgsVectorLayer(f"{path}|layername={name}" if name else str(path), name or path.stem, "ogr")
        for name in reversed(kept)
    ]


def with_issues(session: Session) -> QgsVectorLayer:
    issues = checked_with_mistakes(session)
    issues.setName("Issues")
    QgsProject.instance().addMapLayer(issues, False)
    QgsProject.instance().layerTreeRoot().insertLayer(0, issues)
    return issues


def grab(session: Session, name: str, widget) -> None:
    """A picture of a widget as it paints itself, however large it is."""
    settle(0.4)
    session.iface.messageBar().clearWidgets()
    save(session, name, widget.grab())


def save(session: Session, name: str, picture) -> None:
    file = Path(session.job["pictures"]) / f"{name}{session.suffix}.png"
    if picture.isNull() or not picture.save(str(file)):
        raise RuntimeError(f"{file} could not be written")
    session.taken.append(file.name)
