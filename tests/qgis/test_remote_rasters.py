"""Rasters on a server (/vsicurl) are read in pieces and give the same results as local files."""

import re
from pathlib import Path

import numpy as np
import pytest
from listening import Handler, serving
from made_inputs import NORTH, WEST, read_rows, scattered_objects, write_raster
from made_models import metadata, painted, write_model
from osgeo import gdal
from qgis.core import QgsRasterLayer

LABELS = scattered_objects(1500, 1500, 900, seed=11, background=0)
PART = LABELS[300:460, 500:660]


@pytest.fixture
def served(tmp_path):
    """`served(path)`: its name on a web server with byte ranges; ``served.sent`` counts the bytes."""
    folder = tmp_path / "served"
    folder.mkdir()

    class Files(Handler):
        protocol_version = "HTTP/1.1"

        def do_GET(self):
            path = folder / Path(self.path).name
            if not path.is_file():
                self.send_error(404)
                return
            data = path.read_bytes()
            first, last = 0, len(data) - 1
            asked = re.fullmatch(r"bytes=(\d+)-(\d*)", self.headers.get("Range", ""))
            if asked:
                first, last = int(asked[1]), min(int(asked[2] or last), last)
            self.send_response(206 if asked else 200)
            if asked:
                self.send_header("Content-Range", f"bytes {first}-{last}/{len(data)}")
            self.send_header("Accept-Ranges", "bytes")
            self.send_header("Content-Length", str(last - first + 1))
            self.end_headers()
            if self.command == "GET":
                self.wfile.write(data[first : last + 1])
                sent.append(last - first + 1)

        do_HEAD = do_GET

    def name(path: Path) -> str:
        path.rename(folder / path.name)
        return f"/vsicurl/{server.url}/{path.name}"

    sent = name.sent = []
    with serving(Files) as server:
        yield name


def photo(path: Path, labels: np.ndarray, **options) -> Path:
    """Return a tiled GeoTIFF like a COG, so that parts can be read separately."""
    plain = write_raster(path.with_suffix(".plain.tif"), np.moveaxis(painted(labels), 2, 0), **options)
    gdal.Translate(str(path), str(plain), creationOptions=["TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256"])
    return path


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    return str(write_model(tmp_path_factory.mktemp("model") / "colors.onnx", metadata=metadata(resolution=100)))


def test_a_part_of_an_orthophoto_on_a_server_is_segmented_without_the_rest(run_algorithm, model, served, tmp_path):
    file = photo(tmp_path / "ortho.tif", LABELS)
    size = file.stat().st_size
    extent = f"{WEST + 500},{WEST + 660},{NORTH - 460},{NORTH - 300} [EPSG:32632]"
    given = {"MODEL": model, "EXTENT": extent}
    near = run_algorithm("semref:segmentimage", {"INPUT": str(file), "OUTPUT": str(tmp_path / "near.tif"), **given})
    # As a layer of the project: Processing of older QGIS does not accept such a name.
    layer = QgsRasterLayer(served(file), "ortho", "gdal")
    assert layer.isValid()
    # QGIS has read all of it for its contrast; later reads are the algorithm's.
    served.sent.clear()
    far = {"INPUT": layer, "OUTPUT": str(tmp_path / "far.tif"), **given}
    results = [gdal.Open(found["OUTPUT"]) for found in (near, run_algorithm("semref:segmentimage", far))]
    assert results[0].GetGeoTransform() == results[1].GetGeoTransform()
    np.testing.assert_array_equal(results[1].ReadAsArray(), results[0].ReadAsArray())
    np.testing.assert_array_equal(results[1].ReadAsArray()[PART > 0], PART[PART > 0])
    assert 0 < sum(served.sent) < size / 3


def test_a_photo_on_a_server_is_localized_as_one_on_the_disk(run_algorithm, build_area, model, served, tmp_path):
    labels = np.where(LABELS == 0, 1, LABELS)
    names = ["unlabeled", "building", "water", "bare_land"]
    database = build_area(labels[:600, :800], names, 160, 80, "water;bare_land")
    file = photo(tmp_path / "photo.tif", labels[200:520, 300:620], transform=None)
    rows = []
    for name in (str, served):
        given = {"DATABASE": database, "MODEL": model, "IMAGES": [name(file)], "METHOD": 2}
        found = run_algorithm("semref:localizeimages", {**given, "OUTPUT": str(tmp_path / f"{len(rows)}.gpkg")})
        rows += read_rows(found["OUTPUT"])
    near, far = rows
    assert near["status"] == far["status"] == "fix"
    assert (far["x"], far["y"], far["error_95"]) == (near["x"], near["y"], near["error_95"])


def test_a_file_missing_on_the_server_is_reported(run_algorithm, model, served, tmp_path):
    (tmp_path / "gone.tif").write_bytes(b"")
    name = served(tmp_path / "gone.tif").replace("gone", "never")
    given = {"INPUT": name, "MODEL": model, "OUTPUT": str(tmp_path / "labels.tif")}
    with pytest.raises(Exception, match="INPUT|never"):
        run_algorithm("semref:segmentimage", given)
    assert not (tmp_path / "labels.tif").exists()
