import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from full_disks import files_of_at_most
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, scattered_objects, spatial_reference, write_layer, write_raster
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException

from semref.core.errors import ImageError
from semref.core.geometry.footprint import image_corners, on_ground
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.simulation.views import View, cut
from semref.storage.georeferencing import write_draped, write_mosaic

GEOREFERENCE = "semref:georeferenceimages"
LABELS = scattered_objects(900, 1000, 1300, seed=5)
SIZE = 300
VIEW = View(WEST + 450.0, NORTH - 520.0, 30.0, 1.0, SIZE, SIZE)
COLUMNS = [("image", "text"), ("status", "text"), ("heading", "real"), ("pixel_size", "real"), ("camera_x", "real")]


@pytest.fixture(scope="module")
def localized(run_algorithm, build_area, tmp_path_factory):
    folder = tmp_path_factory.mktemp("area")
    database = build_area(LABELS, NAMES, SIZE, 150)
    images = folder / "images"
    images.mkdir()
    tilted = View(WEST + 500.0, NORTH - 420.0, 200.0, 1.0, SIZE, SIZE, tilt_deg=25.0)
    for name, view in (("level", VIEW), ("tilted", tilted)):
        write_raster(images / f"{name}.png", cut(LABELS, MapFrame.at((WEST, NORTH), 1.0), view), transform=None)
    write_raster(images / "elsewhere.png", scattered_objects(SIZE, SIZE, 200, seed=99), transform=None)
    (folder / "cameras.csv").write_text("image,roll,pitch,field_of_view\ntilted.png,0,25,60\n", encoding="ascii")
    outputs = {key: str(folder / f"{key}.gpkg") for key in ("OUTPUT", "FOOTPRINTS", "MATCHES")}
    given = {"DATABASE": database, "IMAGES": str(images), "METHOD": 2, "ATTITUDE": str(folder / "cameras.csv")}
    assert run_algorithm("semref:localizeimages", {**given, **outputs})["FIX_COUNT"] == 2
    return outputs


@pytest.fixture
def georeference(run_algorithm, localized, tmp_path, feedback):
    def run(**parameters):
        given = {"POSITIONS": localized["OUTPUT"], "FOOTPRINTS": localized["FOOTPRINTS"]}
        result = run_algorithm(GEOREFERENCE, {**given, "OUTPUT": str(tmp_path / "placed"), **parameters}, feedback)
        return result, Path(result["OUTPUT"])

    return run


def agreement(path: Path) -> float:
    """Return the share of pixels of a georeferenced label image that equal the map, where it has labels."""
    raster = gdal.Open(str(path))
    seen = raster.GetRasterBand(1).ReadAsArray()
    x0, dx, _, y0, _, dy = raster.GetGeoTransform()
    rows, columns = np.nonzero(seen)
    on_map = LABELS[
        np.floor(NORTH - y0 - (rows + 0.5) * dy).astype(int), np.floor(x0 + (columns + 0.5) * dx - WEST).astype(int)
    ]
    return float((on_map == seen[rows, columns]).mean())


@pytest.mark.slow
def test_geotiffs_show_on_the_ground_what_the_map_has_there(georeference):
    result, folder = georeference()
    assert result["IMAGE_COUNT"] == 2
    assert sorted(path.name for path in folder.iterdir()) == ["level.tif", "tilted.tif"]
    for name in ("level", "tilted"):
        raster = gdal.Open(str(folder / f"{name}.tif"))
        assert raster.GetSpatialRef().GetAuthorityCode(None) == "32632"
        assert raster.GetGeoTransform()[2] == raster.GetGeoTransform()[4] == 0
        assert agreement(folder / f"{name}.tif") > 0.93


