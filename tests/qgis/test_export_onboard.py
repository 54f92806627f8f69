import json
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, read_rows, scattered_objects, turned_view, write_layer, write_raster
from made_models import ground_and_colors, metadata, painted, write_model
from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsProcessingException

from semref.core.errors import SemRefError
from semref.core.labels.image_files import read_label_image
from semref.core.onboard.read import read_onboard
from semref.processing.layers.reference_systems import fitted_lon_lat, longitudes_latitudes
from semref.storage.database.reader import read_database
from semref.storage.label_images import read_label_image as read_with_gdal

EXPORT, LOCALIZE = "semref:exportonboard", "semref:localizeimages"
LABELS = scattered_objects(600, 700, 420, seed=11)


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, 200, 100)


@pytest.fixture
def export(runner, database, tmp_path):
    return runner(EXPORT, DATABASE=database, OUTPUT=tmp_path / "area.npz")


def test_the_file_has_the_database_within_its_stated_errors(export, database, feedback):
    results = export()
    found, expected = read_onboard(results["OUTPUT"]), read_database(database, with_overview=True)
    assert results["BYTES"] == Path(results["OUTPUT"]).stat().st_size == found.size_bytes
    assert found.database.parameters == replace(expected.parameters, block_hashes=())
    assert found.database.class_table == expected.class_table
    np.testing.assert_array_equal(found.database.windows.names, expected.windows.names)
    np.testing.assert_array_equal(found.database.windows.centers, expected.windows.centers)
    np.testing.assert_array_equal(found.database.overview, expected.overview)
    worst = np.abs(found.database.references.positions - expected.references.positions).max()
    assert worst <= found.position_error * 1.0001 == pytest.approx(0.05, rel=1e-3)
    assert "positions 0.05 m" in feedback.textLog()


def test_a_file_is_signed_with_the_key_that_was_given(export, tmp_path):
    (tmp_path / "key").write_bytes(bytes(range(32)))
    signed = export(KEY_FILE=str(tmp_path / "key"))["OUTPUT"]
    assert len(read_onboard(signed, key_file=str(tmp_path / "key")).database.references)
    (tmp_path / "key").write_bytes(bytes(32))
    with pytest.raises(SemRefError, match="was not signed with the key"):
        read_onboard(signed, key_file=str(tmp_path / "key"))


def test_longitude_and_latitude_are_proj_s(export):
    found = read_onboard(export()["OUTPUT"])
    x0, y0, x1, y1 = found.database.parameters.extent
    points = np.random.default_rng(1).uniform((x0, y0), (x1, y1), (300, 2))
    crs = QgsCoordinateReferenceSystem("EPSG:32632")
    longitudes, latitudes = longitudes_latitudes(points, crs, QgsCoordinateTransformContext())
    lon, lat = found.lon_lat(points)
    assert found.lon_lat.error_m <= 0.01
    east = (lon - longitudes) * 111320 * np.cos(np.radians(latitudes))
    assert np.hypot(east, (lat - latitudes) * 111320).max() <= 1.1 * found.lon_lat.error_m + 1e-6


@pytest.mark.parametrize(
    ("epsg", "extent", "least"),
    [
        (32632, (530_000, 5_200_000, 560_000, 5_240_000), 0.01),
        (2193, (1_500_000, 5_100_000, 1_900_000, 5_500_000), 0.01),
        (3035, (4_000_000, 2_500_000, 4_900_000, 3_500_000), 0.05),
        (3832, (100_000, -300_000, 400_000, 300_000), 0.01),
    ],
)
def test_maps_of_countries_keep_to_centimeters(qgis_app, epsg, extent, least):
    crs = QgsCoordinateReferenceSystem(f"EPSG:{epsg}")
    assert fitted_lon_lat(extent, crs, QgsCoordinateTransformContext()).error_m <= least


def test_only_the_corridor_along_a_route_is_exported(export, tmp_path, feedback):
    wkt = f"LINESTRING ({WEST + 100} {NORTH - 100}, {WEST + 600} {NORTH - 100})"
    route = str(write_layer(tmp_path / "route.gpkg", [(wkt, "a")]))
    found = read_onboard(export(CLIP=route, DISTANCE=60)["OUTPUT"]).database
    rows = NORTH - found.references.positions[:, 1]
    assert len(rows) > 20 and rows.min() >= 36 and rows.max() <= 164
    np.testing.assert_array_equal(np.flatnonzero(found.overview.any(axis=1))[[0, -1]], [10, 40])
    assert "landmarks and" in feedback.textLog()


def test_a_polygon_in_another_crs_that_crosses_itself_is_brought_to_the_map_and_repaired(export, tmp_path):
    corners = [(WEST + x, NORTH - y) for x, y in ((100, 100), (400, 400), (400, 100), (100, 400))]
    crs = QgsCoordinateReferenceSystem("EPSG:32632")
    degrees = np.column_stack(longitudes_latitudes(np.array(corners), crs, QgsCoordinateTransformContext())).tolist()
    text = ", ".join(f"{x:.9f} {y:.9f}" for x, y in [*degrees, degrees[0]])
    area = str(write_layer(tmp_path / "area.gpkg", [(f"POLYGON (({text}))", "a")], crs=4326))
    positions = read_onboard(export(CLIP=area)["OUTPUT"]).database.references.positions
    assert len(positions) > 20 and (np.abs(positions - (WEST + 250, NORTH - 250)) <= 154).all()


