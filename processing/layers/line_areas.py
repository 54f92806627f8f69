"""Areas of lines with OpenStreetMap tags: roads, railways and streams of a known width."""

from __future__ import annotations

from collections.abc import Mapping

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsGeometry,
    QgsRectangle,
)

from ...core.labels.openstreetmap import Rule, Rules, line_width_m
from ..compat import FLAT_CAP, LINE_GEOMETRY, ROUND_JOIN
from .reference_systems import require_crs, utm_zone

_SEGMENTS = 4
"""Of a quarter circle at a bend."""


class LineAreas:
    """Makes areas of the lines of one layer, measured in its UTM zone, in the CRS of a polygon layer."""

    def __init__(
        self,
        name: str,
        crs: QgsCoordinateReferenceSystem,
        extent: QgsRectangle,
        target: QgsCoordinateReferenceSystem,
        context: QgsCoordinateTransformContext,
    ) -> None:
        """Choose the UTM zone for ``extent`` of the lines. Raises ParameterError for lines without a CRS."""
        require_crs(crs, name)
        metric = utm_zone(crs, extent, context)
        self._to_metric = QgsCoordinateTransform(crs, metric, context)
        self._to_target = QgsCoordinateTransform(metric, target, context)

    def of(
        self, geometry: QgsGeometry, tags: Mapping[str, str], rules: Rules
    ) -> tuple[Rule | None, QgsGeometry | None]:
        """Return the rule of a line and the area along it.

        Args:
            geometry: Of the feature; it is changed.
            tags: Value by key.
            rules: Those for lines.

        Returns:
            None without a rule; None without a class or a line, or if the line can't be transformed.
        """
        rule = rules.of(tags)
        if rule is None or not rule.class_name or geometry.isNull() or geometry.type() != LINE_GEOMETRY:
            return rule, None
        try:
            geometry.transform(self._to_metric)
            area = geometry.buffer(line_width_m(tags, rule) / 2, _SEGMENTS, FLAT_CAP, ROUND_JOIN, 2.0)
            area.transform(self._to_target)
        except QgsCsException:
            return rule, None
        return rule, area
