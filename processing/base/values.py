"""The values of one run of an algorithm, read by key."""

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
    QgsProcessingOutputLayerDefinition,
    QgsRasterLayer,
    QgsRectangle,
    QgsVectorLayer,
)

from ...core import limits
from ...core.errors import ClassTableError, ParameterError
from ...core.labels.class_colors import is_usual_landmark
from ...core.labels.class_table import ClassTable, split_list
from ..compat import NO_GEOMETRY_CHECK
from .destinations import Destination, destination_of, replaced_by, with_destination

if TYPE_CHECKING:
    from ..layers.layer_inputs import RasterLayer

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE | re.ASCII)


class Values:
    """The values of one run, by key; a missing value that is not optional has its default.

    Numbers may be text, as ``qgis_process`` gives them. Layers may be read only in ``read_layers``, in their thread.
    """

    def __init__(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> None:
        self._algorithm, self.context = algorithm, context
        # QGIS's batch dialog gives an output that is left empty as a definition without a destination.
        outputs = {key: one for key, one in parameters.items() if isinstance(one, QgsProcessingOutputLayerDefinition)}
        empty = (key for key, output in outputs.items() if output.sink.staticValue() == "")
        self._parameters = {**parameters, **dict.fromkeys(empty)}

    @property
    def transform_context(self) -> QgsCoordinateTransformContext:
        return self.context.transformContext()

    def raw(self, key: str) -> Any:
        """Return the unchanged value; None if it is not set."""
        return self._parameters.get(key)

    def title(self, key: str) -> str:
        """Return the title of a parameter in the user's language; the key if it has none."""
        definition = self._algorithm.parameterDefinition(key)
        return (definition and definition.description()) or key

    def title_and_help(self, key: str) -> tuple[str, str]:
        """Return the title of a parameter, and its help with the summary of the algorithm, in the user's language."""
        definition = self._algorithm.parameterDefinition(key)
        return definition.description(), f"{definition.help()}\n\n{self._algorithm.shortDescription()}"

    def has(self, key: str) -> bool:
        return self.raw(key) not in (None, "")

    def require_texts(self) -> None:
        """Raises ParameterError for a text with a null character: Python's files refuse it, C libraries end there."""
        for key, value in self._parameters.items():
            for part in value if isinstance(value, (list, tuple)) else (value,):
                if isinstance(part, str) and "\0" in part:
                    raise ParameterError(
                        "“{key}” is “{text}”, which contains a null character. Remove this character.",
                        key=self.title(key),
                        text=part,
                    )

    def _read(self, kind: str, key: str, *more: Any) -> Any:
        return getattr(self._algorithm, f"parameterAs{kind}")(self._parameters, key, self.context, *more)

    # --- plain values ---

    def number(self, key: str) -> float:
        """Return a number, or its default.

        Raises:
            ParameterError: It is NaN or infinity, which QGIS accepts, or another text, which QGIS replaces by the
                default or 0.
        """
        given = self.raw(key)
        if isinstance(given, str) and given and not _NUMBER.fullmatch(given.strip()):
            raise _not_a_number(self.title(key), given)
        return _finite(self._read("Double", key), self.title(key))

    def optional_number(self, key: str, default: float | None = None) -> float | None:
        """Return a number; ``default`` if it is not set."""
        return self.number(key) if self.has(key) else default

    def integer(self, key: str) -> int:
        return self._read("Int", key)

    def switch(self, key: str) -> bool:
        return self._read("Bool", key)

    def choice(self, key: str) -> int:
        """Return the number of the selected option."""
        return self._read("Enum", key)

    def choices(self, key: str) -> list[int]:
        """Return the numbers of the selected options."""
        return self._read("Enums", key)

    def range(self, key: str) -> tuple[float, float]:
        """Return (lowest, highest). Raises ParameterError as ``number`` does."""
        low, high = self._read("Range", key)
        return _finite(low, self.title(key)), _finite(high, self.title(key))

    def text(self, key: str) -> str:
        """Return a text; empty if it is not set."""
        return self._read("String", key)

    def parts(self, key: str) -> list[str]:
        """Return the parts of a list in a text, separated by “;”."""
        return split_list(self.text(key))

    def numbers(self, key: str) -> list[float]:
        """Return the numbers of such a list. Raises ParameterError."""
        try:
            return [_finite(float(part.replace(",", ".")), self.title(key)) for part in self.parts(key)]
        except ValueError:
            raise ParameterError(
                "“{key}” is “{text}”, which is not a list of numbers. Separate the numbers by “;”, for example 1;2.",
                key=self.title(key),
                text=self.text(key)[: limits.NAME_CHARACTERS],
            ) from None

    # --- places ---

    def point(self, key: str, crs: QgsCoordinateReferenceSystem) -> tuple[float, float] | None:
        """Return (x, y) in ``crs``; None if it is not set."""
        if not self.has(key):
            return None
        point = self._read("Point", key, crs)
        return _finite(point.x(), self.title(key)), _finite(point.y(), self.title(key))

    def extent(self, key: str, crs: QgsCoordinateReferenceSystem) -> QgsRectangle:
        """Return a rectangle in ``crs``; an empty one if it is not set."""
        return self._read("Extent", key, crs)

    def extent_as_given(self, key: str) -> tuple[QgsRectangle, QgsCoordinateReferenceSystem]:
        """Return a rectangle and its CRS, by default the project's."""
        return self._read("Extent", key), self._read("ExtentCrs", key)

    def crs(self, key: str) -> QgsCoordinateReferenceSystem:
        """Return a CRS; an invalid one if it is not set. Raises ParameterError for an unknown one."""
        crs = self._read("Crs", key)
        if isinstance(self.raw(key), str) and self.has(key) and not crs.isValid():
            raise ParameterError(
                "“{key}” is {text}, which is not a known CRS. Enter a code such as EPSG:25832.",
                key=self.title(key),
                text=self.raw(key),
            )
        return crs

    # --- files ---

    def file(self, key: str) -> str:
        """Return the path of a file; empty if it is not set."""
        return self._read("File", key)

    def files(self, key: str) -> list[str]:
        """Return paths, given as a list, as one path, or as text separated by “;”."""
        value = self.raw(key)
        if isinstance(value, str) and not os.path.exists(value):
            return split_list(value)
        return [path for path in self._read("FileList", key) if path]

    def class_table(self, key: str) -> ClassTable | None:
        """Return the class table of a CSV; None if it is not set. Raises ClassTableError."""
        from ...storage.text_tables import read_class_table

        path = self.file(key)
        return read_class_table(path) if path else None

    def with_references(self, key: str, table: ClassTable, needed: bool = True) -> ClassTable:
        """Return a class table with the classes of a list as landmarks, if the list is set.

        If a landmark is ``needed`` and the table has no role for one, the usual ones are landmarks.

        Raises:
            ParameterError: The table has no such class, or no landmark although one is ``needed``.
        """
        chosen = self.parts(key)
        if needed and not table.references:
            chosen = chosen or [one.name for one in table.classes if is_usual_landmark(one.name)]
        try:
            table = table.with_references(chosen) if chosen else table
            return table.require_references() if needed else table
        except ClassTableError as error:
            raise ParameterError("{where}: {fault}", where=self.title(key), fault=error.sentence) from None

    # --- layers ---

    def raster(self, key: str) -> QgsRasterLayer | None:
        """Return a raster layer; None if it cannot be read. Raises ImageError as ``require_pictures`` does."""
        self.require_pictures(key)
        return self._read("RasterLayer", key)

    def require_pictures(self, key: str) -> None:
        """Refuse a file with the name of a picture that refers to a raster on the network, before QGIS opens it."""
        from ...storage.rasters import require_own_pixels

        if isinstance(self.raw(key), str):
            require_own_pixels(self.raw(key))

    def label_map(self, key: str) -> RasterLayer:
        """Return a label map's layer for worker threads. Raises ImageError."""
        from ..layers.layer_inputs import raster_layer

        return raster_layer(self.raster(key), is_label_map=True)

    def image(self, key: str) -> RasterLayer:
        """Return an image's layer for worker threads. Raises ImageError."""
        from ..layers.layer_inputs import raster_layer

        return raster_layer(self.raster(key))

    def vector(self, key: str) -> QgsVectorLayer | None:
        """Return a vector layer, also if only some of its features are selected; None if it cannot be read."""
        value = self.raw(key)
        if not isinstance(value, QgsProcessingFeatureSourceDefinition):
            return self._read("VectorLayer", key)
        return self._algorithm.parameterAsVectorLayer({key: value.source}, key, self.context)

    def source(self, key: str, layer_of_file: str = "") -> QgsProcessingFeatureSource | None:
        """Return the selected features of a layer, valid or not; None if it is not set. Raises ParameterError.

        ``layer_of_file``: the layer that is read if the value is the path of a file with this layer.
        """
        source = self._read("Source", key)
        path = self.raw(key)
        if layer_of_file and isinstance(path, str) and os.path.isfile(path):
            layer = {key: f"{path}|layername={layer_of_file}"}
            source = self._algorithm.parameterAsSource(layer, key, self.context) or source
        if source is None and self.has(key):
            raise ParameterError("{reason}", reason=self._algorithm.invalidSourceError(self._parameters, key))
        if source is not None:
            source.setInvalidGeometryCheck(NO_GEOMETRY_CHECK)
        return source

    # --- where outputs go: for ``Outputs`` ---

    def target(self, key: str) -> str:
        """Return the path of a file to write; empty if it is not selected."""
        return self._read("FileOutput", key)

    def raster_target(self, key: str) -> str:
        """Return the path of a raster to write."""
        return self._read("OutputLayer", key)

    def replaces(self, key: str) -> tuple[str, tuple[str, ...] | None]:
        """Return the usual suffix and the tables of files that an output may replace, see ``require_replaceable``."""
        return replaced_by(self._algorithm.parameterDefinition(key))

    def destination(self, key: str) -> Destination:
        return destination_of(self.raw(key), self.context)

    def sink(
        self, key: str, target: str, fields: QgsFields, geometry: Any, crs: QgsCoordinateReferenceSystem, flags: Any
    ) -> tuple[QgsFeatureSink | None, str]:
        """Open a sink; ``target``: where it is written until ``commit``, empty for the user's destination.

        Returns:
            The sink, None if it is not selected or cannot be made; its destination.
        """
        parameters = {**self._parameters, key: with_destination(self.raw(key), target)} if target else self._parameters
        return self._algorithm.parameterAsSink(parameters, key, self.context, fields, geometry, crs, flags)


def _finite(number: float, title: str) -> float:
    if not math.isfinite(number):
        raise _not_a_number(title, str(number))
    return number


def _not_a_number(title: str, given: str) -> ParameterError:
    return ParameterError("“{key}” is {number}, which is not a number. Enter a number.", key=title, number=given)
