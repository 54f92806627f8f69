import numpy as np
import pytest
import shapely
from made_inputs import NORTH, WEST, scattered_objects, write_raster
from made_models import painted, write_model
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException, QgsVectorLayer

from semref.core.steps import result_of
from semref.storage import polygonize

SEGMENT = "semref:segmentimage"
LABELS = scattered_objects(170, 230, 60, seed=3, background=0)
SEEN = np.where(LABELS == 0, 1, LABELS)


def speckled(height: int, width: int, seed: int) -> np.ndarray:
    """Return patches of four classes, 0 among them, with speckles of single pixels that may touch at corners."""
    random = np.random.default_rng(seed)
    patches = np.kron(random.integers(0, 4, (height // 20 + 1, width // 20 + 1)), np.ones((20, 20)))[:height, :width]
    speckles = random.random((height, width)) < 0.1
    return np.where(speckles, random.integers(0, 4, (height, width)), patches).astype(np.uint8)


def outlined(path, minimum_area=0.0, tolerance=0.0):
    return result_of(polygonize.polygonize(str(path), minimum_area, tolerance))


@pytest.mark.parametrize("seed", [1, 2])
def test_they_are_those_of_gdal(qgis_app, tmp_path, seed):
    path = str(write_raster(tmp_path / "labels.tif", speckled(120, 150, seed), transform=(WEST, 2, 0, NORTH, 0, -2)))
    classes, polygons = outlined(path)
    kept = (ogr.GetDriverByName("Memory") or ogr.GetDriverByName("MEM")).CreateDataSource("")
    made = kept.CreateLayer("p")
    made.CreateField(ogr.FieldDefn("value", ogr.OFTInteger))
    source = gdal.Open(path)
    gdal.Polygonize(source.GetRasterBand(1), None, made, 0, [])
    expected = [(one.GetField(0), bytes(one.GetGeometryRef().ExportToWkb())) for one in made if one.GetField(0)]
    own = zip(classes.tolist(), shapely.to_wkb(_plain(polygons)))
    assert sorted(own) == sorted((v, shapely.to_wkb(_plain(shapely.from_wkb(wkb)))) for v, wkb in expected)


def _plain(polygons):
    """Return polygons without vertices on straight edges, in shapely's order."""
    return shapely.normalize(shapely.simplify(shapely.normalize(polygons), 0))


def test_small_regions_go_to_their_largest_neighbor(qgis_app, tmp_path):
    labels = np.full((60, 80), 2, np.uint8)
    labels[20:24, 30:34] = 1
    labels[40:42, 10:13] = 3
    path = str(write_raster(tmp_path / "labels.tif", labels, transform=(WEST, 2, 0, NORTH, 0, -2)))
    classes, polygons = outlined(path, minimum_area=64)
    # 4 × 4 pixels of 4 m² are 64 m²; 2 × 3 are less.
    assert sorted(classes.tolist()) == [1, 2]
    assert shapely.area(polygons).sum() == 60 * 80 * 4


@pytest.fixture
def segment(runner, tmp_path):
    model = write_model(tmp_path / "colors.onnx")
    outputs = {"OUTPUT": tmp_path / "labels.tif", "POLYGONS": tmp_path / "polygons.gpkg"}
    return runner(SEGMENT, "INPUT", MODEL=model, **outputs)


def test_the_algorithm_writes_them_named_and_styled_on_the_images_ground(segment, tmp_path):
    pixels = np.moveaxis(painted(LABELS), 2, 0)
    image = write_raster(tmp_path / "a.tif", pixels, transform=(WEST, 0.5, 0, NORTH, 0, -0.5))
    layer = QgsVectorLayer(segment(image, TOLERANCE=0)["POLYGONS"], "polygons", "ogr")
    areas = {"building": 0.0, "water": 0.0, "bare_land": 0.0}
    for feature in layer.getFeatures():
        assert feature["area"] == pytest.approx(feature.geometry().area())
        areas[feature["class_name"]] += feature["area"]
    assert areas == {name: (n == SEEN).sum() / 4 for n, name in enumerate(areas, start=1)}
    assert layer.crs().authid() == "EPSG:32632"
    assert [category.label() for category in layer.renderer().categories()] == list(areas)


def test_a_photo_without_a_place_gives_polygons_in_pixels(segment, tmp_path):
    image = write_raster(tmp_path / "a.png", np.moveaxis(painted(LABELS), 2, 0), transform=None)
    extent = QgsVectorLayer(segment(image)["POLYGONS"], "polygons", "ogr").extent()
    assert (extent.xMinimum(), extent.xMaximum(), extent.yMinimum(), extent.yMaximum()) == (0, 230, -170, 0)


def test_a_cancel_while_outlining_leaves_nothing(segment, feedback, tmp_path, monkeypatch):
    real = polygonize.outline_regions

    def canceled(*arguments):
        feedback.cancel()
        return real(*arguments)

    monkeypatch.setattr(polygonize, "outline_regions", canceled)
    image = write_raster(tmp_path / "a.tif", np.moveaxis(painted(LABELS), 2, 0))
    with pytest.raises(QgsProcessingException, match="Canceled"):
        segment(image)
    assert not (tmp_path / "labels.tif").exists() and not (tmp_path / "polygons.gpkg").exists()
