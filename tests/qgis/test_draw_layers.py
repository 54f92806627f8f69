"""Map tiles and parts of images become label maps of their ground."""

import gc
import threading
import time

import numpy as np
import pytest
from made_inputs import (
    NORTH,
    WEST,
    read_pixels,
    read_rows,
    scattered_objects,
    spatial_reference,
    write_layer,
    write_raster,
)
from made_models import metadata, painted, write_model
from osgeo import gdal, osr
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsNetworkAccessManager,
    QgsProcessingException,
    QgsProject,
    QgsRasterLayer,
)
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QUrl
from qgis.PyQt.QtNetwork import QNetworkAccessManager, QNetworkRequest
from tile_server import labels_at, tile_png, tile_server

from semref.core import limits
from semref.processing.layers import downloads
from semref.processing.layers.downloads import install, watched_downloads

SEGMENT = "semref:segmentimage"
EXTENT = f"{WEST},{WEST + 1200},{NORTH - 900},{NORTH} [EPSG:32632]"
LABELS = scattered_objects(170, 230, 60, seed=3, background=0)
SEEN = np.where(LABELS == 0, 1, LABELS)


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    """Return a network for pixels of 2 m."""
    return str(write_model(tmp_path_factory.mktemp("model") / "colors.onnx", metadata=metadata(resolution=200)))


@pytest.fixture
def tiles(qgis_app):
    stack = []

    def make(**server):
        context = tile_server(**server)
        layer = QgsRasterLayer(context.__enter__(), "tiles", "wms")
        stack.append(context)
        assert layer.isValid()
        return layer

    yield make
    for context in stack:
        context.__exit__(None, None, None)


@pytest.fixture
def segment(runner, model, tmp_path):
    run = runner(SEGMENT, "INPUT", MODEL=model, EXTENT=EXTENT, OUTPUT=tmp_path / "labels.tif")
    return lambda layer, **parameters: gdal.Open(run(layer, **parameters)["OUTPUT"])


def agreement(raster) -> float:
    """Return the share of a label map's pixels with the class of the tiles at their place."""
    found = raster.ReadAsArray()
    x0, dx, _, y0, _, dy = raster.GetGeoTransform()
    rows, columns = np.mgrid[0 : found.shape[0] : 7, 0 : found.shape[1] : 7]
    crs = QgsCoordinateReferenceSystem.fromWkt(raster.GetProjection())
    to_tiles = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem("EPSG:3857"), QgsProject.instance())
    places = zip((x0 + (columns + 0.5) * dx).ravel().tolist(), (y0 + (rows + 0.5) * dy).ravel().tolist())
    moved = np.array([(p.x(), p.y()) for p in (to_tiles.transform(x, y) for x, y in places)])
    return float((labels_at(*moved.T) == found[rows, columns].ravel()).mean())


def test_map_tiles_become_a_label_map_in_the_extents_crs_at_the_models_resolution(segment, tiles, feedback):
    raster = segment(tiles())
    assert (raster.RasterXSize, raster.RasterYSize) == (600, 450)
    assert raster.GetGeoTransform() == (WEST, 2, 0, NORTH, 0, -2)
    assert agreement(raster) > 0.95
    assert "Drawing “tiles” with 600 × 450 pixels of 200 cm." in feedback.textLog()


def test_an_extent_in_web_mercator_is_drawn_true_to_scale(segment, tiles):
    to_tiles = QgsCoordinateTransform(
        QgsCoordinateReferenceSystem("EPSG:32632"), QgsCoordinateReferenceSystem("EPSG:3857"), QgsProject.instance()
    )
    one, other = to_tiles.transform(WEST, NORTH - 900), to_tiles.transform(WEST + 1200, NORTH)
    raster = segment(tiles(), EXTENT=f"{one.x()},{other.x()},{one.y()},{other.y()} [EPSG:3857]")
    assert raster.GetSpatialRef().GetAuthorityCode(None) == "32632"
    assert 600 <= raster.RasterXSize < 640 and 450 <= raster.RasterYSize < 490
    assert agreement(raster) > 0.95


def test_tiles_that_cannot_be_drawn_are_refused(segment, tiles, tmp_path):
    far = f"{WEST},{WEST + 90_000},{NORTH - 90_000},{NORTH} [EPSG:32632]"
    nameless = str(write_model(tmp_path / "any.onnx"))
    for server, given, words in (
        ({}, {"EXTENT": None}, "“tiles” has no extent of its own"),
        ({}, {"MODEL": nameless}, "has no resolution of its own"),
        ({}, {"EXTENT": far}, "more than 64 million. Choose a smaller extent"),
        ({"status": 404}, {}, "“tiles” shows nothing in the extent"),
    ):
        with pytest.raises(QgsProcessingException, match=words):
            segment(tiles(**server), **given)
    assert not (tmp_path / "labels.tif").exists()


