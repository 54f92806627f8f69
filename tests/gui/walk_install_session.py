"""Runs inside desktop QGIS (--code) with a bare profile: installs the zip, asks for help, makes the sample, finds it.

SEMREF_ZIP and SEMREF_SAMPLE name the zip and an empty folder. Writes what it saw, with clicks and seconds, as JSON.
"""

import os
import socket
import time
from pathlib import Path

import pyplugin_installer
import qgis.utils
from pyplugin_installer import installer_data
from pyplugin_installer.installer_data import plugins
from qgis.core import QgsProject, QgsSettings
from qgis.PyQt.QtCore import QObject, pyqtSlot
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QAction, QDialogButtonBox
from walking import start, wait_until


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


class SystemIn:
    """In place of QLocale: of a system in this language, which QGIS 3.22 asks instead of its own settings."""

    def __init__(self, language):
        self._language = language

    def system(self):
        return self

    def name(self):
        return self._language


def told_by_the_plugin_manager(language):
    installer_data.QLocale = SystemIn(language)
    QgsSettings().setValue("locale/overrideFlag", True)
    QgsSettings().setValue("locale/userLocale", language)
    plugins.getAllInstalled()
    plugins.rebuild()
    QgsSettings().setValue("locale/overrideFlag", False)
    return {key: plugins.all()["semref"][key] for key in ("description", "about", "changelog", "version_installed")}


def asked_for_help(browser):
    """Menu, dock, an algorithm's dialog: one click each."""
    import processing

    action("SemRefHelpAction").trigger()
    dock = qgis.utils.plugins["semref"]._entry._dock
    dock.content.help.click()
    dialog = processing.createAlgorithmDialog("semref:builddatabase", {})
    dialog.show()
    dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Help).click()
    dialog.close()
    dialog.deleteLater()
    return list(browser.opened)


def made_sample():
    qgis.utils.plugins["semref"]._entry._sample_project().make(Path(os.environ["SEMREF_SAMPLE"]))
    dock = qgis.utils.plugins["semref"]._entry._dock
    wait_until(lambda: QgsProject.instance().fileName() and dock.content.localize.images.paths(), "the sample")


def localized():
    tab = qgis.utils.plugins["semref"]._entry._dock.content.localize
    tab.localize_button.click()
    wait_until(lambda: not tab.run.running, "the localization")
    return tab.results.table.model().rowCount()


def timed(function, *arguments):
    begun = time.monotonic()
    return function(*arguments), round(time.monotonic() - begun, 1)


def session():
    qgis.utils.iface.mainWindow().resize(1280, 900)
    seen = {"was_there": "semref" in qgis.utils.available_plugins, "reached": can_reach_anything()}
    browser = Browser()
    _, install_s = timed(pyplugin_installer.instance().installFromZipFile, os.environ["SEMREF_ZIP"])
    seen["active"] = "semref" in qgis.utils.active_plugins
    seen["manager"] = {language: told_by_the_plugin_manager(language) for language in ("en_US", "de", "zh-Hans")}
    action("SemRefDockAction").trigger()
    seen["help"] = asked_for_help(browser)
    _, sample_s = timed(made_sample)
    seen["rows"], localize_s = timed(localized)
    seen["seconds"] = {"install": install_s, "sample": sample_s, "localize": localize_s}
    return seen


start(session)
