"""Copy the data of raster layers that worker threads need, in the layers' thread; CRS and pixel size of a file."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsPalettedRasterRenderer,
    QgsPointXY,
    QgsRasterLayer,
)

from ...core.errors import ImageError, LabelMapError, SemRefError
from ...core.geometry.frame import MapFrame
from ...core.labels.class_table import LandCoverClass
from ...storage.images import GdalImage
from ...storage.label_maps import GdalLabels, RasterFile, require_map_grid
from ...storage.rasters import open_raster
from ..compat import is_metric, wkt_for_gdal
from .reference_systems import describe_crs, ellipsoidal_measure, is_true_to_scale


@dataclass(frozen=True)
class RasterLayer:
    """Data of a raster layer: GDAL's source, CRS, and the classes of its style, if any."""

    path: str
    crs: QgsCoordinateReferenceSystem
    styled_classes: tuple[LandCoverClass, ...]

    @property
    def file(self) -> RasterFile:
        """The same data without QGIS's types."""
        return RasterFile(self.path, wkt_for_gdal(self.crs), is_metric(self.crs), self.styled_classes)


def raster_layer(layer: QgsRasterLayer | None, is_label_map: bool = False) -> RasterLayer:
    """Copy the data of the layer of an image or a label map. Raises ImageError."""
    if layer is None or not layer.isValid():
        if is_label_map:
            raise ImageError("The label map can't be read. Choose a raster file.")
        raise ImageError("The image can't be read. Choose a photo or an orthophoto.")
    if layer.providerType() != "gdal":
        raise ImageError(
            "“{layer}” is not a local raster file, but a layer of {provider}. Save it as GeoTIFF first.",
            layer=layer.name(),
            provider=layer.providerType(),
        )
    return RasterLayer(layer.source(), layer.crs(), _styled_classes(layer))


def _styled_classes(layer: QgsRasterLayer) -> tuple[LandCoverClass, ...]:
    renderer = layer.renderer()
    if not isinstance(renderer, QgsPalettedRasterRenderer):
        return ()
    found: dict[int, LandCoverClass] = {}
    for entry in renderer.classes():
        value = int(entry.value)
        # 0 is always unlabeled. Labels may repeat in automatic palettes.
        if 0 < value <= 255:
            found[value] = LandCoverClass(value, entry.label or str(value), entry.color.name())
    names = [c.name for c in found.values()]
    # Without names the palette may list all 256 values; the pixel values then give the classes.
    is_named = any(c.name != str(c.value) for c in found.values())
    return tuple(found.values()) if is_named and len(set(names)) == len(names) else ()


def require_one_crs(reference: RasterLayer, predicted: RasterLayer) -> None:
    """Raise LabelMapError for two maps in different CRS; a map without CRS is assumed to have the other's."""
    if reference.crs.isValid() and predicted.crs.isValid() and reference.crs != predicted.crs:
        raise LabelMapError(
            "The reference map is in {crs}, but the predicted map in {predicted_crs}. Warp one map to the CRS of the "
            "other.",
            crs=describe_crs(reference.crs),
            predicted_crs=describe_crs(predicted.crs),
        )


def map_frame(labels: GdalLabels, layer: RasterLayer) -> MapFrame:
    """Return the grid of a label map. Raises LabelMapError unless it is metric and north up with square pixels."""
    if not layer.crs.isValid():
        raise LabelMapError(
            "{path} has no coordinate reference system. Assign a metric CRS to the layer.", path=layer.path
        )
    if not is_metric(layer.crs):
        raise LabelMapError(
            "{path} is in {crs}, which is not in meters. Rasterize or warp it to a projected CRS in meters.",
            path=layer.path,
            crs=describe_crs(layer.crs),
        )
    transform = labels.dataset.GetGeoTransform(can_return_null=True)
    require_map_grid(transform, layer.path)
    return MapFrame(wkt_for_gdal(layer.crs), tuple(transform), labels.shape_hw)


def stated_crs(path: str) -> QgsCoordinateReferenceSystem:
    """Return the CRS in a raster file; invalid without one."""
    return QgsCoordinateReferenceSystem.fromWkt(open_raster(path).GetProjection())


def pixel_size_m(image: GdalImage, crs: QgsCoordinateReferenceSystem) -> tuple[float, float] | None:
    """Return the ground size of a pixel along a row and a column, m, in the center; None without georeference."""
    transform = image.geotransform
    if transform is None or not crs.isValid():
        return None
    x0, dx_column, dx_row, y0, dy_column, dy_row = transform
    height, width = image.shape_hw
    x = x0 + dx_column * width / 2 + dx_row * height / 2
    y = y0 + dy_column * width / 2 + dy_row * height / 2
    middle, context = QgsPointXY(x, y), QgsCoordinateTransformContext()
    if is_true_to_scale(crs, middle, context):
        return hypot(dx_column, dy_column), hypot(dx_row, dy_row)
    measure = ellipsoidal_measure(crs, context)
    along_row = measure.measureLine(middle, QgsPointXY(x + dx_column, y + dy_column))
    return along_row, measure.measureLine(middle, QgsPointXY(x + dx_row, y + dy_row))


def stated_pixel_size_m(path: str) -> tuple[float, float] | None:
    """Return ``pixel_size_m`` of a file; None also for an unreadable file, which later reading reports."""
    try:
        crs = stated_crs(path)
        return pixel_size_m(GdalImage(path), crs) if crs.isValid() else None
    except SemRefError:
        return None
