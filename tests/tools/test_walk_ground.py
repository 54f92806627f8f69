"""The real place of the timed walk: photos show the ground that their truth tells, beside the orthophoto."""

from __future__ import annotations

import csv
import importlib.util
import sys

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")
gdal = pytest.importorskip("osgeo.gdal")

EDGE = 3000


@pytest.fixture(scope="module")
def tool(repository):
    """tools/docs/walk_ground.py."""
    spec = importlib.util.spec_from_file_location("walk_ground", repository / "tools" / "docs" / "walk_ground.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["walk_ground"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def filled(tool, tmp_path_factory):
    """A made-up place whose colors tell column and row, and the folder that was filled of it."""
    from osgeo import ogr, osr

    data, folder = tmp_path_factory.mktemp("data"), tmp_path_factory.mktemp("ground")
    place = tool.RealPlace("Nowhere", "photo.tif", "houses.gpkg", "Nobody's", {})
    source = gdal.GetDriverByName("GTiff").Create(str(data / place.photo), EDGE, EDGE, 3, gdal.GDT_Byte)
    source.SetGeoTransform((5000.0, 0.5, 0, 9000.0, 0, -0.5))
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(32645)
    source.SetProjection(crs.ExportToWkt())
    slope = np.broadcast_to(np.arange(EDGE) * 255 / EDGE, (EDGE, EDGE))
    source.WriteArray(np.stack([slope, slope.T, np.full_like(slope, 90)]).astype(np.uint8))
    del source
    file = ogr.GetDriverByName("GPKG").CreateDataSource(str(data / place.polygons))
    layer = file.CreateLayer("houses", crs, ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("building", ogr.OFTString))
    for said in ("yes", "school"):
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetField("building", said)
        feature.SetGeometry(ogr.CreateGeometryFromWkt("POLYGON ((5010 8990, 5020 8990, 5020 8980, 5010 8990))"))
        layer.CreateFeature(feature)
    del feature, layer, file
    tool.fill(place, data, folder)
    return place, data, folder


def test_photos_lie_where_their_truth_says_and_beside_the_orthophoto(filled, tool):
    folder = filled[2]
    with (folder / "photos.csv").open(encoding="utf-8", newline="") as file:
        truth = list(csv.DictReader(file))
    assert len(truth) == tool.COUNT == len(list((folder / "photos").iterdir()))
    for row in truth:
        shown = cv2.imread(str(folder / "photos" / row["image"]))[..., ::-1].astype(float)
        column, line = (float(row["x"]) - 5000) / 0.5, (9000 - float(row["y"])) / 0.5
        assert shown.shape == (tool.EDGE_PX, tool.EDGE_PX, 3)
        # Colors grow evenly, so that their mean is that of the middle.
        expected = np.array([column, line]) * 255 / EDGE
        np.testing.assert_allclose(shown[..., :2].mean(axis=(0, 1)), expected, atol=1.5)
        # Wholly on the half that the orthophoto does not show.
        assert shown[..., 0].min() > 255 / 2 - 3


def test_the_orthophoto_is_the_western_half_and_all_polygons_are_buildings(filled):
    from osgeo import ogr

    folder = filled[2]
    orthophoto = gdal.Open(str(folder / "orthophoto.tif"))
    assert (orthophoto.RasterXSize, orthophoto.RasterYSize) == (EDGE // 2, EDGE)
    assert orthophoto.GetGeoTransform() == (5000.0, 0.5, 0, 9000.0, 0, -0.5)
    file = ogr.Open(str(folder / "buildings.gpkg"))
    assert [feature.GetField("class") for feature in file.GetLayer(0)] == ["building", "building"]


def test_what_is_missing_is_said(filled, tool, tmp_path):
    place, data, _ = filled
    assert tool.lacks(place, data) == ""
    assert tool.lacks(place, tmp_path) == f"Not walked: there is no photo.tif in {tmp_path}."
