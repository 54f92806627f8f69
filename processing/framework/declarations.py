"""Parameters and outputs of algorithms as data: key, title, help and what may be given; the base class offers them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from qgis.core import (
    QgsProcessingOutputDefinition,
    QgsProcessingOutputNumber,
    QgsProcessingOutputString,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRange,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
)

from ..compat import SOURCE_FILE, SOURCE_LINE, SOURCE_POINT, SOURCE_POLYGON

WIDGETS: dict[str, str] = {}
"""Classes of widgets by kind, as “package.module.Class”: filled where there are windows, empty elsewhere."""

DATABASE_WIDGET, MODEL_WIDGET, OPEN_WIDGET, CLASS_TABLE_WIDGET = "database", "model", "open", "class table"
CLASS_FIELD_WIDGET, CLASS_NAME_WIDGET = "class field", "class name"
PHOTO_WIDGET, TIME_LIMIT_WIDGET = "photo", "time limit"
"""Kinds of widgets: a file box that offers the databases, or the models, that are at hand; a box ticked in a dialog; a
file box with a button that edits the class table; a box of fields that begins with the likeliest class field; a box for
the name of one class; a box of rasters that begins with the only photo, otherwise empty; a box of minutes that shows
how many epochs fit in."""


@dataclass(frozen=True)
class Parameter:
    """What an algorithm asks for.

    Attributes:
        key: Its public name.
        title: What the dialog calls it, in the user's language.
        help: One or two sentences, in the user's language.
        optional: Whether it may be left out.
        advanced: Whether the dialog folds it away.
        default: The value when nothing is given.
        widget: A kind of ``WIDGETS``; QGIS's own widget where it is empty, or where there is no such widget.
    """

    KIND: ClassVar[type[QgsProcessingParameterDefinition]]

    key: str
    title: str
    help: str
    optional: bool = False
    advanced: bool = False
    default: Any = None
    widget: str = ""

    def definition(self) -> QgsProcessingParameterDefinition:
        """QGIS's own parameter; the caller, ``addParameter``, takes it."""
        made = self.made()
        made.setHelp(self.help)
        if self.advanced:
            made.setFlags(made.flags() | QgsProcessingParameterDefinition.FlagAdvanced)
        if self.widget in WIDGETS:
            made.setMetadata({"widget_wrapper": {"class": WIDGETS[self.widget]}})
        return made

    def made(self) -> QgsProcessingParameterDefinition:
        """QGIS's own parameter without its help."""
        return self.KIND(self.key, self.title, defaultValue=self.default, optional=self.optional)


@dataclass(frozen=True)
class Number(Parameter):
    """A number, or with ``is_integer`` a whole one, from minimum to maximum; ``decimals`` if its box needs more."""

    minimum: float | None = None
    maximum: float | None = None
    is_integer: bool = False
    decimals: int | None = None

    def made(self) -> QgsProcessingParameterNumber:
        """QGIS's own parameter without its help."""
        kind = QgsProcessingParameterNumber.Integer if self.is_integer else QgsProcessingParameterNumber.Double
        made = QgsProcessingParameterNumber(self.key, self.title, kind, self.default, self.optional)
        if self.minimum is not None:
            made.setMinimum(self.minimum)
        if self.maximum is not None:
            made.setMaximum(self.maximum)
        if self.decimals is not None:
            made.setMetadata({"widget_wrapper": {"decimals": self.decimals}})
        return made


@dataclass(frozen=True)
class NumberRange(Parameter):
    """Two numbers, given as “low,high”."""

    def made(self) -> QgsProcessingParameterRange:
        """QGIS's own parameter without its help."""
        kind = QgsProcessingParameterNumber.Double
        return QgsProcessingParameterRange(self.key, self.title, kind, self.default, self.optional)


@dataclass(frozen=True)
class Choice(Parameter):
    """One of ``options``, given by its number; with ``several`` a list of numbers."""

    options: Sequence[str] = ()
    several: bool = False

    def made(self) -> QgsProcessingParameterEnum:
        """QGIS's own parameter without its help."""
        options = list(self.options)
        return QgsProcessingParameterEnum(self.key, self.title, options, self.several, self.default, self.optional)


class Switch(Parameter):
    """Yes or no."""

    KIND = QgsProcessingParameterBoolean


class Text(Parameter):
    """A line of text."""

    KIND = QgsProcessingParameterString


