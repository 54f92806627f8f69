"""Replace QGIS's modules by PyQt6, so that parts of ui/ run without QGIS.

``qgis.PyQt`` is PyQt6 with the classes at the places where QGIS has them. Of ``qgis.core`` and ``qgis.gui`` the few
classes that painting needs are Qt's; every other name is a ``StandIn``, good for nothing but being imported.
"""

import importlib
import sys
import types

MODULES = "QtCore", "QtGui", "QtWidgets", "QtNetwork", "QtXml", "sip"

ACTIONS = ("QAction", "QActionGroup", "QShortcut")
"""Qt 6 moved these to QtGui; QGIS still has them in QtWidgets."""


class StandInType(type):
    """Metaclass that provides any missing class name when a module is read."""

    def __getattr__(cls, name: str) -> object:
        if name.startswith("__"):
            raise AttributeError(name)
        return StandIn

    def __or__(cls, other: object) -> type:
        return cls


class StandIn(metaclass=StandInType):
    """Class that is imported, inherited from or named in annotations, but not used."""


def install(profile: str) -> None:
    """Put the modules into ``sys.modules``; ``profile`` is the folder of QGIS's settings."""
    qt = {name: importlib.import_module(f"PyQt6.{name}") for name in MODULES}
    for name in ACTIONS:
        setattr(qt["QtWidgets"], name, getattr(qt["QtGui"], name))
    pyqt = types.ModuleType("qgis.PyQt")
    sys.modules["qgis.PyQt"] = pyqt
    for name, module in qt.items():
        setattr(pyqt, name, module)
        sys.modules[f"qgis.PyQt.{name}"] = module
    utils = module_of("qgis.utils", {"iface": None})
    sys.modules["qgis"] = module_of("qgis", {"PyQt": pyqt, "utils": utils})
    sys.modules["qgis.utils"] = utils
    sys.modules["qgis.core"] = module_of("qgis.core", core_classes(qt, profile))
    sys.modules["qgis.gui"] = module_of("qgis.gui", {"QgsOptionsPageWidget": qt["QtWidgets"].QWidget})
    for name in ("osgeo", "osgeo.gdal", "osgeo.ogr", "osgeo.osr", "processing"):
        sys.modules[name] = module_of(name, {})


def module_of(name: str, classes: dict[str, object]) -> types.ModuleType:
    def __getattr__(asked: str) -> object:
        if asked.startswith("__"):
            raise AttributeError(asked)
        return StandIn

    module = types.ModuleType(name)
    module.__dict__.update(classes, __getattr__=__getattr__, __path__=[])
    return module


def core_classes(qt: dict[str, types.ModuleType], profile: str) -> dict[str, object]:
    style = qt["QtWidgets"].QStyle.StandardPixmap.SP_MessageBoxInformation

    class QgsSettings:
        kept: dict[str, object] = {}

        def value(self, key: str, default: object = None, type: object = None) -> object:
            return self.kept.get(key, default)

        def setValue(self, key: str, value: object) -> None:
            self.kept[key] = value

    class QgsApplication:
        @staticmethod
        def getThemeIcon(name: str) -> object:
            return qt["QtWidgets"].QApplication.style().standardIcon(style)

        @staticmethod
        def qgisSettingsDirPath() -> str:
            return profile

    class Qgis(StandIn):
        QGIS_VERSION_INT = 40000

    return {"Qgis": Qgis, "QgsSettings": QgsSettings, "QgsApplication": QgsApplication}
