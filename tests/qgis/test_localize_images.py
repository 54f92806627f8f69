import threading
from pathlib import Path

import numpy as np
import pytest
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, read_rows, scattered_objects, spatial_reference, write_raster
from osgeo import gdal, ogr, osr
from qgis.core import QgsProcessingException, QgsProcessingOutputLayerDefinition

from semref.core.labels.class_table import class_table_from_names
from semref.core.localization import Localization, Method, Place, Status
from semref.processing.jobs.image_results import with_jumps
from semref.processing.layers.localized_image import LocalizedImage
from semref.storage.database import reader

LOCALIZE = "semref:localizeimages"
SIZE, STRIDE = 120, 40
COLORS = {0: (0, 0, 0), **{c.value: c.rgb for c in class_table_from_names(NAMES[1:])}}
"""Colors (red, green, blue) of the class names above."""

FIELDS = (
    "image String, status String, x Real, y Real, longitude Real, latitude Real, heading Real, pixel_size Real, "
    "confidence Real, distance Real, inliers Integer, references Integer, log_odds Real, error_95 Real, window String, "
    "method String, reason String, camera_x Real, camera_y Real, jump Integer, "
    "error_95_minor Real, error_95_direction Real, heading_deviation Real, pixel_size_deviation Real, "
    "search_capped Integer, sigma_east Real, sigma_north Real, correlation Real, sigma_heading Real, "
    "sigma_scale Real, camera String, gps_distance Real, time DateTime"
)
LABELS = scattered_objects(400, 480, 240, seed=11)


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, STRIDE)


@pytest.fixture
def localize(run_algorithm, database, tmp_path, feedback):
    """`localize(images, **parameters)` returns (features of OUTPUT as dicts with their point, results)."""

    def run(images, **parameters):
        defaults = {"DATABASE": database, "METHOD": 1, "OUTPUT": str(tmp_path / "positions.gpkg")}
        results = run_algorithm(LOCALIZE, {"IMAGES": images, **defaults, **parameters}, feedback)
        return rows(results["OUTPUT"]), results

    return run


def rows(path) -> list:
    """Return the values of all features, with ``point`` or None, and ``area``."""
    found = read_rows(path)
    for row in found:
        shape = row.pop("geometry")
        row["point"] = shape and shape.GetGeometryType() == ogr.wkbPoint and shape.GetPoint_2D() or None
        row["area"] = shape and shape.GetArea()
    return found


def window(column: int, row: int, size: int = SIZE) -> np.ndarray:
    return LABELS[row : row + size, column : column + size]


def image(folder: Path, name: str, labels: np.ndarray) -> str:
    return str(write_raster(folder / name, labels, transform=None))


def colored(labels: np.ndarray) -> np.ndarray:
    palette = np.array([COLORS[value] for value in range(5)], np.uint8)
    return np.moveaxis(palette[labels], 2, 0)


def test_the_labels_folder_has_a_label_map_for_each_image_by_its_stem(localize, tmp_path):
    (tmp_path / "other").mkdir()
    first = image(tmp_path, "a.png", window(0, 0))
    second = image(tmp_path / "other", "a.png", colored(window(40, 80)))
    broken = tmp_path / "broken.png"
    broken.write_bytes(b"no image")
    folder = tmp_path / "labels"
    _, results = localize([first, second, str(broken)], LABELS=str(folder))
    assert results["LABELS"] == str(folder)
    names = {path.name for path in folder.iterdir() if path.suffix == ".tif"}
    assert names == {"a.tif", "a_2.tif"}
    for name, expected in (("a.tif", window(0, 0)), ("a_2.tif", window(40, 80))):
        labels = gdal.Open(str(folder / name))
        assert np.array_equal(labels.ReadAsArray(), expected)
        assert "1,building,#c8372d" in labels.GetMetadataItem("SEMREF_CLASS_TABLE")


def test_the_columns_are_those_of_the_format_in_order(localize, tmp_path):
    _, results = localize([image(tmp_path, "a.png", window(0, 0))])
    source = ogr.Open(results["OUTPUT"])
    layer = source.GetLayer(0)
    assert [f"{f.GetName()} {ogr.GetFieldTypeName(f.GetType())}" for f in layer.schema] == FIELDS.split(", ")
    assert layer.GetGeomType() == ogr.wkbPoint
    assert layer.GetSpatialRef().GetAuthorityCode(None) == str(METRIC_CRS)


