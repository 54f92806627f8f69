"""A photo and its network as they are opened by who asks and by workers, alike."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot

from ..core.errors import ImageError
from ..core.labels.class_table import class_table_from_csv
from ..core.labels.image_source import ImageSource
from ..core.segmentation.model import SegmentationModel
from ..core.segmentation.resampling import at_resolution, resized_transform
from ..core.segmentation.tiling import Tiles, tiles_of
from ..storage.crs_text import crs_wkt
from ..storage.images import GdalImage
from ..storage.rasters import open_raster


@dataclass(frozen=True)
class Opening:
    """What a photo is opened with.

    Attributes:
        image: The photo's path.
        model: The network's path.
        table: A class table's CSV text; empty for none.
        resolution_m: Of a pixel as the network sees it; None for what the network says.
        overlap: Share of a tile that lies on each neighbor; None for what the network says.
        device: What runs the network.
    """

    image: str
    model: str
    table: str
    resolution_m: float | None
    overlap: float | None
    device: str


@dataclass(frozen=True)
class Opened:
    """A photo as the network sees it.

    Attributes:
        model: The network.
        image: The photo at the network's resolution.
        tiles: All of it.
        overlap: Of them.
        geotransform: GDAL's six numbers of ``image``; None without a georeference.
        crs_wkt: Of the ground; empty for none.
    """

    model: SegmentationModel
    image: ImageSource
    tiles: Tiles
    overlap: float
    geotransform: tuple[float, ...] | None
    crs_wkt: str


@lru_cache(1)
def opened(opening: Opening) -> Opened:
    """Opens a photo and its network, with one thread: others have their own photos.

    Raises:
        SemRefError: One of them can't be used.
    """
    table = class_table_from_csv(opening.table, "--class-table") if opening.table else None
    model = SegmentationModel(opening.model, 1, table, opening.device)
    asked, overlap = opening.resolution_m, opening.overlap
    resolution_m = model.settings.resolution_m if asked is None else asked
    overlap = model.settings.overlap if overlap is None else overlap
    photo, srs = GdalImage(opening.image), open_raster(opening.image).GetSpatialRef()
    transform, size_m = photo.geotransform, None
    if transform is not None and srs is not None and resolution_m is not None:
        if not srs.IsProjected() or abs(srs.GetLinearUnits() - 1) > 1e-9:
            raise ImageError("cluster.photo_not_in_meters", path=opening.image, crs=srs.GetName() or "")
        size_m = hypot(transform[1], transform[4]), hypot(transform[2], transform[5])
    image = at_resolution(photo, size_m, resolution_m)
    transform = resized_transform(transform, photo.shape_hw, image.shape_hw)
    wkt = crs_wkt(srs) if srs is not None else ""
    return Opened(model, image, tiles_of(model, image.shape_hw, overlap), overlap, transform, wkt)
