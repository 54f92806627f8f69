"""What is written of a CRS without QGIS is what QGIS writes of the same file."""

from __future__ import annotations

import numpy as np
import pytest
from made_inputs import spatial_reference
from osgeo import gdal, gdal_array, osr
from qgis.core import QgsRasterLayer

from semref.processing.compat import wkt_for_gdal
from semref.storage.crs_text import crs_wkt

WKT2 = ["FORMAT=WKT2_2019"]


def raster(path, driver, srs):
    """A raster of a CRS; no file is found where a driver could not write it."""
    memory = gdal_array.OpenArray(np.ones((8, 8), np.uint8))
    memory.SetGeoTransform((500000, 1, 0, 5200000, 0, -1))
    memory.SetSpatialRef(srs)
    gdal.GetDriverByName(driver).CreateCopy(str(path), memory).FlushCache()
    return path


def without_code(code):
    text = spatial_reference(code).ExportToWkt(WKT2)
    return spatial_reference(text[: text.rindex(',ID["EPSG"')] + "]")


SPOKEN = {
    "by code": spatial_reference,
    "in the words of ESRI": lambda code: spatial_reference(spatial_reference(code).ExportToWkt(["FORMAT=WKT1_ESRI"])),
    "without its code": without_code,
}


@pytest.mark.parametrize("driver", ["GTiff", "PNG", "HFA"])
@pytest.mark.parametrize("spoken", SPOKEN)
@pytest.mark.parametrize("code", [32632, 25832, 2056, 3857, 2193, 27700])
def test_a_crs_is_worded_as_qgis_words_it(qgis_app, tmp_path, code, spoken, driver):
    path = raster(tmp_path / "a.img", driver, SPOKEN[spoken](code))
    found = gdal.Open(str(path)).GetSpatialRef()
    layer = QgsRasterLayer(str(path), "a")
    assert layer.crs().isValid() and found is not None
    assert crs_wkt(found) == wkt_for_gdal(layer.crs())


def test_one_of_no_catalogue_stays_what_the_file_says(qgis_app, tmp_path):
    own = osr.SpatialReference()
    own.ImportFromProj4("+proj=tmerc +lat_0=47.2 +lon_0=9.51 +k=1 +x_0=0 +y_0=0 +ellps=GRS80 +units=m +no_defs")
    path = raster(tmp_path / "a.tif", "GTiff", own)
    text = crs_wkt(gdal.Open(str(path)).GetSpatialRef())
    assert "9.51" in text and osr.SpatialReference(text).IsSame(own)
    assert text == wkt_for_gdal(QgsRasterLayer(str(path), "a").crs())


def test_one_that_says_another_code_than_it_is_stays_what_it_says():
    """Such as a grid of one's own that was made of a catalogue's."""
    text = spatial_reference(32632).ExportToWkt(WKT2).replace("500000", "400000")
    found = spatial_reference(text)
    assert found.GetAuthorityCode(None) == "32632"
    assert "400000" in crs_wkt(found)