def test_of_tiles_without_an_end_little_is_read_though_python_collects_garbage(segment, tiles, tmp_path, monkeypatch):
    is_for_raster, sent = downloads._is_for_raster, []
    timer = threading.Timer(0.5, gc.collect)
    monkeypatch.setattr(downloads, "_is_for_raster", lambda request: (gc.collect(), is_for_raster(request))[1])
    # Without the objects of earlier tests, whose collection takes about a second each time.
    gc.freeze()
    try:
        began = time.monotonic()
        timer.start()
        with pytest.raises(QgsProcessingException, match="more than 20 MB for one tile"):
            segment(tiles(sent=sent))
        # Earlier than QGIS's own timeout of a minute.
        assert time.monotonic() - began < 30
    finally:
        gc.unfreeze()
    # A few tiles and the buffers of the system; a minute of such tiles would be many gigabytes.
    assert 20e6 < sum(sent) < 1e9
    assert list(tmp_path.iterdir()) == []


def test_a_reply_that_qt_has_deleted_is_left_alone(qgis_app, monkeypatch):
    """PyQt ends the whole program if a slot raises an error in QGIS's network thread."""
    monkeypatch.setattr(downloads, "_is_for_raster", lambda request: True)
    request, manager = QNetworkRequest(QUrl("data:,tile")), QNetworkAccessManager()
    with downloads.watched_downloads() as watched:
        replies = [manager.get(request) for _ in range(2)]
        downloads._limit_reply(request, replies[0])
        for reply in replies:
            sip.delete(reply)
        watched.looks[0]()
        downloads._limit_reply(request, replies[1])
    assert len(watched.looks) == 1 and not watched.is_broken


def test_a_redirect_to_a_file_is_not_followed(segment, tiles, tmp_path):
    (tmp_path / "secret.png").write_bytes(tile_png(0, 0, 0))
    with pytest.raises(QgsProcessingException, match=r"redirects to file:.*secret\.png; SemRef reads tiles over http"):
        segment(tiles(redirect=(tmp_path / "secret.png").as_uri()))
    assert [path.name for path in tmp_path.iterdir()] == ["secret.png"]


def test_a_redirect_to_another_server_is_followed(segment, tiles):
    with tile_server() as other:
        address = other.partition("url=")[2].partition("/{z}")[0]
        assert agreement(segment(tiles(redirect=address + "{path}"))) > 0.95


def test_tiles_on_the_disk_that_the_user_named_are_drawn(segment, tmp_path):
    (tmp_path / "tile.png").write_bytes(tile_png(16, 34_800, 22_900))
    layer = QgsRasterLayer(f"type=xyz&url=file://{tmp_path}/tile.png&zmin=0&zmax=18", "tiles", "wms")
    assert layer.isValid() and segment(layer).ReadAsArray().any()


def test_a_server_that_never_ends_a_tile_is_given_up_after_a_while(segment, tiles, monkeypatch):
    monkeypatch.setattr(limits, "DRAWING_S", 1.0)
    with pytest.raises(QgsProcessingException, match="took longer than 1 s for one tile"):
        segment(tiles(delay_s=30))


def test_other_requests_are_not_changed_while_a_layer_is_drawn(tiles, tmp_path):
    (tmp_path / "own.txt").write_text("mine")
    install()
    with watched_downloads(tiles()) as downloads:
        reply = QgsNetworkAccessManager.blockingGet(QNetworkRequest(QUrl.fromLocalFile(str(tmp_path / "own.txt"))))
    assert bytes(reply.content()) == b"mine" and not downloads.is_broken


@pytest.mark.parametrize("north_up", [True, False])
def test_only_a_part_of_a_file_is_segmented(segment, model, tmp_path, north_up):
    photo = np.moveaxis(painted(LABELS), 2, 0)
    north, step = (NORTH, -2) if north_up else (NORTH - 340, 2)
    pixels = photo if north_up else photo[:, ::-1]
    image = write_raster(tmp_path / "a.tif", pixels, transform=(WEST, 2, 0, north, 0, step))
    raster = segment(str(image), EXTENT=f"{WEST + 41},{WEST + 199},{NORTH - 161},{NORTH - 59} [EPSG:32632]")
    seen = SEEN[29:81, 20:100]
    found = raster.ReadAsArray()
    np.testing.assert_array_equal(found if north_up else found[::-1], seen)
    assert raster.GetGeoTransform()[0] == WEST + 40
    assert raster.GetGeoTransform()[3] == (NORTH - 58 if north_up else NORTH - 162)


