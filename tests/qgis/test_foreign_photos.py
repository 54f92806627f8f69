"""Images of another continent on a map of buildings only: no position and no ambiguity."""

import numpy as np
import pytest
from osgeo import gdal

from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.storage.database.reader import read_database


@pytest.fixture(scope="module")
def town(real_data, run_algorithm, tmp_path_factory):
    """Return a localizer on the buildings of Banepa, Nepal."""
    folder = tmp_path_factory.mktemp("town")
    labels, database = str(folder / "labels.tif"), str(folder / "town.gpkg")
    drawn = {"INPUT": str(real_data("banepa/banepa_buildings.gpkg")), "CLASS": "building", "PIXEL_SIZE": 0.5}
    run_algorithm("semref:rasterizeannotation", {**drawn, "OUTPUT": labels})
    sizes = {"WINDOW_SIZE": 150, "STRIDE": 40, "MINIMUM_AREA": 12}
    run_algorithm(
        "semref:builddatabase", {"LABELS": labels, "REFERENCE_CLASSES": "building", "DATABASE": database, **sizes}
    )
    return Localizer(read_database(database, with_overview=True))


@pytest.mark.real_data
@pytest.mark.slow
@pytest.mark.parametrize("tile", [1, 2, 4, 6])
def test_buildings_of_another_continent_are_neither_placed_nor_called_ambiguous(town, real_data, tile):
    labels = gdal.Open(str(real_data(f"dubai_aerial/tile{tile}_label.tif"))).ReadAsArray()
    crops = [
        labels[row : row + 512, column : column + 512]
        for row in range(0, labels.shape[0] - 511, 512)
        for column in range(0, labels.shape[1] - 511, 512)
    ]
    images = [np.where(crop == 1, 1, 2).astype(np.uint8) for crop in crops if (crop == 1).sum() >= 500]
    assert images
    statuses = {town.localize(image, Method.AUTOMATIC).status.key for image in images}
    assert statuses <= {"no_match", "too_few_references"}