def test_a_mosaic_shows_all_images_on_the_ground(georeference):
    result, folder = georeference(FORMAT=3, RESOLUTION=50)
    assert (result["IMAGE_COUNT"], [path.name for path in folder.iterdir()]) == (2, ["mosaic.tif"])
    assert gdal.Open(str(folder / "mosaic.tif")).GetGeoTransform()[1] == 0.5
    assert agreement(folder / "mosaic.tif") > 0.93


@pytest.mark.parametrize("tilted", [(), (0,), (1,), (0, 1)])
def test_a_mosaic_of_level_and_tilted_photos_is_transparent_elsewhere(tmp_path, tilted):
    images, centers = [], ((50.0, 50.0), (250.0, 50.0))
    for n, center in enumerate(centers):
        photo = write_raster(tmp_path / f"{n}.png", np.full((3, 80, 80), 100 * (n + 1), np.uint8), transform=None)
        corners = image_corners(center, 30.0, 0.5, 80, 80)
        corners[0] += (8.0, -8.0) if n in tilted else 0.0
        images.append((str(photo), corners))
    write_mosaic(images, str(tmp_path / "mosaic.tif"), spatial_reference(METRIC_CRS).ExportToWkt(), 1.0, lambda _: True)
    mosaic = gdal.Open(str(tmp_path / "mosaic.tif"))
    x0, _, _, y0, _, _ = mosaic.GetGeoTransform()
    seen = [mosaic.ReadAsArray(int(x - x0), int(y0 - y), 1, 1).ravel().tolist() for x, y in (*centers, (150, 50))]
    assert seen == [[100, 100, 100, 255], [200, 200, 200, 255], [0, 0, 0, 0]]


def test_those_without_a_fix_are_named_with_the_reason(georeference, feedback):
    georeference()
    assert "elsewhere.png was left out. It has no position." in feedback.textLog()


def test_a_world_file_puts_the_untouched_copy_where_the_image_was_taken(georeference, localized, feedback):
    result, folder = georeference(FORMAT=1)
    assert result["IMAGE_COUNT"] == 1
    assert sorted(path.name for path in folder.iterdir()) == ["level.pgw", "level.png", "level.png.aux.xml"]
    assert "tilted.png was tilted" in feedback.textLog()
    raster = gdal.Open(str(folder / "level.png"))
    assert raster.GetSpatialRef().GetAuthorityCode(None) == "32632"
    x0, across_x, down_x, y0, across_y, down_y = raster.GetGeoTransform()
    middle = x0 + (across_x + down_x) * SIZE / 2, y0 + (across_y + down_y) * SIZE / 2
    assert middle == pytest.approx(VIEW.position, abs=1.0)
    assert np.degrees(np.arctan2(-across_y, across_x)) == pytest.approx(30, abs=0.3)
    numbers = [float(line) for line in (folder / "level.pgw").read_text().split()]
    assert numbers == pytest.approx(
        [across_x, across_y, down_x, down_y, x0 + (across_x + down_x) / 2, y0 + (across_y + down_y) / 2], rel=1e-6
    )


def points_of(path: Path) -> np.ndarray:
    first, header, *lines = path.read_text(encoding="utf-8").splitlines()
    assert first.startswith("#CRS: PROJ") and header.startswith("mapX,mapY,sourceX,sourceY,enable")
    return np.array([[float(value) for value in line.split(",")] for line in lines])


def test_matched_landmarks_become_control_points_with_how_far_each_is_off(georeference, localized):
    _, folder = georeference(FORMAT=2, MATCHES=localized["MATCHES"])
    points = points_of(folder / "level.png.points")
    assert (folder / "level.png").is_file() and len(points) > 10
    # By the view of each pixel, the landmarks agree with the map to a pixel or two.
    heading = np.radians(VIEW.heading_deg)
    right, up = points[:, 2] - SIZE / 2, points[:, 3] + SIZE / 2
    east = VIEW.position[0] + right * np.cos(heading) + up * np.sin(heading)
    north = VIEW.position[1] - right * np.sin(heading) + up * np.cos(heading)
    assert np.hypot(points[:, 0] - east, points[:, 1] - north).max() < 3
    assert 0 < np.median(points[:, 7]) < 2
    np.testing.assert_allclose(np.hypot(points[:, 5], points[:, 6]), points[:, 7], rtol=1e-6)


