import json
from pathlib import Path

import numpy as np
import pytest
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, read_pixels, scattered_objects, write_raster
from osgeo import gdal
from qgis.core import QgsProcessingException, QgsProcessingFeedback

from semref.storage.images import GdalImage

EXPORT = "semref:exporttrainingtiles"
HEIGHT, WIDTH, TILE = 320, 480, 32
LABELS = scattered_objects(HEIGHT, WIDTH, 150, seed=5)


def photo_of(labels: np.ndarray, kind=np.uint8, bands: int = 3) -> np.ndarray:
    """Return (bands, H, W): each band has a value that depends on label and place."""
    place = np.add.outer(np.arange(labels.shape[0]), np.arange(labels.shape[1])) % 7
    factor = np.iinfo(kind).max // 300 + 1
    return np.stack([(labels * 20 + place + band) * factor for band in range(bands)]).astype(kind)


@pytest.fixture
def export(run_algorithm, feedback, tmp_path):
    """`export(image, labels, **parameters)` returns the results and the manifest; inputs are paths or arrays."""

    def run(image=None, labels=LABELS, **parameters):
        image = photo_of(LABELS) if image is None else image
        if isinstance(image, np.ndarray):
            image = write_raster(tmp_path / "image.tif", image, nodata=None if image.any() else 0)
        if isinstance(labels, np.ndarray):
            labels = write_raster(tmp_path / "labels.tif", labels, names=NAMES)
        defaults = {"TILE_SIZE": TILE, "STRIDE": TILE, "OUTPUT": str(tmp_path / "tiles")}
        result = run_algorithm(EXPORT, {"IMAGE": str(image), "LABELS": str(labels), **defaults, **parameters}, feedback)
        manifest = json.loads((Path(result["OUTPUT"]) / "manifest.json").read_text(encoding="utf-8"))
        return result, manifest

    return run


def part_of(tile):
    return np.s_[..., tile["row"] : tile["row"] + TILE, tile["column"] : tile["column"] + TILE]


def tile_pairs(folder, manifest, suffix="png"):
    """Return (entry, image (bands, h, w), labels) of each tile."""
    for tile in manifest["tiles"]:
        stem = Path(folder) / tile["subset"]
        image, labels = stem / "images" / f"{tile['name']}.{suffix}", stem / "labels" / f"{tile['name']}.png"
        yield tile, read_pixels(image), read_pixels(labels)


def test_every_tile_is_the_piece_that_its_name_states(export):
    result, manifest = export()
    assert result["TILE_COUNT"] == len(manifest["tiles"]) > 50
    rows = (Path(result["OUTPUT"]) / "classes.csv").read_text(encoding="utf-8").splitlines()
    assert [row.split(",")[1] for row in rows[1:]] == NAMES[1:]
    photo = photo_of(LABELS)
    for tile, image, labels in tile_pairs(result["OUTPUT"], manifest):
        np.testing.assert_array_equal(labels, LABELS[part_of(tile)])
        np.testing.assert_array_equal(image, photo[part_of(tile)])
        assert tile["name"] == f"{tile['column']}_{tile['row']}"
        assert (tile["x"], tile["y"]) == (WEST + tile["column"], NORTH - tile["row"])


def test_tiles_without_labels_are_left_out(export):
    labels = LABELS.copy()
    labels[:, : 5 * TILE] = 0
    labels[40, 40] = 1
    _, manifest = export(labels=labels, VALIDATION_FRACTION=0)
    assert min(t["column"] for t in manifest["tiles"] if t["row"] != TILE) == 5 * TILE
    assert [t["column"] for t in manifest["tiles"] if t["row"] == TILE][0] == TILE


@pytest.mark.slow
def test_statistics_are_those_of_the_written_tiles(export):
    result, manifest = export(STRIDE=20)
    pixels = {"train": np.zeros(256, int), "validation": np.zeros(256, int)}
    seen = []
    for tile, image, labels in tile_pairs(result["OUTPUT"], manifest):
        pixels[tile["subset"]] += np.bincount(labels.ravel(), minlength=256)
        if tile["subset"] == "train":
            seen.append(image.reshape(3, -1) / 255)
    for subset, counts in pixels.items():
        expected = {str(value): int(counts[value]) for value in np.flatnonzero(counts)}
        assert manifest["statistics"]["class_pixels"][subset] == expected
    values = np.concatenate(seen, axis=1)
    np.testing.assert_allclose(manifest["statistics"]["band_mean"], values.mean(axis=1), rtol=1e-9)
    np.testing.assert_allclose(manifest["statistics"]["band_std"], values.std(axis=1), rtol=1e-6)