@pytest.mark.parametrize(("column", "row"), [(0, 0), (160, 200), (360, 280)])
def test_an_image_cut_on_a_window_is_found_there(localize, tmp_path, column, row):
    path = image(tmp_path, "a.png", window(column, row))
    (found,), results = localize([path])
    place = WEST + column + SIZE / 2, NORTH - row - SIZE / 2
    degrees = osr.CoordinateTransformation(spatial_reference(METRIC_CRS), spatial_reference(4326))
    assert (found["image"], found["status"], found["window"]) == (path, "fix", f"{column}_{row}")
    assert (found["x"], found["y"]) == found["point"] == place and results["FIX_COUNT"] == 1
    assert (found["longitude"], found["latitude"]) == pytest.approx(degrees.TransformPoint(*place)[:2], abs=1e-9)
    assert (found["distance"], found["confidence"]) == pytest.approx((0, 1), abs=1e-6)
    assert found["method"] == "topology vector" and found["references"] >= 3 and not found["reason"]


def test_a_cancel_ends_at_once_while_a_database_is_read(localize, feedback, tmp_path, monkeypatch):
    go_on, ended = threading.Event(), []
    monkeypatch.setattr(reader, "read_database", lambda *_: ended.append(go_on.wait(600)))
    threading.Timer(0.5, feedback.cancel).start()
    with pytest.raises(QgsProcessingException, match="Canceled"):
        localize([image(tmp_path, "any.tif", window(0, 0))])
    assert ended == []
    go_on.set()


@pytest.mark.parametrize("algorithm", [LOCALIZE, "semref:localizeflight"])
def test_a_prior_position_outside_the_map_is_refused(run_algorithm, database, tmp_path, algorithm):
    prior = {"PRIOR_POINT": "9.5,47.1 [EPSG:4326]", "PRIOR_RADIUS": 500, "OUTPUT": "memory:"}
    with pytest.raises(QgsProcessingException, match="search area does not touch the map"):
        run_algorithm(algorithm, {"IMAGES": [image(tmp_path, "any.tif", window(0, 0))], "DATABASE": database, **prior})


def test_too_few_references_give_a_reason_with_the_missing_number(localize, tmp_path):
    labels = np.full((SIZE, SIZE), 4, np.uint8)
    labels[20:40, 20:40] = 1
    (found,), results = localize([image(tmp_path, "a.png", labels)])
    assert (found["status"], found["point"], results["FIX_COUNT"]) == ("too_few_references", None, 0)
    assert "1 landmark" in found["reason"] and "2 more" in found["reason"]
    for name in ("x", "y", "longitude", "latitude", "window"):
        assert found[name] is None


def test_a_bad_image_gives_a_row_with_its_reason_and_does_not_stop_the_others(localize, tmp_path, feedback):
    good, missing, empty = image(tmp_path, "good.png", window(0, 0)), tmp_path / "missing.png", tmp_path / "empty.png"
    empty.touch()
    found, results = localize([str(missing), good, str(empty)])
    assert [row["image"] for row in found] == [str(missing), good, str(empty)]
    assert [row["status"] for row in found] == ["error", "fix", "error"] and results["FIX_COUNT"] == 1
    assert [row["point"] is None for row in found] == [True, False, True]
    assert "missing.png" in found[0]["reason"] and "empty.png" in found[2]["reason"]
    assert "missing.png" in feedback.textLog()


def test_a_folder_means_its_images_in_order_of_name(localize, tmp_path):
    folder = tmp_path / "flight"
    (folder / "deeper").mkdir(parents=True)
    paths = [image(folder, name, window(40 * n, 40 * n)) for n, name in enumerate(["a.png", "b.tif", "c.png"])]
    (folder / "notes.txt").write_text("not an image")
    (folder / "a.png.aux.xml").write_text("<PAMDataset/>")
    found, _ = localize([str(folder)])
    assert [(row["image"], row["window"]) for row in found] == list(zip(paths, ["0_0", "40_40", "80_80"]))


@pytest.mark.parametrize("suffix", [".png", ".tif"])
@pytest.mark.parametrize("has_alpha", [False, True])
def test_color_images_are_decoded_by_the_databases_colors(localize, tmp_path, suffix, has_alpha):
    bands = colored(window(160, 200))
    if has_alpha:
        bands = np.concatenate([bands, np.full_like(bands[:1], 255)])
    (found,), _ = localize([image(tmp_path, f"color{suffix}", bands)])
    assert found["window"] == "160_200" and found["distance"] == pytest.approx(0, abs=1e-6)


def test_a_georeference_is_not_needed_and_not_used(localize, tmp_path):
    elsewhere = (0.0, 3.0, 0.0, 0.0, 0.0, -3.0)
    path = write_raster(tmp_path / "a.tif", window(160, 200), transform=elsewhere, crs=3857)
    assert localize([str(path)])[0][0]["window"] == "160_200"


