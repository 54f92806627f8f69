"""Results of semref:localizeimages and semref:localizeflight, as the dock shows them."""

from __future__ import annotations

import os
from dataclasses import dataclass

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY, QgsVectorLayer

from ..core.localization import Method, Status
from ..processing.compat import is_null
from ..processing.jobs.image_results import LABELS_SUFFIX, unique_names
from ..processing.layers.localized_image import ERROR
from ..processing.layers.results_file import open_results
from ..processing.messages.sentences import error_probability
from ..processing.translation import tr

Point = tuple[float, float]

BY_FLIGHT = "flight"
"""Value of the column ``source``: the flight gives the position, not the image itself."""


@dataclass(frozen=True)
class MatchPoints:
    """Matched landmarks of an image and of the map; all three tuples have the same length and order.

    Attributes:
        pixels: (column, row) in the image.
        seen: Map (x, y) of the image's landmarks, computed with the position.
        on_map: Map (x, y) of the map's landmarks.
    """

    pixels: tuple[Point, ...]
    seen: tuple[Point, ...]
    on_map: tuple[Point, ...]


@dataclass(frozen=True)
class Finding:
    """One image's row of OUTPUT, with its polygons of FOOTPRINTS and ALTERNATIVES; None where there is no value.

    docs/reference/file_formats.md#positions describes the columns.
    """

    image: str
    status: str
    x: float | None
    y: float | None
    longitude: float | None
    latitude: float | None
    heading: float | None
    pixel_size: float | None
    confidence: float | None
    distance: float | None
    references: int | None
    inliers: int | None
    error_95: float | None
    window: str | None
    method: str | None
    reason: str | None
    search_capped: bool | None
    source: str | None
    track: int | None
    outvoted: bool | None
    camera: str | None
    jump: bool | None
    gps_distance: float | None
    crs: QgsCoordinateReferenceSystem
    outline: QgsGeometry | None
    possible: tuple[QgsGeometry, ...] = ()
    matches: MatchPoints | None = None
    labels: str = ""

    @property
    def name(self) -> str:
        """File name of the image."""
        return os.path.basename(self.image)

    @property
    def is_verified(self) -> bool:
        """Whether the method verifies its position; the published method always returns the nearest window."""
        return self.method != Method.TOPOLOGY_VECTOR

    @property
    def is_by_flight(self) -> bool:
        """Whether the flight gives the position, because the image has no matching position of its own."""
        return self.source == BY_FLIGHT

    @property
    def speaks_against(self) -> str:
        """Evidence against the position in a few words; empty without any. ``reason`` has the details."""
        if self.center is None:
            return ""
        if self.gps_distance is not None:
            return tr("contradicts GPS")
        return tr("too far from other images") if self.jump else ""

    @property
    def is_likely(self) -> bool:
        """Whether it is a likely position: shown, but not certain enough for a position."""
        return self.status == Status.LIKELY

    @property
    def is_by_vector(self) -> bool:
        """Whether the published method matched the image with a window."""
        return self.status == Status.FIX and not self.is_verified and not self.track

    @property
    def probability(self) -> float | None:
        """Probability that a verified or likely position is right; None without one."""
        return self.confidence if self.status in (Status.FIX, Status.LIKELY) and self.is_verified else None

    @property
    def corners(self) -> tuple[Point, ...] | None:
        """Map (x, y) of the footprint's corners, clockwise from the image's upper left; None without a heading."""
        if self.center is None or self.heading is None or self.outline is None:
            return None
        return tuple((point.x(), point.y()) for point in self.outline.asPolygon()[0][:4])

    @property
    def center(self) -> QgsPointXY | None:
        """Position in ``crs``; None without one."""
        return None if self.x is None or self.y is None else QgsPointXY(self.x, self.y)


_COLUMNS = tuple(
    name for name in Finding.__dataclass_fields__ if name not in ("crs", "outline", "possible", "matches", "labels")
)


def read_findings(file: str, labels: str = "") -> list[Finding]:
    """Return the findings of a results file in the order of the images.

    Args:
        labels: Folder LABELS of the run; empty without one.

    Raises:
        ParameterError: The file has no results.
    """
    positions, footprints, places, match_points, _track = open_results(file)
    outlines = {f["image"]: f.geometry() for f in footprints.getFeatures()} if footprints is not None else {}
    possible: dict[str, list[QgsGeometry]] = {}
    for feature in places.getFeatures() if places is not None else ():
        possible.setdefault(feature["image"], []).append(feature.geometry())
    matches = _read_matches(match_points)
    indexes = [positions.fields().lookupField(name) for name in _COLUMNS]
    rows = [feature.attributes() for feature in positions.getFeatures()]
    files = unique_names([row[indexes[0]] for row in rows], LABELS_SUFFIX) if labels else {}
    findings = []
    for values in rows:
        # Results of an older version lack the newest columns.
        cells = [None if index < 0 or is_null(values[index]) else values[index] for index in indexes]
        image = cells[0]
        label_image = os.path.join(labels, files[image]) if files else ""
        findings.append(
            Finding(
                *cells,
                positions.crs(),
                outlines.get(image),
                tuple(possible.get(image, ())),
                matches.get(image),
                label_image if os.path.exists(label_image) else "",
            )
        )
    return findings


def _read_matches(layer: QgsVectorLayer | None) -> dict[str, MatchPoints]:
    found: dict[str, list[tuple]] = {}
    for feature in layer.getFeatures() if layer is not None else ():
        place = feature.geometry().asPoint()
        pixel, seen = (feature["image_column"], feature["image_row"]), (feature["seen_x"], feature["seen_y"])
        found.setdefault(feature["image"], []).append((pixel, seen, (place.x(), place.y())))
    return {image: MatchPoints(*zip(*rows)) for image, rows in found.items()}


def lat_lon_text(finding: Finding, decimals: int = 7) -> str:
    """Return latitude and longitude with a decimal point in every language, as programs read them; empty if unknown.

    The latitude is first, as in EPSG:4326, web maps, and QGIS's locator bar. Seven decimals of a degree are about 1 cm,
    five are about 1 m.
    """
    if finding.longitude is None or finding.latitude is None:
        return ""
    return f"{finding.latitude:.{decimals}f}, {finding.longitude:.{decimals}f}"


def x_y_text(finding: Finding) -> str:
    """Return the position in the CRS of the database."""
    return f"{finding.x:.2f}, {finding.y:.2f}"


def error_text(finding: Finding) -> str:
    """Return the error probability in words, such as "below 1 in 10,000"; empty where it is unknown."""
    return "" if finding.probability is None else error_probability(finding.probability)


def status_text(finding: Finding) -> str:
    """Return the status in words, with evidence against it. An unknown status of a newer version stays as it is."""
    return ", ".join(filter(None, (_status_alone(finding), finding.speaks_against)))


def _status_alone(finding: Finding) -> str:
    if finding.status == Status.FIX and finding.is_by_flight:
        return (
            tr("Position from the flight, own position rejected")
            if finding.outvoted
            else tr("Position from the flight")
        )
    if finding.status == Status.FIX and not finding.is_verified:
        return tr("Unverified match")
    if finding.status == ERROR:
        return tr("Unreadable")
    titles = {
        Status.FIX.key: tr("Position"),
        Status.LIKELY.key: tr("Likely position"),
        Status.AMBIGUOUS.key: tr("No position: ambiguous"),
        Status.NO_MATCH.key: tr("No position: no match"),
        Status.TOO_FEW_REFERENCES.key: tr("No position: too few landmarks"),
    }
    return titles.get(finding.status, finding.status)