def test_an_image_placed_by_map_correlation_has_control_points_of_its_fix(georeference, localized, tmp_path):
    """If a network joins houses, centers are off by meters, while areas place the image to decimeters."""
    by_areas = tmp_path / "by_areas.gpkg"
    shutil.copy(localized["OUTPUT"], by_areas)
    source = ogr.Open(str(by_areas), 1)
    layer = source.GetLayer(0)
    for row in list(layer):
        row.SetField("method", "map correlation")
        layer.SetFeature(row)
    row = layer = source = None
    images = str(Path(localized["OUTPUT"]).parent / "images")
    _, folder = georeference(FORMAT=2, POSITIONS=str(by_areas), MATCHES=localized["MATCHES"], IMAGES=images)
    points = points_of(folder / "level.png.points")
    assert points[:, 2:4].tolist() == [[c, -r] for r in (0, 150, 300) for c in (0, 150, 300)]


def test_a_tilted_image_without_its_footprint_is_left_out(georeference, feedback):
    result, _ = georeference(FOOTPRINTS=None)
    assert result["IMAGE_COUNT"] == 1
    assert "tilted.png was left out. The camera was tilted." in feedback.textLog()


def made_positions(path: Path, image: str, columns=COLUMNS, **more) -> str:
    values = {"image": image, "status": "fix", "heading": 0.0, "pixel_size": 1.0, "camera_x": None}
    row = [values[name] for name, _ in columns]
    return str(write_layer(path, [(f"POINT ({WEST + 200} {NORTH - 200})", *row)], columns, **more))


@pytest.mark.skipif(sys.platform != "linux", reason="counts files in /proc")
def test_a_mosaic_of_many_photos_has_few_open_files(tmp_path):
    photo = str(write_raster(tmp_path / "one.png", np.full((3, 8, 8), 100, np.uint8), transform=None))
    images, opened = [(photo, image_corners((n, 0.0), 30.0, 1.0, 8, 8)) for n in range(40)], []

    def count(_: float = 0.0) -> bool:
        opened.append(len(list(Path("/proc/self/fd").iterdir())))
        return True

    count()
    write_mosaic(images, str(tmp_path / "mosaic.tif"), "", 1.0, count)
    assert len(opened) > 40 and max(opened) < opened[0] + 10


def test_photos_with_one_name_in_two_folders_keep_their_positions(georeference, tmp_path):
    rows, files = [], []
    for n, folder in enumerate(("day 1", "day 2")):
        (tmp_path / folder).mkdir()
        photo = np.full((3, 80, 80), 100 * (n + 1), np.uint8)
        files.append(str(write_raster(tmp_path / folder / "one.png", photo, transform=None)))
        rows.append((f"POINT ({WEST + 200 * n} {NORTH})", files[-1], "fix", 0.0, 1.0, None))
    positions = str(write_layer(tmp_path / "p.gpkg", rows, COLUMNS))
    _, folder = georeference(POSITIONS=positions, FOOTPRINTS=None, IMAGES=files, FORMAT=3)
    mosaic = gdal.Open(str(folder / "mosaic.tif"))
    assert [mosaic.ReadAsArray(column, 40, 1, 1)[0, 0, 0] for column in (40, 240)] == [100, 200]


