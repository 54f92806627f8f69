"""Runs inside desktop QGIS (--code) with a bare profile and without the packages that SemRef asks for.

Installs the zip, opens the dock, every menu entry and every algorithm; installs the packages with the button where
SEMREF_HAS_WHEELS is set, asks for help, makes the sample and localizes it. SEMREF_ZIP and SEMREF_SAMPLE name the zip
and an empty folder, SEMREF_PICTURES a folder for pictures of the screen. Writes what it saw, with seconds, as JSON.
"""

import importlib.util
import os
import socket
import time
from pathlib import Path

import pyplugin_installer
import qgis.utils
from qgis.core import QgsApplication, QgsProject
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSlot
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QAction, QApplication, QDialogButtonBox, QTabWidget
from walking import dock, settle, start, wait_until

MODAL_AFTER_MS = 500


class Browser(QObject):
    """In place of the system's: keeps the addresses that it was to open."""

    def __init__(self):
        super().__init__()
        self.opened = []
        for scheme in ("file", "https", "http"):
            QDesktopServices.setUrlHandler(scheme, self, "open")

    @pyqtSlot("QUrl")
    def open(self, address):
        self.opened.append(address.toString())


def action(name):
    return qgis.utils.iface.mainWindow().findChild(QAction, name)


def can_reach_anything():
    try:
        socket.create_connection(("192.0.2.1", 80), timeout=2).close()
    except OSError as error:
        return not isinstance(error, TimeoutError) and "unreachable" not in str(error)
    return True


def picture(name):
    settle()
    file = os.path.join(os.environ["SEMREF_PICTURES"], f"{name}.png")
    QApplication.primaryScreen().grabWindow(0).save(file)


def menu_entries():
    (menu,) = [one.menu() for one in qgis.utils.iface.pluginMenu().actions() if one.text() == "SemRef"]
    return menu.actions()


def tried_menu():
    """Each entry once; the dock stays open."""
    for entry in menu_entries():
        entry.trigger()
        settle()
    if not dock().isVisible():
        action("SemRefDockAction").trigger()
        settle()
    return [entry.text() for entry in menu_entries()], [item.text() for item in qgis.utils.iface.messageBar().items()]


def in_modal(do):
    """Does something with the dialog that is about to come up and closes it; the list gets what came of it."""
    came = []

    def go_on():
        dialog = QApplication.activeModalWidget()
        try:
            came.append(do(dialog))
        finally:
            dialog.reject()

    QTimer.singleShot(MODAL_AFTER_MS, go_on)
    return came


def opened_dialogs():
    """Every algorithm's own dialog opens, and the toolbox says what one lacks."""
    import processing

    names = [one.name() for one in QgsApplication.processingRegistry().providerById("semref").algorithms()]
    for name in names:
        dialog = processing.createAlgorithmDialog(f"semref:{name}", {})
        dialog.show()
        settle(0.1)
        dialog.close()
        dialog.deleteLater()
    toolbox = qgis.utils.plugins["processing"].toolbox
    toolbox.show()
    toolbox.searchBox.setText("builddatabase")
    settle()

    def read(dialog):
        picture("toolbox")
        return dialog.txtMessage.toPlainText()

    shown = in_modal(read)
    toolbox.executeAlgorithm()
    toolbox.hide()
    return {"opened": len(names), "shown": shown[0]}


def installed_packages():
    """By the notice's button and the page's."""
    from semref.ui.packages.components_page import ComponentsPage

    def press(dialog):
        page = dialog.findChild(ComponentsPage)
        picture("options")
        page.install.click()
        wait_until(lambda: not page._installer.running, "the packages")
        picture("options_installed")
        return page.state.text(), page.log.toPlainText()

    said = in_modal(press)
    dock().notice.install.click()
    settle(1.0)
    return said[0]


def asked_for_help(browser):
    """Menu, dock, an algorithm's dialog: one click each."""
    import processing

    browser.opened.clear()
    action("SemRefHelpAction").trigger()
    dock().content.help.click()
    dialog = processing.createAlgorithmDialog("semref:builddatabase", {})
    dialog.show()
    dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Help).click()
    dialog.close()
    dialog.deleteLater()
    return list(browser.opened)


def made_sample():
    qgis.utils.plugins["semref"]._entry._sample_project().make(Path(os.environ["SEMREF_SAMPLE"]))
    wait_until(lambda: QgsProject.instance().fileName() and dock().content.localize.images.paths(), "the sample")


def localized():
    tab = dock().content.localize
    tab.localize_button.click()
    wait_until(lambda: not tab.run.running, "the localization")
    settle(3.0)
    picture("first_fix")
    return tab.results.list.count()


def timed(function, *arguments):
    begun = time.monotonic()
    return function(*arguments), round(time.monotonic() - begun, 1)


def session():
    logged = []
    QgsApplication.messageLog().messageReceived[str, str, "Qgis::MessageLevel"].connect(
        lambda *message: logged.append(message)
    )
    qgis.utils.iface.mainWindow().resize(1280, 900)
    seen = {"was_there": "semref" in qgis.utils.available_plugins, "reached": can_reach_anything()}
    seen["found"] = [name for name in ("cv2", "PIL", "shapely", "onnxruntime") if importlib.util.find_spec(name)]
    browser, seconds = Browser(), {}
    _, seconds["install"] = timed(pyplugin_installer.instance().installFromZipFile, os.environ["SEMREF_ZIP"])
    seen["active"] = "semref" in qgis.utils.active_plugins
    action("SemRefDockAction").trigger()
    settle(1.0)
    seen["notice"] = dock().notice.sentence.text() if dock().notice.isVisible() else ""
    picture("notice")
    seen["menu"], seen["bar"] = tried_menu()
    seen["dialogs"] = opened_dialogs()
    if os.environ.get("SEMREF_HAS_WHEELS"):
        seen["packages"], seconds["packages"] = timed(installed_packages)
        seen["left"] = [item.text() for item in qgis.utils.iface.messageBar().items()]
        seen["filled"] = dock().findChild(QTabWidget) is not None and not dock().notice.isVisible()
        picture("installed")
        seen["help"] = asked_for_help(browser)
        _, seconds["sample"] = timed(made_sample)
        seen["rows"], seconds["localize"] = timed(localized)
    errors = [text for text, tag, _level in logged if "Traceback" in text or tag == "Python Error"]
    return {**seen, "seconds": seconds, "errors": errors}


start(session)
