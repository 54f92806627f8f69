"""Places of the pixels of an image that is draped on the map."""

import numpy as np
import pytest
from osgeo import gdal, osr

from semref.core.errors import LabelMapError
from semref.core.geometry.footprint import image_corners, on_ground
from semref.core.geometry.leveling import Attitude, leveling
from semref.storage.georeferencing import write_draped

SHAPE_HW = (300, 400)
MIDDLE = np.array([400_000.0, 5_400_000.0])


@pytest.fixture(scope="module")
def photo(tmp_path_factory):
    """Return two bands with the column and the row of each pixel."""
    path = str(tmp_path_factory.mktemp("photo") / "photo.tif")
    height, width = SHAPE_HW
    raster = gdal.GetDriverByName("GTiff").Create(path, width, height, 2, gdal.GDT_UInt16)
    columns, rows = np.meshgrid(np.arange(width), np.arange(height))
    raster.GetRasterBand(1).WriteArray(columns)
    raster.GetRasterBand(2).WriteArray(rows)
    del raster
    return path


def wkt():
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(25832)
    return reference.ExportToWkt()


def footprint_of(roll, pitch, heading=0.0, pixel_m=0.5):
    if roll == pitch == 0:
        return image_corners(tuple(MIDDLE), heading, pixel_m, SHAPE_HW[1], SHAPE_HW[0])
    ground = leveling(Attitude(roll, pitch), 400.0, SHAPE_HW).corners * pixel_m * np.exp(-1j * np.radians(heading))
    return MIDDLE + np.column_stack([ground.real, ground.imag])


@pytest.mark.slow
@pytest.mark.parametrize("attitude", [(0, 0), (0, 10), (12, 20), (-5, -30)])
@pytest.mark.parametrize("heading", [0.0, 200.0])
def test_each_pixel_is_where_a_camera_without_distortion_saw_it(photo, tmp_path, attitude, heading):
    footprint = footprint_of(*attitude, heading)
    target = str(tmp_path / "laid.vrt")
    write_draped(photo, target, wkt(), footprint)
    laid = gdal.Open(target)
    assert laid.RasterCount == 3
    columns, rows, alpha = (laid.GetRasterBand(band).ReadAsArray().astype(float) for band in (1, 2, 3))
    x0, dx, _, y0, _, dy = laid.GetGeoTransform()
    where = np.argwhere(alpha > 0)[::97]
    picked = where[:, 0], where[:, 1]
    seen = np.column_stack([columns[picked], rows[picked]]) + 0.5
    places = np.column_stack([x0 + (where[:, 1] + 0.5) * dx, y0 + (where[:, 0] + 0.5) * dy])
    away = np.hypot(*(on_ground(seen, footprint, SHAPE_HW) - places).T)
    # Nearest neighbor: up to half a pixel's diagonal on the ground; a tilted camera stretches pixels.
    steps = on_ground(seen + (0.5, 0.5), footprint, SHAPE_HW) - on_ground(seen - (0.5, 0.5), footprint, SHAPE_HW)
    others = on_ground(seen + (0.5, -0.5), footprint, SHAPE_HW) - on_ground(seen - (0.5, -0.5), footprint, SHAPE_HW)
    half = np.maximum(np.hypot(*steps.T), np.hypot(*others.T)) / 2
    assert len(where) > 500
    assert (away / half).max() < 1.6


def test_a_missing_image_is_reported(tmp_path):
    with pytest.raises(LabelMapError, match="missing.tif"):
        write_draped(str(tmp_path / "missing.tif"), str(tmp_path / "x.vrt"), wkt(), footprint_of(0, 0))
