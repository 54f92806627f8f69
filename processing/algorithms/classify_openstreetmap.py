"""semref:classifyopenstreetmap: convert polygons and lines with OpenStreetMap tags to land cover."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import (
    QgsGeometry,
    QgsProcessingFeatureSource,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterString,
    QgsWkbTypes,
)

from ...core import limits
from ...core.errors import ParameterError
from ...core.labels.class_table import class_table_from_names
from ...core.labels.openstreetmap import Rule, Rules, tags_of
from ...core.values import schema
from ...storage.gdal_errors import gdal_failures
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, each
from ..base.outputs import FeatureSink, Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import (
    LINE_GEOMETRY,
    MULTI_POLYGON,
    POINT_GEOMETRY,
    POLYGON_GEOMETRY,
    SOURCE_LINE,
    SOURCE_POLYGON,
    is_null,
)
from ..translation import tr

if TYPE_CHECKING:
    Area = tuple[QgsGeometry | None, dict[str, object] | None]
    """Polygons of a feature and their attributes by FIELDS; None for what is left out."""

RULES_PATH = Path(__file__).resolve().parents[2] / "resources" / "openstreetmap" / "rules.csv"
POLYGONS_OF_OSM, LINES_OF_OSM = "multipolygons", "lines"
"""Layers with areas and with lines in GDAL's reader of OpenStreetMap extracts."""

FIELDS = schema("class text, priority integer, tag text, osm_id text, name text")
ID_COLUMNS = ("osm_id", "osm_way_id", "id", "full_id")
LEFT_OUT = ""
"""Counts features without a class or without an area."""


class ClassifyOpenStreetMap(SemRefAlgorithm):
    ID = "classifyopenstreetmap"
    TITLE = "Classify OpenStreetMap"
    GROUP = ANNOTATION
    TAGS = ("osm", "openstreetmap", "tags", "pbf", "quickosm", "geofabrik", "overture", "land cover", "classes")
    PACKAGES = ()
    SUMMARY = (
        "Converts polygons with OpenStreetMap tags to land cover: building, water, bare land, forest, cultivated "
        "land, grass and built-up land. Roads, railways, rivers and streams can be added from lines. A priority "
        "decides which polygon is on top.\n\nThe input may be an extract (.osm, .osm.pbf), a QuickOSM layer, a "
        "Geofabrik shapefile, or a layer with tags in columns. A table of rules assigns classes to tags."
    )

    LINES = "LINES"
    RULES = "RULES"
    OTHER_CLASS = "OTHER_CLASS"
    FEATURE_COUNT = "FEATURE_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterFeatureSource(self.INPUT, "OpenStreetMap polygons", types=[SOURCE_POLYGON]),
                "Layer with tags as columns, or an OpenStreetMap extract. Of an extract, the areas are used.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.LINES, "OpenStreetMap lines", types=[SOURCE_LINE], optional=True
                ),
                "Layer of lines with tags as columns, or the extract. Roads and railways get the class road, "
                "rivers and streams the class water. The tags width and lanes give the width, otherwise the rules. "
                "Tunnels are left out.",
            ),
            with_help(
                QgsProcessingParameterFile(self.RULES, "Rules", fileFilter=tr("CSV files (*.csv)"), optional=True),
                "CSV file with the columns key, value, class, priority, and width (m) for lines. The value * matches "
                "any value; an empty class excludes polygons and lines. If not set, the rules of SemRef are used.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterString(self.OTHER_CLASS, "Class of other polygons", optional=True),
                "Class of polygons that no rule matches, for example of building outlines without tags. If empty, "
                "these polygons are left out.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Land cover", type=SOURCE_POLYGON),
                "Polygons with a class, with the fields class, priority, tag, osm_id and name.",
            ),
            QgsProcessingOutputNumber(self.FEATURE_COUNT, "Number of polygons with a class"),
        )

    def read_layers(self, values: Values) -> None:
        self._source = values.source(self.INPUT, POLYGONS_OF_OSM)
        self._lines = values.source(self.LINES, LINES_OF_OSM)
        for source, kind in ((self._source, POLYGON_GEOMETRY), (self._lines, LINE_GEOMETRY)):
            others = {POINT_GEOMETRY, LINE_GEOMETRY, POLYGON_GEOMETRY} - {kind}
            if source is not None and QgsWkbTypes.geometryType(source.wkbType()) in others:
                raise ParameterError(
                    "“{layer}” has {kind} geometry. Choose a polygon layer."
                    if kind == POLYGON_GEOMETRY
                    else "“{layer}” has {kind} geometry. Choose a layer of lines.",
                    layer=source.sourceName(),
                    kind=QgsWkbTypes.displayString(source.wkbType()),
                )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...storage.text_tables import read_rules
        from ..layers.class_styles import annotation_renderer

        rules = read_rules(values.file(self.RULES) or str(RULES_PATH))
        other = values.text(self.OTHER_CLASS).strip()
        if len(other) > limits.NAME_CHARACTERS:
            raise ParameterError(
                "“{key}” has more than {most} characters. Enter a shorter name.",
                key=values.title(self.OTHER_CLASS),
                most=limits.NAME_CHARACTERS,
            )
        names = (*rules.classes, other) if other and other not in rules.classes else rules.classes
        renderer = annotation_renderer(class_table_from_names(names), "class", "priority")
        crs = self._source.sourceCrs()
        with outputs.layer(self.OUTPUT, FIELDS, MULTI_POLYGON, crs, renderer=renderer, is_own=False) as sink:
            counts = _write(sink, self._polygons(rules, other, feedback))
            if not any(counts):
                raise ParameterError(
                    "No rule matches a tag of “{source}”. Its columns are: {columns}. Select a layer with "
                    "OpenStreetMap tags or other rules, or enter a class of other polygons.",
                    source=self._source.sourceName(),
                    columns=self._source.fields().names(),
                )
            of_lines = _write(sink, self._areas_of_lines(rules.for_lines, values, feedback))
            if self._lines is not None and not any(of_lines):
                raise ParameterError(
                    "No rule with a width matches a tag of the lines “{source}”. Their columns are: {columns}. Select "
                    "a layer of lines with OpenStreetMap tags, or other rules.",
                    source=self._lines.sourceName(),
                    columns=self._lines.fields().names(),
                )
        counts += of_lines
        left_out = counts.pop(LEFT_OUT, 0)
        for name, count in counts.most_common():
            feedback.pushInfo(tr("{name}: {count} polygons").format(name=name, count=count))
        feedback.pushInfo(tr("Left out, because they have no class or no area: {count}").format(count=left_out))
        return {self.FEATURE_COUNT: sum(counts.values())}

    def _polygons(self, rules: Rules, other: str, feedback: QgsProcessingFeedback) -> Iterator[Area]:
        for geometry, columns in _features(self._source, feedback):
            yield polygons_of(geometry), row_of(columns, rules.of(tags_of(columns)), other)

    def _areas_of_lines(self, rules: Rules, values: Values, feedback: QgsProcessingFeedback) -> Iterator[Area]:
        from ..layers.line_areas import LineAreas
        from ..layers.reference_systems import require_crs

        if self._lines is None:
            return
        lines, target = self._lines, self._source.sourceCrs()
        require_crs(target, self._source.sourceName())
        areas = LineAreas(lines.sourceName(), lines.sourceCrs(), lines.sourceExtent(), target, values.transform_context)
        for geometry, columns in _features(lines, feedback):
            rule, area = areas.of(geometry, tags_of(columns), rules)
            yield area and polygons_of(area), row_of(columns, rule, "")