@pytest.mark.parametrize("parameters", [{}, {"DISTANCE": 10}])
def test_an_area_elsewhere_is_refused(export, tmp_path, parameters):
    layer = str(write_layer(tmp_path / "far.gpkg", [(f"POINT ({WEST - 9000} {NORTH})", "a")]))
    with pytest.raises(QgsProcessingException, match="outside the database’s map"):
        export(CLIP=layer, **parameters)
    assert not (tmp_path / "area.npz").exists()


def test_an_area_without_a_crs_is_refused_although_its_coordinates_would_fit(export, tmp_path):
    layer = str(write_layer(tmp_path / "area.shp", [(f"POINT ({WEST + 300} {NORTH - 300})", "a")], crs=None))
    with pytest.raises(QgsProcessingException, match="“area” has no CRS. Set the CRS of the layer"):
        export(CLIP=layer, DISTANCE=100)


def test_an_older_onboard_file_is_replaced_with_a_note(export, feedback):
    path = Path(export()["OUTPUT"])
    before = path.read_bytes()
    assert "is replaced" not in feedback.textLog()
    export(OVERVIEW=False)
    assert "is replaced" in feedback.textLog()
    assert path.read_bytes() != before and [entry.name for entry in path.parent.iterdir()] == [path.name]


@pytest.fixture
def without_qgis(repository, tmp_path):
    """`without_qgis(*arguments)` runs `python -m core` in a copy of the folder; returns its JSON lines."""
    shutil.copytree(repository / "core", tmp_path / "alone" / "core", ignore=shutil.ignore_patterns("__pycache__"))

    def run(*arguments):
        command = [sys.executable, "-m", "core", *arguments, "--json"]
        done = subprocess.run(command, cwd=tmp_path / "alone", capture_output=True, text=True, check=False)
        return [json.loads(line) for line in done.stdout.splitlines()]

    return run


@pytest.mark.slow
@pytest.mark.parametrize("method", [(1, "topology-vector"), (0, "automatic")])
def test_images_have_equal_fixes_with_and_without_qgis(export, run_algorithm, without_qgis, database, tmp_path, method):
    folder = tmp_path / "images"
    folder.mkdir()
    random = np.random.default_rng(5)
    for n in range(6):
        column, row = random.uniform(150, 550), random.uniform(150, 450)
        view = turned_view(LABELS, 200, column, row, random.uniform(0, 360) if method[0] == 0 else 0.0)
        write_raster(folder / f"{n}.png", view, transform=None)
    write_raster(folder / "nothing.png", np.full((200, 200), 4, np.uint8), transform=None)
    parameters = {"DATABASE": database, "IMAGES": [str(folder)], "METHOD": method[0]}
    expected = read_rows(run_algorithm(LOCALIZE, {**parameters, "OUTPUT": str(tmp_path / "fixes.gpkg")})["OUTPUT"])
    file = export()["OUTPUT"]
    found = without_qgis("localize", str(folder), "--database", file, "--method", method[1])
    assert [row["status"] for row in found] == [row["status"] for row in expected]
    assert [row["status"] for row in found].count("fix") >= 6
    for mine, theirs in zip(found, expected):
        assert mine["window"] == theirs["window"]
        if theirs["x"] is not None:
            assert np.hypot(mine["x"] - theirs["x"], mine["y"] - theirs["y"]) < 0.02
            assert mine["longitude"] == pytest.approx(theirs["longitude"], abs=3e-7)
            assert mine["latitude"] == pytest.approx(theirs["latitude"], abs=3e-7)


@pytest.mark.slow
def test_photos_have_the_same_fixes_with_and_without_qgis(export, run_algorithm, without_qgis, database, tmp_path):
    names = metadata(class_names=["ground", "building", "water", "bare_land"])
    model = str(write_model(tmp_path / "colors.onnx", ground_and_colors(), metadata=names))
    photo = painted(turned_view(LABELS, 200, 350.3, 280.6, 77), (None, "building", "water", "bare_land", None))
    path = str(write_raster(tmp_path / "photo.tif", np.moveaxis(photo, 2, 0), transform=None))
    parameters = {"DATABASE": database, "IMAGES": [path], "MODEL": model, "OUTPUT": str(tmp_path / "fixes.gpkg")}
    (expected,) = read_rows(run_algorithm(LOCALIZE, parameters)["OUTPUT"])
    (found,) = without_qgis("localize", path, "--database", export()["OUTPUT"], "--model", model)
    assert found["status"] == expected["status"] == "fix"
    assert np.hypot(found["x"] - expected["x"], found["y"] - expected["y"]) < 0.02
    assert (found["x"], found["y"]) == pytest.approx((WEST + 350.3, NORTH - 280.6), abs=1)


COLORS = {value: (50 * value, 255 - value, 7) for value in range(5)}
KINDS = {"a.png": (), "a.tif": (), "b.tif": ("COMPRESS=DEFLATE", "TILED=YES"), "c.tif": ("COMPRESS=LZW", "PREDICTOR=2")}


@pytest.mark.parametrize("name", KINDS)
def test_paletted_images_are_read_as_gdal_reads_them(database, tmp_path, name):
    given = {"palette": COLORS, "options": KINDS[name], "transform": None}
    path = str(write_raster(tmp_path / name, LABELS, **given))
    assert cv2.imread(path, cv2.IMREAD_UNCHANGED).ndim == 3
    table = read_database(database, with_overview=True).class_table
    np.testing.assert_array_equal(read_label_image(path, table), LABELS)
    np.testing.assert_array_equal(read_with_gdal(path, table), LABELS)