def test_an_extent_beside_the_image_or_without_a_place_is_refused(segment, tmp_path):
    photo = np.moveaxis(painted(LABELS), 2, 0)
    placed = write_raster(tmp_path / "a.tif", photo, transform=(WEST, 2, 0, NORTH, 0, -2))
    with pytest.raises(QgsProcessingException, match="does not overlap the extent"):
        segment(str(placed), EXTENT=f"{WEST - 900},{WEST - 200},{NORTH - 161},{NORTH - 59} [EPSG:32632]")
    with pytest.raises(QgsProcessingException, match="neither an extent nor a mask"):
        segment(str(write_raster(tmp_path / "b.png", photo, transform=None)))


KNOWN = {"0": "building", "1": "water", "2": "bare_land"}
AREA = scattered_objects(900, 1000, 1300, seed=5, background=0)


def area_at(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return classes of AREA (1 m pixels in EPSG:32632) at places of EPSG:3857; 0 outside."""
    places = np.column_stack([x.ravel(), y.ravel()]).tolist()
    to_area = osr.CoordinateTransformation(spatial_reference(3857), spatial_reference(32632))
    moved = np.array(to_area.TransformPoints(places))
    columns, rows = np.floor(moved[:, 0] - WEST).astype(int), np.floor(NORTH - moved[:, 1]).astype(int)
    inside = (columns >= 0) & (columns < 1000) & (rows >= 0) & (rows < 900)
    found = np.zeros(len(moved), int)
    found[inside] = AREA[rows[inside], columns[inside]]
    return found.reshape(x.shape)


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(AREA, ["unlabeled", "building", "water", "bare_land"], 300, 150)


@pytest.fixture
def framed(tiles, tmp_path):
    """Return LAYER and the MODEL that it needs, for map tiles or for a file of labels."""

    def of(kind):
        if kind == "tiles":
            network = write_model(tmp_path / "m.onnx", metadata=metadata(resolution=100, class_names=KNOWN))
            return {"LAYER": tiles(ground=area_at), "MODEL": str(network)}
        names = ["unlabeled", "building", "water", "bare_land"]
        return {"LAYER": str(write_raster(tmp_path / "map.tif", AREA, names=names))}

    return of


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["tiles", "file"])
def test_outside_of_a_mask_a_layer_that_is_tried_has_no_labels(run_algorithm, database, framed, tmp_path, kind):
    corners = [(300, 500), (500, 340), (700, 500), (500, 740), (300, 500)]
    ring = ", ".join(f"{WEST + x} {NORTH - y}" for x, y in corners)
    mask = str(write_layer(tmp_path / "mask.gpkg", [(f"POLYGON (({ring}))", "a")]))
    outputs = {"OUTPUT": str(tmp_path / "p.gpkg"), "LABELS": str(tmp_path / "labels")}
    given = {"DATABASE": database, "METHOD": 2, "MASK": mask, **framed(kind), **outputs}
    result = run_algorithm("semref:localizeimages", given)
    (row,) = read_rows(result["OUTPUT"])
    # The middle of the area around the polygon.
    assert (row["x"], row["y"]) == pytest.approx((WEST + 500, NORTH - 540), abs=2)
    (made,) = (tmp_path / "labels").glob("*.tif")
    labels = read_pixels(made)
    assert labels.shape == (400, 400)
    down, right = np.mgrid[:400, :400] + 0.5
    edges = [(b[0] - a[0], b[1] - a[1], a) for a, b in zip(corners, corners[1:])]
    away = [(dx * (down + 340 - a[1]) - dy * (right + 300 - a[0])) / np.hypot(dx, dy) for dx, dy, a in edges]
    inside = np.min(away, axis=0)
    assert not labels[inside < -1].any()
    # The network of the tiles has no unlabeled ground.
    seen = AREA[340:740, 300:700]
    shown = (inside > 1) & (seen > 0)
    assert (labels[shown] == seen[shown]).mean() > 0.9


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["tiles", "file"])
def test_a_place_framed_on_a_layer_is_localized_as_an_image(run_algorithm, database, framed, tmp_path, kind):
    more = framed(kind)
    extent = f"{WEST + 300},{WEST + 650},{NORTH - 700},{NORTH - 350} [EPSG:32632]"
    given = {"DATABASE": database, "METHOD": 2, "EXTENT": extent, "OUTPUT": str(tmp_path / "p.gpkg"), **more}
    result = run_algorithm("semref:localizeimages", given)
    assert result["FIX_COUNT"] == 1
    (row,) = read_rows(result["OUTPUT"])
    assert (row["x"], row["y"]) == pytest.approx((WEST + 475, NORTH - 525), abs=2)
    assert gdal.Open(row["image"]).RasterXSize == 350