@pytest.mark.parametrize("point", ["POINT ({})", "MULTIPOINT (({}))"])
def test_images_that_were_moved_are_found_by_name_also_of_exports_with_multipoints(georeference, tmp_path, point):
    (tmp_path / "here").mkdir()
    write_raster(tmp_path / "here" / "one.png", LABELS[:100, :100], transform=None)
    row = (point.format(f"{WEST + 200} {NORTH - 200}"), "/where/it/was/one.png", "fix", 0.0, 1.0, None)
    positions = str(write_layer(tmp_path / "p.gpkg", [row], COLUMNS))
    result, folder = georeference(POSITIONS=positions, FOOTPRINTS=None, IMAGES=[str(tmp_path / "here")])
    assert result["IMAGE_COUNT"] == 1
    west, _, _, north, _, _ = gdal.Open(str(folder / "one.tif")).GetGeoTransform()
    assert (west, north) == pytest.approx((WEST + 150, NORTH - 150), abs=0.01)


def test_a_photo_keeps_its_bands_and_is_transparent_around(georeference, tmp_path):
    photo = np.full((3, 60, 80), 200, np.uint8)
    write_raster(tmp_path / "photo.tif", photo, crs=None, transform=None)
    positions = made_positions(tmp_path / "p.gpkg", str(tmp_path / "photo.tif"))
    _, folder = georeference(POSITIONS=positions, FOOTPRINTS=None)
    raster = gdal.Open(str(folder / "photo.tif"))
    assert raster.RasterCount == 4
    assert raster.GetRasterBand(4).GetColorInterpretation() == gdal.GCI_AlphaBand


def test_layers_of_something_else_are_refused(georeference, tmp_path):
    positions = made_positions(tmp_path / "p.gpkg", "one.png", COLUMNS[:2])
    with pytest.raises(QgsProcessingException, match="“p” lacks the columns heading, pixel_size"):
        georeference(POSITIONS=positions, FOOTPRINTS=None)
    degrees = made_positions(tmp_path / "d.gpkg", "one.png", crs=4326)
    with pytest.raises(QgsProcessingException, match="EPSG:4326, which is not in meters"):
        georeference(POSITIONS=degrees, FOOTPRINTS=None)


@pytest.mark.skipif(sys.platform == "win32", reason="limits on files as Unix has them")
@pytest.mark.parametrize("size", [0, 500, 3000])
def test_a_full_disk_is_an_error_and_leaves_no_folder(georeference, tmp_path, size):
    """Truncated GeoTIFFs once remained in the folder after a successful run."""
    with pytest.raises(QgsProcessingException), files_of_at_most(size):
        georeference()
    assert list(tmp_path.iterdir()) == []


SHAPE_HW = (300, 400)
MIDDLE = np.array([400_000.0, 5_400_000.0])
WKT = spatial_reference(25832).ExportToWkt()


def footprint_of(roll, pitch, heading=0.0, pixel_m=0.5):
    if roll == pitch == 0:
        return image_corners(tuple(MIDDLE), heading, pixel_m, SHAPE_HW[1], SHAPE_HW[0])
    ground = leveling(Attitude(roll, pitch), 400.0, SHAPE_HW).corners * pixel_m * np.exp(-1j * np.radians(heading))
    return MIDDLE + np.column_stack([ground.real, ground.imag])


@pytest.mark.slow
@pytest.mark.parametrize("attitude", [(0, 0), (0, 10), (12, 20), (-5, -30)])
@pytest.mark.parametrize("heading", [0.0, 200.0])
def test_each_pixel_is_where_a_camera_without_distortion_saw_it(qgis_app, tmp_path, attitude, heading):
    # Two bands with the column and the row of each pixel.
    columns_rows = np.indices(SHAPE_HW, np.uint16)[::-1]
    photo = str(write_raster(tmp_path / "photo.tif", columns_rows, transform=None, kind=gdal.GDT_UInt16))
    footprint = footprint_of(*attitude, heading)
    target = str(tmp_path / "laid.vrt")
    write_draped(photo, target, WKT, footprint)
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
    with pytest.raises(ImageError, match="missing.tif"):
        write_draped(str(tmp_path / "missing.tif"), str(tmp_path / "x.vrt"), WKT, footprint_of(0, 0))