@pytest.mark.parametrize("crs", [METRIC_CRS, None])
def test_labels_on_another_grid_are_brought_onto_the_image(export, tmp_path, crs):
    coarse = scattered_objects(HEIGHT // 4, WIDTH // 4, 40, seed=8)
    half_off = (WEST - 8.0, 4.0, 0.0, NORTH + 4.0, 0.0, -4.0)
    labels = write_raster(tmp_path / "coarse.tif", coarse, transform=half_off, names=NAMES, crs=crs)
    result, manifest = export(labels=labels)
    columns = (np.arange(WIDTH) + 0.5 + 8) // 4
    rows = (np.arange(HEIGHT) + 0.5 + 4) // 4
    padded = np.pad(coarse, ((0, 2), (0, 3)))  # Beyond the label map all pixels are unlabeled.
    expected = padded[np.ix_(rows.astype(int), columns.astype(int))]
    for tile, _, found in tile_pairs(result["OUTPUT"], manifest):
        np.testing.assert_array_equal(found, expected[part_of(tile)])


@pytest.mark.slow
def test_labels_in_another_crs_are_brought_onto_the_image(export, tmp_path):
    source = gdal.Open(str(write_raster(tmp_path / "utm.tif", LABELS, names=NAMES)))
    gdal.Warp(str(tmp_path / "other.tif"), source, dstSRS="EPSG:25833", xRes=0.5, yRes=0.5).FlushCache()
    result, manifest = export(labels=tmp_path / "other.tif")
    agree = total = 0
    for tile, _, found in tile_pairs(result["OUTPUT"], manifest):
        agree, total = agree + int((found == LABELS[part_of(tile)]).sum()), total + found.size
    assert agree > 0.97 * total


def test_rasters_without_georeference_fit_by_their_pixels_and_are_refused_if_their_sizes_differ(export, tmp_path):
    image = write_raster(tmp_path / "plain.png", photo_of(LABELS), transform=None)
    small = write_raster(tmp_path / "small.png", LABELS[:100], transform=None)
    with pytest.raises(QgsProcessingException, match="480 × 100 pixels, the image 480 × 320"):
        export(image=image, labels=small)
    _, manifest = export(image=image, labels=write_raster(tmp_path / "plain_labels.png", LABELS, transform=None))
    assert (manifest["crs"], manifest["geotransform"], manifest["pixel_size"]) == ("", None, None)
    assert len(manifest["tiles"]) > 50


def test_sixteen_bits_and_four_bands_become_geotiffs_with_all_values_and_a_stretch(export, tmp_path):
    image = photo_of(LABELS, np.uint16, bands=4)
    deep = write_raster(tmp_path / "deep.tif", image, kind=gdal.GDT_UInt16)
    result, manifest = export(image=deep, VALIDATION_FRACTION=0)
    assert (manifest["band_count"], manifest["data_type"], manifest["network_bands"]) == (4, "UInt16", [1, 2, 3])
    for tile, found, _ in tile_pairs(result["OUTPUT"], manifest, "tif"):
        np.testing.assert_array_equal(found, image[part_of(tile)])
    seen = GdalImage(str(deep))
    np.testing.assert_allclose(manifest["stretch"], seen.stretch)
    shown = seen.read(0, 0, WIDTH, HEIGHT)[0] / 255
    np.testing.assert_allclose(manifest["statistics"]["band_mean"], shown.mean(axis=(0, 1)), rtol=1e-9)
    np.testing.assert_allclose(manifest["statistics"]["band_std"], shown.std(axis=(0, 1)), rtol=1e-6)


def test_where_the_image_has_no_data_the_labels_are_cleared(export, tmp_path):
    image = photo_of(LABELS) + 1
    image[:, 100:160, 64:128] = 0
    image = write_raster(tmp_path / "gap.tif", image, nodata=0)
    result, manifest = export(image=image, VALIDATION_FRACTION=0)
    names = {tile["name"]: labels for tile, _, labels in tile_pairs(result["OUTPUT"], manifest)}
    assert "64_128" not in names
    assert not names["64_96"][4:].any()
    np.testing.assert_array_equal(names["64_96"][:4], LABELS[96:100, 64:96])


def test_an_earlier_export_and_any_filled_folder_are_not_changed(export):
    """Files that the user added among the tiles must not be deleted."""
    first, _ = export(STRIDE=64)
    before = sorted(Path(first["OUTPUT"]).rglob("*"))
    with pytest.raises(QgsProcessingException, match="holds other files"):
        export(STRIDE=20)
    assert sorted(Path(first["OUTPUT"]).rglob("*")) == before


@pytest.mark.parametrize(
    ("labels", "parameters", "sentence"),
    [
        (np.zeros_like(LABELS), {}, "No pixel of the image is labeled"),
        (LABELS, {"TILE_SIZE": 400}, "480 × 320 pixels, less than one tile of 400"),
        (LABELS, {"TILE_SIZE": 256, "STRIDE": 256}, "smaller tiles or another"),
        (np.where(LABELS == 1, 9, LABELS), {}, "the value 9, which the class table lacks"),
        (LABELS, {"image": np.full((3, HEIGHT, WIDTH), 37, np.uint8)}, "the same color everywhere"),
        (LABELS, {"image": np.zeros((3, HEIGHT, WIDTH), np.uint8)}, "has no data where the ground is labeled"),
        (LABELS, {"OUTPUT": f"{__file__}/tiles"}, "can't be written: .*; choose another place"),
    ],
)
def test_impossible_exports_are_refused_with_a_reason(export, tmp_path, labels, parameters, sentence):
    with pytest.raises(QgsProcessingException, match=sentence):
        export(labels=labels.astype(np.uint8), **parameters)
    assert not (tmp_path / "tiles").exists()


def test_a_cancel_leaves_nothing(run_algorithm, tmp_path):
    class Canceling(QgsProcessingFeedback):
        def __init__(self):
            super().__init__(False)
            self.progressChanged.connect(lambda progress: self.cancel() if progress > 50 else None)

    image = write_raster(tmp_path / "image.tif", photo_of(LABELS))
    labels = write_raster(tmp_path / "labels.tif", LABELS, names=NAMES)
    before = sorted(tmp_path.iterdir())
    parameters = {"IMAGE": str(image), "LABELS": str(labels), "TILE_SIZE": TILE, "STRIDE": TILE}
    with pytest.raises(QgsProcessingException, match="Canceled"):
        run_algorithm(EXPORT, {**parameters, "OUTPUT": str(tmp_path / "tiles")}, Canceling())
    assert sorted(tmp_path.iterdir()) == before