def test_footprints_are_the_matched_windows_and_the_published_method_has_no_matches(localize, tmp_path):
    paths = [image(tmp_path, "a.png", window(160, 200)), str(tmp_path / "missing.png")]
    outputs = {key: str(tmp_path / f"{key}.gpkg") for key in ("FOOTPRINTS", "MATCHES")}
    _, results = localize(paths, **outputs)
    assert rows(results["MATCHES"]) == []
    (footprint,) = read_rows(results["FOOTPRINTS"])
    left, top = WEST + 160, NORTH - 200
    assert footprint["geometry"].GetEnvelope() == (left, left + SIZE, top - SIZE, top)
    assert footprint["image"] == paths[0] and footprint["window"] == "160_200"
    assert footprint["geometry"].GetSpatialReference().GetAuthorityCode(None) == str(METRIC_CRS)


@pytest.mark.slow
def test_a_likely_position_is_shown_with_a_reason_and_counted_apart(localize, run_algorithm, tmp_path, feedback):
    labels = window(180, 150, 60).copy()
    labels[np.random.default_rng(1).random(labels.shape) < 0.2] = 4
    images = [image(tmp_path, "a.png", labels), image(tmp_path, "b.png", window(180, 150))]
    # Between the error probabilities of both images, whatever the calibration is.
    risks = [1 - row["confidence"] for row in localize(images, METHOD=3, RISK=0.5)[0]]
    assert risks[0] > 10 * risks[1]
    risk = float(np.sqrt(np.prod(risks)))
    outputs = {key: str(tmp_path / f"{key}.gpkg") for key in ("FOOTPRINTS", "ALTERNATIVES", "MATCHES")}
    found, results = localize([*images, str(tmp_path / "missing.png")], METHOD=3, RISK=risk, **outputs)
    assert [row["status"] for row in found] == ["likely", "fix", "error"]
    found, fix, _ = found
    assert found["point"] == pytest.approx((WEST + 210, NORTH - 180), abs=2)
    assert (found["x"], found["y"]) == found["point"] and found["longitude"] is not None
    assert 0.8 <= found["confidence"] < 1 and 0 < found["error_95_minor"] <= found["error_95"] < 20
    assert "error probability" in found["reason"] and "Error budget" in found["reason"]
    assert fix["point"] is not None and fix["reason"].startswith("Error budget")
    ground, other = rows(results["FOOTPRINTS"])
    assert (ground["status"], other["status"]) == ("likely", "fix")
    assert ground["area"] == pytest.approx(60**2, rel=0.1)
    assert {row["image"] for row in rows(results["MATCHES"])} == {found["image"], fix["image"]}
    assert rows(results["ALTERNATIVES"]) == []
    assert results["FIX_COUNT"] == 1
    log = feedback.textLog()
    assert "1 of 3 images has a position. Likely positions: 1." in log
    assert "a.png: Likely position. " in log and "b.png: Likely position" not in log
    given = {"POSITIONS": str(tmp_path / "positions.gpkg"), "OUTPUT": str(tmp_path / "placed"), "IMAGES": str(tmp_path)}
    assert run_algorithm("semref:georeferenceimages", given, feedback)["IMAGE_COUNT"] == 1
    assert [path.name for path in (tmp_path / "placed").iterdir()] == ["b.tif"]
    assert "a.png was left out. Its position is only likely." in feedback.textLog()


def test_a_likely_position_is_no_jump_and_makes_none(feedback):
    def taken(x, time_s, status):
        result = Localization(status, Method.CONSTELLATION, best=Place((x, 0.0), 0.0, 1.0), error_95_m=1.0)
        return LocalizedImage("a.png", result, time_s=time_s)

    wrong = [taken(0.0, 0.0, Status.FIX), taken(5000.0, 1.0, Status.LIKELY), taken(20.0, 2.0, Status.FIX)]
    checked = with_jumps(wrong, None, 25.0, feedback)
    assert [item.jump for item in checked] == [False, None, False]
    assert "0 of 2 positions with a time are jumps." in feedback.textLog()


def test_temporary_outputs_have_the_rows_and_those_left_empty_are_not_made(run_algorithm, database, tmp_path):
    empty = QgsProcessingOutputLayerDefinition("")
    given = {"DATABASE": database, "IMAGES": [image(tmp_path, "a.png", window(0, 0))], "MATCHES": empty}
    results = run_algorithm(LOCALIZE, {**given, **dict.fromkeys(("OUTPUT", "FOOTPRINTS"), "TEMPORARY_OUTPUT")})
    assert results["MATCHES"] is None and results["OUTPUT"].featureCount() == results["FOOTPRINTS"].featureCount() == 1


@pytest.mark.parametrize("method", [{}, {"METHOD": 0}, {"METHOD": 2}])
def test_the_constellation_is_the_automatic_method(localize, tmp_path, method):
    (found,), _ = localize([image(tmp_path, "a.png", window(0, 0))], **{"METHOD": None, **method})
    assert found["method"] == "constellation"
