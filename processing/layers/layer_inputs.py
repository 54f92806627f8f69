"""Raster layers: what worker threads need of them, taken out in the thread they live in."""

from __future__ import annotations

from dataclasses import dataclass

from qgis.core import QgsCoordinateReferenceSystem, QgsPalettedRasterRenderer, QgsRasterLayer

from ...core.errors import ImageError, LabelMapError, SemRefError
from ...core.geometry.frame import MapFrame
from ...core.labels.class_table import LandCoverClass
from ...core.sentences import Sentence
from ...storage.label_maps import GdalLabels, RasterFile, require_map_grid
from ..compat import is_metric, wkt_for_gdal
from .reference_systems import describe_crs


@dataclass(frozen=True)
class RasterLayer:
    """A raster layer as the main thread knows it: GDAL's source, CRS, and the classes of its style, if any."""

    path: str
    crs: QgsCoordinateReferenceSystem
    styled_classes: tuple[LandCoverClass, ...]

    @property
    def file(self) -> RasterFile:
        """The same for rooms without QGIS."""
        return RasterFile(self.path, wkt_for_gdal(self.crs), is_metric(self.crs), self.styled_classes)


def label_map_layer(layer: QgsRasterLayer | None, name: str) -> RasterLayer:
    """Takes what is needed out of a layer. Raises LabelMapError."""
    return _taken(layer, LabelMapError("{key} is not a raster that can be read; choose a label map.", key=name))


def image_layer(layer: QgsRasterLayer | None, name: str) -> RasterLayer:
    """Takes what is needed out of a layer. Raises ImageError."""
    return _taken(
        layer, ImageError("{key} is not a raster that can be read; choose a photo or an orthophoto.", key=name)
    )


def _taken(layer: QgsRasterLayer | None, unreadable: SemRefError) -> RasterLayer:
    if layer is None or not layer.isValid():
        raise unreadable
    if layer.providerType() != "gdal":
        raise type(unreadable)(
            Sentence(
                "“{layer}” comes from {provider}; save it as GeoTIFF first.",
                layer=layer.name(),
                provider=layer.providerType(),
            )
        )
    return RasterLayer(layer.source(), layer.crs(), _styled_classes(layer))


def _styled_classes(layer: QgsRasterLayer) -> tuple[LandCoverClass, ...]:
    renderer = layer.renderer()
    if not isinstance(renderer, QgsPalettedRasterRenderer):
        return ()
    found: dict[int, LandCoverClass] = {}
    for entry in renderer.classes():
        value = int(entry.value)
        # 0 is unlabeled whatever the palette calls it; labels repeat in palettes that were made automatically.
        if 0 < value <= 255:
            found[value] = LandCoverClass(value, entry.label or str(value), entry.color.name())
    names = [c.name for c in found.values()]
    # A color table has all 256 values, of which a map uses a few: where no class has a name, the pixels tell.
    is_named = any(c.name != str(c.value) for c in found.values())
    return tuple(found.values()) if is_named and len(set(names)) == len(names) else ()


def require_one_crs(reference: RasterLayer, predicted: RasterLayer) -> None:
    """Raises LabelMapError for two maps in different CRS; a map without one is taken to have the other's."""
    if reference.crs.isValid() and predicted.crs.isValid() and reference.crs != predicted.crs:
        raise LabelMapError(
            "REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS.",
            crs=describe_crs(reference.crs),
            predicted_crs=describe_crs(predicted.crs),
        )


def map_frame(labels: GdalLabels, layer: RasterLayer) -> MapFrame:
    """CRS and geotransform of a label map; raises LabelMapError unless metric, north up, with square pixels."""
    if not layer.crs.isValid():
        raise LabelMapError(
            "{path} has no coordinate reference system; assign a metric one to the layer.", path=layer.path
        )
    if not is_metric(layer.crs):
        raise LabelMapError(
            "{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters.",
            path=layer.path,
            crs=describe_crs(layer.crs),
        )
    transform = labels.dataset.GetGeoTransform(can_return_null=True)
    require_map_grid(transform, layer.path)
    return MapFrame(wkt_for_gdal(layer.crs), tuple(transform), labels.shape_hw)
