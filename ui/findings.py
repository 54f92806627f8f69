"""Results of semref:localizeimages as the dock shows them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Dict, List, NamedTuple, Optional, Tuple

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY, QgsVectorLayer

from ..processing.compat import is_null
from ..processing.translation import tr

if TYPE_CHECKING:
    import numpy as np

FIX = "fix"
"""The one status with a position."""

TOPOLOGY_VECTOR = "topology vector"
"""Name of the published method in the column ``method``."""

RUNNERS_UP = 4
"""Windows shown after the best one of the published method."""


@dataclass(frozen=True)
class Hit:
    """What a finding tells of where an image lies.

    footprint: four map (x, y) that its corners show, upper left first, clockwise; None without a heading.
    by_vector: whether it was matched with a window by the published method.
    """

    image: str
    footprint: Optional[Tuple[Tuple[float, float], ...]] = None
    heading_deg: float = 0.0
    pixel_size_m: float = 0.0
    by_vector: bool = False


@dataclass(frozen=True)
class Matches:
    """Landmarks of an image and of the map that agree, m of them.

    objects: (m,) of the picture's; seen: (m, 2) map coordinates where the fix puts them; on_map: (m, 2) those of the
    map's landmarks.
    """

    objects: np.ndarray
    seen: np.ndarray
    on_map: np.ndarray


@dataclass(frozen=True)
class RunnersUp:
    """The windows of a database with the nearest vectors after the best one, nearest first, n of them.

    names: (n,) str; distances: (n,) of the vectors; centers: (n, 2) map coordinates; sizes: (n,) map units.
    """

    names: np.ndarray
    distances: np.ndarray
    centers: np.ndarray
    sizes: np.ndarray


@dataclass(frozen=True)
class Finding:
    """One image's row of OUTPUT, with its polygons of FOOTPRINTS and ALTERNATIVES; None where there is nothing.

    Columns are told in docs/file-formats.md#positions.
    """

    image: str
    status: str
    x: Optional[float]
    y: Optional[float]
    longitude: Optional[float]
    latitude: Optional[float]
    heading: Optional[float]
    pixel_size: Optional[float]
    confidence: Optional[float]
    distance: Optional[float]
    references: Optional[int]
    inliers: Optional[int]
    error_95: Optional[float]
    window: Optional[str]
    method: Optional[str]
    reason: Optional[str]
    crs: QgsCoordinateReferenceSystem
    outline: Optional[QgsGeometry]
    possible: Tuple[QgsGeometry, ...] = ()

    @property
    def name(self) -> str:
        """Of the image's file."""
        return os.path.basename(self.image)

    @property
    def is_verified(self) -> bool:
        """Whether the method checks its own fix; the published one takes the nearest window, whatever it is."""
        return self.method != TOPOLOGY_VECTOR

    @property
    def hit(self) -> Hit:
        """What the image view needs of it."""
        by_vector = self.status == FIX and not self.is_verified
        if self.center is None or self.heading is None or self.outline is None:
            return Hit(self.image, by_vector=by_vector)
        return Hit(self.image, corners_of(self.outline), self.heading, self.pixel_size)

    @property
    def center(self) -> Optional[QgsPointXY]:
        """In ``crs``; None without a fix."""
        return None if self.x is None or self.y is None else QgsPointXY(self.x, self.y)


def corners_of(outline: QgsGeometry) -> tuple:
    """(x, y) of a footprint's four corners, the image's upper left first, clockwise."""
    return tuple((point.x(), point.y()) for point in outline.asPolygon()[0][:4])


_COLUMNS = tuple(name for name in Finding.__dataclass_fields__ if name not in ("crs", "outline", "possible"))


class ResultLayers(NamedTuple):
    """OUTPUT, FOOTPRINTS and ALTERNATIVES of semref:localizeimages; None for what there is not."""

    positions: Optional[QgsVectorLayer] = None
    footprints: Optional[QgsVectorLayer] = None
    places: Optional[QgsVectorLayer] = None


def read_findings(layers: ResultLayers) -> List[Finding]:
    """The findings in the order of the images; none without positions."""
    positions, footprints, places = layers
    if positions is None:
        return []
    outlines = {f["image"]: f.geometry() for f in footprints.getFeatures()} if footprints is not None else {}
    possible: Dict[str, List[QgsGeometry]] = {}
    for feature in places.getFeatures() if places is not None else ():
        possible.setdefault(feature["image"], []).append(feature.geometry())
    indexes = [positions.fields().lookupField(name) for name in _COLUMNS]
    crs, findings = positions.crs(), []
    for feature in positions.getFeatures():
        values = feature.attributes()
        cells = [None if is_null(values[index]) else values[index] for index in indexes]
        image = cells[0]
        findings.append(Finding(*cells, crs, outlines.get(image), tuple(possible.get(image, ()))))
    return findings


def status_text(finding: Finding) -> str:
    """An image's status in words; a status this version does not know stands for itself."""
    if finding.status == FIX and not finding.is_verified:
        return tr("Unverified match")
    texts = {
        FIX: tr("Fix"),
        "ambiguous": tr("Ambiguous"),
        "no_match": tr("No match"),
        "too_few_references": tr("Too few landmarks"),
        "error": tr("Unreadable"),
    }
    return texts.get(finding.status, finding.status)
