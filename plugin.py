"""What QGIS loads: registers the Processing provider and the dock, and takes both away again."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QLocale, QTranslator

from .processing.packages.components import add_components_to_path
from .processing.provider import register_provider

_TRANSLATIONS = Path(__file__).resolve().parent / "i18n"


class SemRefPlugin:
    """``initProcessing`` and ``initGui`` are undone by ``unload``, in reverse order."""

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
            # Widgets only where there are windows: qgis_process never comes here.
            from .ui.entry import DockEntry

            self._entry = DockEntry(self._iface)
        except Exception:
            # QGIS drops a plugin that fails here, and with it the Python half of a provider still registered.
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
    """The translation for QGIS's language, if there is one."""
    settings = QgsSettings()
    overridden = settings.value("locale/overrideFlag", False, type=bool)
    locale = settings.value("locale/userLocale", "", type=str) if overridden else ""
    translator = QTranslator()
    if not translator.load(QLocale(locale) if locale else QLocale.system(), "semref", "_", str(_TRANSLATIONS), ".qm"):
        return None
    QCoreApplication.installTranslator(translator)
    return translator