class RasterLayer(Parameter):
    """A raster layer or file."""

    KIND = QgsProcessingParameterRasterLayer


class MapPoint(Parameter):
    """A point on the map."""

    KIND = QgsProcessingParameterPoint


class MapExtent(Parameter):
    """A rectangle on the map."""

    KIND = QgsProcessingParameterExtent


class Crs(Parameter):
    """A coordinate reference system."""

    KIND = QgsProcessingParameterCrs


@dataclass(frozen=True)
class VectorSource(Parameter):
    """Features of a layer; ``kinds``: those of ``compat.SOURCE_…`` that it may have, any without."""

    KIND: ClassVar[type[QgsProcessingParameterDefinition]] = QgsProcessingParameterFeatureSource
    kinds: tuple[Any, ...] = ()

    def made(self) -> QgsProcessingParameterFeatureSource:
        """QGIS's own parameter without its help."""
        return self.KIND(self.key, self.title, list(self.kinds), self.default, self.optional)


@dataclass(frozen=True)
class FieldOf(Parameter):
    """A field of the layer that ``layer_key`` names."""

    layer_key: str = ""

    def made(self) -> QgsProcessingParameterField:
        """QGIS's own parameter without its help."""
        return QgsProcessingParameterField(self.key, self.title, self.default, self.layer_key, optional=self.optional)


@dataclass(frozen=True)
class File(Parameter):
    """A file that is there; ``filter`` as file dialogs have it."""

    filter: str = ""

    def made(self) -> QgsProcessingParameterFile:
        """QGIS's own parameter without its help."""
        return QgsProcessingParameterFile(self.key, self.title, optional=self.optional, fileFilter=self.filter or None)


class Files(Parameter):
    """Files or folders."""

    def made(self) -> QgsProcessingParameterMultipleLayers:
        """QGIS's own parameter without its help."""
        return QgsProcessingParameterMultipleLayers(self.key, self.title, SOURCE_FILE, self.default, self.optional)


@dataclass(frozen=True)
class Output(Parameter):
    """What an algorithm writes; ``by_default``: whether dialogs suggest it when it is optional."""

    by_default: bool = True

    def made(self) -> QgsProcessingParameterDefinition:
        """QGIS's own parameter without its help."""
        return self.KIND(
            self.key,
            self.title,
            defaultValue=self.default,
            optional=self.optional,
            createByDefault=self.by_default,
            **self.more(),
        )

    def more(self) -> dict:
        """Further arguments of KIND, by name."""
        return {}


class RasterOutput(Output):
    """A raster file."""

    KIND = QgsProcessingParameterRasterDestination


class FolderOutput(Output):
    """A folder."""

    KIND = QgsProcessingParameterFolderDestination


@dataclass(frozen=True)
class FileOutput(Output):
    """A file; ``filter`` as file dialogs have it."""

    KIND: ClassVar[type[QgsProcessingParameterDefinition]] = QgsProcessingParameterFileDestination
    filter: str = ""

    @property
    def is_page(self) -> bool:
        """Whether QGIS shows it in its Results Viewer; it goes by the filter as well."""
        return "*.htm" in self.filter

    def more(self) -> dict:
        """Further arguments of KIND, by name."""
        return {"fileFilter": self.filter}


class PointOutput(Output):
    """A layer of points."""

    KIND = QgsProcessingParameterFeatureSink

    def more(self) -> dict:
        """Further arguments of KIND, by name."""
        return {"type": SOURCE_POINT}


class LineOutput(Output):
    """A layer of lines."""

    KIND = QgsProcessingParameterFeatureSink

    def more(self) -> dict:
        """Further arguments of KIND, by name."""
        return {"type": SOURCE_LINE}


class PolygonOutput(Output):
    """A layer of polygons."""

    KIND = QgsProcessingParameterFeatureSink

    def more(self) -> dict:
        """Further arguments of KIND, by name."""
        return {"type": SOURCE_POLYGON}


@dataclass(frozen=True)
class Told:
    """What an algorithm tells beside what it writes."""

    KIND: ClassVar[type]
    key: str
    title: str

    def definition(self) -> QgsProcessingOutputDefinition:
        """QGIS's own output; the caller, ``addOutput``, takes it."""
        return self.KIND(self.key, self.title)


class TextResult(Told):
    """A text."""

    KIND = QgsProcessingOutputString


class NumberResult(Told):
    """A number."""

    KIND = QgsProcessingOutputNumber
