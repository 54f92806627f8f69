"""Estimate the epochs of training within a time limit for the current values of *Train model*."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingUtils,
    QgsProject,
    QgsRasterLayer,
)

from ...processing.base.training_estimate import epochs_within
from ...processing.compat import is_metric
from ...processing.layers.reference_systems import metric_crs, transformed_box
from ...processing.translation import tr
from ...training.job import LITE0, SMALL

TRAINING_VALUES = ("IMAGE", "INPUT", "LABELS", "RESOLUTION", "VALIDATION_FRACTION", "NETWORK")
"""Parameters other than the time limit that the number of epochs depends on."""

ENOUGH = 5
"""Fewer epochs give a poor network."""


def epochs_text(minutes: float, values: dict[str, Any]) -> str:
    """Return a sentence with the number of epochs; empty without an image or a limit."""
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    image = _layer(values.get("IMAGE"), context)
    if not minutes or not isinstance(image, QgsRasterLayer) or not image.crs().isValid():
        return ""
    labels = _layer(values.get("INPUT") or values.get("LABELS"), context)
    shape = _shape(image, labels, values.get("RESOLUTION"))
    if shape is None:
        return ""
    fraction = values.get("VALIDATION_FRACTION")
    encoder = SMALL if values.get("NETWORK") == 1 else LITE0
    found = epochs_within(minutes, shape, 0.2 if fraction is None else float(fraction), encoder)
    if found < 1:
        return tr("The time limit is too short for one epoch. Choose a longer time or a coarser resolution.")
    if found < ENOUGH:
        text = tr(
            "Epochs within the time limit: about {count}. For a better model, choose a longer time or a "
            "coarser resolution."
        )
        return text.format(count=int(found))
    return tr("Epochs within the time limit on this computer: about {count}").format(count=int(found))


def _layer(value: Any, context: QgsProcessingContext) -> QgsMapLayer | None:
    if isinstance(value, QgsProcessingFeatureSourceDefinition):
        value = value.source.staticValue()
    return QgsProcessingUtils.mapLayerFromString(value, context) if isinstance(value, str) and value else None


def _shape(image: QgsRasterLayer, labels: QgsMapLayer | None, resolution_cm: Any) -> tuple[int, int] | None:
    """Return (height, width) in pixels of the area that image and labels share; None if it is unknown."""
    context = QgsProject.instance().transformContext()
    crs = image.crs()
    if not is_metric(crs):
        crs = metric_crs(crs, QgsCoordinateReferenceSystem(), image.extent(), context)
    ground = transformed_box(QgsCoordinateTransform(image.crs(), crs, context), image.extent())
    pixel = float(resolution_cm) / 100 if resolution_cm else ground.width() / max(image.width(), 1)
    if labels is not None and labels.crs().isValid():
        ground = ground.intersect(transformed_box(QgsCoordinateTransform(labels.crs(), crs, context), labels.extent()))
    if ground.isEmpty() or pixel <= 0:
        return None
    return max(1, round(ground.height() / pixel)), max(1, round(ground.width() / pixel))
