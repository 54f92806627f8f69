"""What the user gave to one run of an algorithm, read by key: one reader a kind of value."""

from __future__ import annotations

import math
import os
import re
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsFeatureSink,
    QgsFields,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingFeatureSourceDefinition,
    QgsRasterLayer,
    QgsRectangle,
    QgsVectorLayer,
)

from ...core import limits
from ...core.errors import ParameterError
from ...core.labels.class_table import split_list
from .destinations import Destination, destination_of, replaced_by, with_destination

if TYPE_CHECKING:
    from ...core.labels.class_table import ClassTable
    from ..layers.layer_inputs import RasterLayer

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE | re.ASCII)


class Values:
    """The values of one run, by key; what was left out and is not optional is its default.

    Numbers may come as text, as ``qgis_process`` gives them. Layers are for ``read_layers``, which runs in the
    thread that they live in.
    """

    def __init__(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> None:
        self._algorithm, self._parameters, self.context = algorithm, parameters, context

    @property
    def transform_context(self) -> QgsCoordinateTransformContext:
        """How this project transforms coordinates."""
        return self.context.transformContext()

    def raw(self, key: str) -> Any:
        """The value as it was given; None for none."""
        return self._parameters.get(key)

    def title_and_help(self, key: str) -> tuple[str, str]:
        """What a parameter is called, and what it is, with what the algorithm does; in the user's language."""
        definition = self._algorithm.parameterDefinition(key)
        return definition.description(), f"{definition.help()}\n\n{self._algorithm.shortDescription()}"

    def has(self, key: str) -> bool:
        """Whether a value was given."""
        return self.raw(key) not in (None, "")

    def require_texts(self) -> None:
        """Raises ParameterError for a text with a character 0: Python's files refuse it, C's libraries end there."""
        for key, value in self._parameters.items():
            for part in value if isinstance(value, (list, tuple)) else (value,):
                if isinstance(part, str) and "\0" in part:
                    raise ParameterError(
                        "{key} is “{text}”: a path or text has no character of value 0; remove it.", key=key, text=part
                    )

    def _read(self, kind: str, key: str, *more: Any) -> Any:
        return getattr(self._algorithm, f"parameterAs{kind}")(self._parameters, key, self.context, *more)

    # --- plain values ---

    def number(self, key: str) -> float:
        """A number, its default if it was left out.

        Raises:
            ParameterError: It is NaN or infinity, which QGIS takes, or a text for which QGIS takes the default, or 0.
        """
        given = self.raw(key)
        if isinstance(given, str) and given and not _NUMBER.fullmatch(given.strip()):
            raise ParameterError("{key} is {number}, which is no number; give one.", key=key, number=given)
        return _finite(self._read("Double", key), key)

    def optional_number(self, key: str, default: float | None = None) -> float | None:
        """A number; ``default`` if it was left out."""
        return self.number(key) if self.has(key) else default

    def integer(self, key: str) -> int:
        """A whole number, its default if it was left out."""
        return self._read("Int", key)

    def switch(self, key: str) -> bool:
        """Yes or no."""
        return self._read("Bool", key)

    def choice(self, key: str) -> int:
        """The number of the option that was chosen."""
        return self._read("Enum", key)

    def choices(self, key: str) -> list[int]:
        """The numbers of the options that were chosen."""
        return self._read("Enums", key)

    def range(self, key: str) -> tuple[float, float]:
        """Lowest and highest value. Raises ParameterError as ``number`` does."""
        low, high = self._read("Range", key)
        return _finite(low, key), _finite(high, key)

    def text(self, key: str) -> str:
        """A text; empty if it was left out."""
        return self._read("String", key)

    def parts(self, key: str) -> list[str]:
        """The parts of a list that is given as text, separated by “;”."""
        return split_list(self.text(key))

    def numbers(self, key: str) -> list[float]:
        """The numbers of such a list. Raises ParameterError."""
        try:
            return [float(part.replace(",", ".")) for part in self.parts(key)]
        except ValueError:
            raise ParameterError(
                "{key}: “{text}” is not a list of numbers such as 1;2.",
                key=key,
                text=self.text(key)[: limits.NAME_CHARACTERS],
            ) from None

    # --- places ---

    def point(self, key: str, crs: QgsCoordinateReferenceSystem) -> tuple[float, float] | None:
        """(x, y) in ``crs``; None if it was left out."""
        if not self.has(key):
            return None
        point = self._read("Point", key, crs)
        return _finite(point.x(), key), _finite(point.y(), key)

    def extent(self, key: str, crs: QgsCoordinateReferenceSystem) -> QgsRectangle:
        """A rectangle in ``crs``; an empty one if it was left out."""
        return self._read("Extent", key, crs)

    def extent_as_given(self, key: str) -> tuple[QgsRectangle, QgsCoordinateReferenceSystem]:
        """A rectangle and the CRS that it was given in; the project's where none was said."""
        return self._read("Extent", key), self._read("ExtentCrs", key)

    def crs(self, key: str) -> QgsCoordinateReferenceSystem:
        """A CRS; an invalid one if it was left out."""
        return self._read("Crs", key)

    # --- files ---

    def file(self, key: str) -> str:
        """The path of a file; empty if it was left out."""
        return self._read("File", key)

    def files(self, key: str) -> list[str]:
        """Paths, given as a list, as one path, or several separated by “;” as text."""
        value = self.raw(key)
        if isinstance(value, str) and not os.path.exists(value):
            return split_list(value)
        return [path for path in self._read("FileList", key) if path]

    def class_table(self, key: str) -> ClassTable | None:
        """The class table of a CSV; None if it was left out. Raises ClassTableError."""
        from ...storage.text_tables import read_class_table

        path = self.file(key)
        return read_class_table(path) if path else None

    # --- layers ---

    def raster(self, key: str) -> QgsRasterLayer | None:
        """A raster layer; None for one that can't be read. Raises LabelMapError as ``require_pictures`` does."""
        self.require_pictures(key)
        return self._read("RasterLayer", key)

    def require_pictures(self, key: str) -> None:
        """Refuses a file that asks hosts for a raster under the name of a picture, before QGIS opens it."""
        from ...storage.rasters import require_own_pixels

        if isinstance(self.raw(key), str):
            require_own_pixels(self.raw(key))

    def label_map(self, key: str) -> RasterLayer:
        """What worker threads need of a label map's layer. Raises LabelMapError."""
        from ..layers.layer_inputs import label_map_layer

        return label_map_layer(self.raster(key))

    def image(self, key: str) -> RasterLayer:
        """What worker threads need of an image's layer. Raises ImageError."""
        from ..layers.layer_inputs import image_layer

        return image_layer(self.raster(key))

    def vector(self, key: str) -> QgsVectorLayer | None:
        """A vector layer, also where only some of its features are wanted; None for one that can't be read."""
        value = self.raw(key)
        if not isinstance(value, QgsProcessingFeatureSourceDefinition):
            return self._read("VectorLayer", key)
        return self._algorithm.parameterAsVectorLayer({key: value.source}, key, self.context)

    def source(self, key: str, layer_of_file: str = "") -> QgsProcessingFeatureSource | None:
        """The features that are wanted of a layer; None if it was left out. Raises ParameterError.

        ``layer_of_file``: which layer is meant where the bare path of a file is given that has it.
        """
        source = self._read("Source", key)
        path = self.raw(key)
        if layer_of_file and isinstance(path, str) and os.path.isfile(path):
            layer = {key: f"{path}|layername={layer_of_file}"}
            source = self._algorithm.parameterAsSource(layer, key, self.context) or source
        if source is None and self.has(key):
            raise ParameterError("{reason}", reason=self._algorithm.invalidSourceError(self._parameters, key))
        return source

    # --- where outputs go: for ``Outputs`` ---

    def target(self, key: str) -> str:
        """The path of a file to write; empty for one that is not wanted."""
        return self._read("FileOutput", key)

    def raster_target(self, key: str) -> str:
        """The path of a raster to write."""
        return self._read("OutputLayer", key)

    def replaces(self, key: str) -> tuple[str, tuple[str, ...] | None]:
        """Usual suffix and tables of the older files that an output replaces, see ``require_replaceable``."""
        return replaced_by(self._algorithm.parameterDefinition(key))

    def destination(self, key: str) -> Destination:
        """Where a layer goes."""
        return destination_of(self.raw(key), self.context)

    def sink(
        self, key: str, target: str, fields: QgsFields, geometry: Any, crs: QgsCoordinateReferenceSystem, flags: Any
    ) -> tuple[QgsFeatureSink | None, str]:
        """Opens a sink; ``target``: where it really writes, empty for where the user said.

        Returns:
            The sink, None for one that is not wanted or can't be made; where it writes to.
        """
        parameters = {**self._parameters, key: with_destination(self.raw(key), target)} if target else self._parameters
        return self._algorithm.parameterAsSink(parameters, key, self.context, fields, geometry, crs, flags)


def _finite(number: float, key: str) -> float:
    if not math.isfinite(number):
        raise ParameterError("{key} is {number}, which is no number; give one.", key=key, number=str(number))
    return number