def _features(
    source: QgsProcessingFeatureSource, feedback: QgsProcessingFeedback
) -> Iterator[tuple[QgsGeometry, dict[str, object]]]:
    """Yield the geometry of each feature and its values by column, without NULL.

    Raises ParameterError where a file ends early: QGIS would use what it read as if it were complete.
    """
    names = source.fields().names()
    with gdal_failures() as failures:
        for feature in each(source.getFeatures(), feedback, source.featureCount()):
            values = zip(names, feature.attributes())
            yield feature.geometry(), {name: value for name, value in values if not is_null(value)}
    if failures:
        raise ParameterError(
            "“{source}” cannot be read completely: {reason}. Copy or download it again.",
            source=source.sourceName(),
            reason=failures[0],
        )


def _write(sink: FeatureSink, areas: Iterator[Area]) -> Counter[str]:
    """Write areas and count them by class; those without a polygon or a class count as LEFT_OUT."""
    counts: Counter[str] = Counter()
    for geometry, row in areas:
        if geometry is None or row is None:
            counts[LEFT_OUT] += 1
            continue
        counts[row["class"]] += 1
        sink.add(geometry, row)
    return counts


def row_of(columns: dict[str, object], rule: Rule | None, other: str) -> dict[str, object] | None:
    """Return the attributes of a land-cover polygon, by FIELDS; None for one that is left out.

    ``columns``: values by column; ``other``: the class where no rule matches, or empty.
    """
    name = other if rule is None else rule.class_name
    if not name:
        return None
    return {
        "class": name,
        "priority": 0 if rule is None else rule.priority,
        "tag": "" if rule is None else rule.tag,
        "osm_id": next((str(columns[column]) for column in ID_COLUMNS if column in columns), None),
        "name": columns.get("name"),
    }


def polygons_of(geometry: QgsGeometry) -> QgsGeometry | None:
    """Return the polygons of a geometry as a multipolygon without heights; None without polygons."""
    if geometry.isNull() or geometry.isEmpty() or geometry.type() != POLYGON_GEOMETRY:
        return None
    geometry.convertToStraightSegment()
    geometry.convertToMultiType()
    geometry.get().dropZValue()
    geometry.get().dropMValue()
    return geometry
