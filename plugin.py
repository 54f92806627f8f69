"""Plugin class that QGIS loads: adds the Processing provider and the dock, and removes them."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QLocale, QTranslator

from .processing.packages.components import add_components_to_path
from .processing.provider import register_provider

_TRANSLATIONS = Path(__file__).resolve().parent / "i18n"


class SemRefPlugin:
    """``unload`` undoes ``initProcessing`` and ``initGui`` in reverse order."""

    def __init__(self, iface) -> None:
        self._iface = iface
        self._translator = None
        self._provider = None
        self._entry = None

    def initProcessing(self) -> None:
        add_components_to_path()
        self._translator = _install_translator()
        self._provider = register_provider(QgsApplication.processingRegistry())

    def initGui(self) -> None:
        self.initProcessing()
        try:
            # qgis_process never calls this method, so widgets are imported only here.
            from .ui.entry import DockEntry

            self._entry = DockEntry(self._iface)
        except Exception:
            # QGIS discards a plugin that fails here, together with the Python part of its registered provider.
            self.unload()
            raise

    def unload(self) -> None:
        if self._entry is not None:
            self._entry.remove()
            self._entry = None
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None
        if self._translator is not None:
            QCoreApplication.removeTranslator(self._translator)
            self._translator = None


def _install_translator():
    """Install and return the translation for QGIS's language; None without one."""
    settings = QgsSettings()
    overridden = settings.value("locale/overrideFlag", False, type=bool)
    # Desktop QGIS states its language, also that of the option --lang; qgis_process does not.
    locale = QgsApplication.instance().translation()
    if not locale and overridden:
        locale = settings.value("locale/userLocale", "", type=str)
    translator = QTranslator()
    if not translator.load(QLocale(locale) if locale else QLocale.system(), "semref", "_", str(_TRANSLATIONS), ".qm"):
        return None
    QCoreApplication.installTranslator(translator)
    return translator
