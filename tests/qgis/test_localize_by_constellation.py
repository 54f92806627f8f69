"""semref:localizeimages with Constellation: a position anywhere, at any heading, or a reason."""

import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, scattered_objects, turned_view, write_raster
from osgeo import ogr

LOCALIZE = "semref:localizeimages"
LABELS = scattered_objects(900, 1000, 1300, seed=5)
SIZE = 300


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, SIZE / 2)


def view(column: float, row: float, heading: float, scale: float = 1.0, labels=LABELS) -> np.ndarray:
    return turned_view(labels, SIZE, column, row, heading, scale)


@pytest.fixture
def localize(run_algorithm, database, tmp_path):
    def run(labels, **parameters):
        path = write_raster(tmp_path / "photo.png", labels, transform=None)
        results = run_algorithm(
            LOCALIZE,
            {
                "DATABASE": database,
                "IMAGES": [str(path)],
                "OUTPUT": str(tmp_path / "positions.gpkg"),
                "FOOTPRINTS": str(tmp_path / "footprints.gpkg"),
                **parameters,
            },
        )
        positions, footprints = (ogr.Open(results[key]) for key in ("OUTPUT", "FOOTPRINTS"))
        (row,) = [feature.items() for feature in positions.GetLayer(0)]
        polygons = [feature.GetGeometryRef().Clone() for feature in footprints.GetLayer(0)]
        return row, polygons

    return run


@pytest.mark.slow
@pytest.mark.parametrize(
    ("column", "row", "heading", "scale"),
    [(400, 400, 0, 1.0), (333.3, 517.7, 47, 1.0), (612, 455, 200, 1.2), (501, 380, 312, 0.8)],
)
def test_an_image_between_windows_is_found_with_heading_and_pixel_size(localize, column, row, heading, scale):
    found, (footprint,) = localize(view(column, row, heading, scale))
    assert found["status"] == "fix" and found["method"] == "constellation"
    assert (found["x"], found["y"]) == pytest.approx((WEST + column, NORTH - row), abs=1.0)
    assert (found["heading"] - heading + 180) % 360 - 180 == pytest.approx(0, abs=0.5)
    assert found["pixel_size"] == pytest.approx(scale, rel=0.01)
    assert 0 < found["error_95"] < 3 and found["log_odds"] > 20.7 and found["confidence"] > 0.9
    assert 0 < found["error_95_minor"] <= found["error_95"] and 0 <= found["error_95_direction"] <= 180
    assert 0 < found["heading_deviation"] < 1 and 0 < found["pixel_size_deviation"] < 0.01 * scale
    assert footprint.GetArea() == pytest.approx((SIZE * scale) ** 2, rel=0.02)
    center = footprint.Centroid()
    assert (center.GetX(), center.GetY()) == pytest.approx((found["x"], found["y"]), abs=0.1)


@pytest.mark.slow
def test_the_risk_that_is_allowed_decides_and_the_confidence_has_all_its_digits(localize):
    image = view(400, 400, 0)
    found, _ = localize(image)
    risk = 1 - found["confidence"]
    assert 0 < risk < 1e-4
    refused, _ = localize(image, RISK=max(risk / 2, 1e-12))
    if risk > 2e-12:
        assert refused["status"] == "likely" and refused["confidence"] == found["confidence"]
    assert localize(image, RISK=0.5)[0]["confidence"] == found["confidence"]


def test_matches_pair_landmarks_of_image_and_map(localize, tmp_path):
    column, row, heading, scale = 612, 455, 200, 1.2
    matches = tmp_path / "matches.gpkg"
    found, _ = localize(view(column, row, heading, scale), MATCHES=str(matches))
    source = ogr.Open(str(matches))
    points = [(f.items(), f.GetGeometryRef().GetPoint_2D()) for f in source.GetLayer(0)]
    assert len(points) == found["inliers"] and [values["number"] for values, _ in points] == list(
        range(1, len(points) + 1)
    )
    turn = scale * np.exp(-1j * np.radians(heading))
    for values, (x, y) in points:
        assert values["image"] == found["image"] and values["class_name"] == NAMES[values["class"]]
        truth = turn * complex(values["image_column"] - SIZE / 2, SIZE / 2 - values["image_row"])
        assert (x - WEST - column, y - NORTH + row) == pytest.approx((truth.real, truth.imag), abs=3)
        off = np.hypot(values["seen_x"] - x, values["seen_y"] - y)
        assert values["residual"] == pytest.approx(off, abs=1e-6) and off < 3


@pytest.mark.parametrize(
    "labels",
    [
        pytest.param(view(500, 450, 30)[:, ::-1], id="mirrored"),
        pytest.param(
            view(300, 300, 10, labels=scattered_objects(900, 1000, 1300, seed=6)),
            id="elsewhere",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_what_is_not_on_the_map_gets_a_reason_and_no_position(localize, labels):
    found, footprints = localize(np.ascontiguousarray(labels))
    assert found["status"] in ("no_match", "ambiguous") and found["reason"]
    assert found["x"] is None and footprints == []


@pytest.mark.slow
def test_an_ambiguous_image_has_its_possible_places_as_polygons(run_algorithm, tmp_path):
    twins = np.hstack([LABELS[:, :500], LABELS[:, :500]])
    database = run_algorithm(
        "semref:builddatabase",
        {
            "LABELS": str(write_raster(tmp_path / "twins.tif", twins, names=NAMES)),
            "REFERENCE_CLASSES": "building;water;bare_land",
            "WINDOW_SIZE": SIZE,
            "STRIDE": SIZE / 2,
            "MINIMUM_AREA": 30,
            "DATABASE": str(tmp_path / "twins.gpkg"),
        },
    )["DATABASE"]
    image = write_raster(tmp_path / "photo.png", view(250, 400, 30, labels=twins), transform=None)
    results = run_algorithm(
        LOCALIZE,
        {
            "DATABASE": database,
            "IMAGES": [str(image)],
            "OUTPUT": str(tmp_path / "positions.gpkg"),
            "ALTERNATIVES": str(tmp_path / "places.gpkg"),
        },
    )
    # Layers are deleted with their file.
    positions, polygons = (ogr.Open(results[key]) for key in ("OUTPUT", "ALTERNATIVES"))
    (row,) = [feature.items() for feature in positions.GetLayer(0)]
    assert row["status"] == "ambiguous" and row["x"] is None and row["error_95_minor"] is None
    places = [(f.items(), f.GetGeometryRef().Centroid().GetX()) for f in polygons.GetLayer(0)]
    assert sorted(x - WEST for _, x in places) == pytest.approx([250, 750], abs=1)
    assert [values["rank"] for values, _ in places] == [1, 2]
    assert [values["heading"] for values, _ in places] == pytest.approx([30, 30], abs=0.5)
