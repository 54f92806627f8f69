import gc
from pathlib import Path

import numpy as np
import pytest
from bad_input import BUILD, COMPARE, DECODE, DESCRIBE, LABELS, LOCALIZE, OUTPUT_NAMES, RASTERIZE, SEGMENT, sentence_of
from made_inputs import NAMES, square, write_layer, write_older, write_raster
from qgis.core import QgsProcessingException

WRITERS = list(OUTPUT_NAMES)


def output_refused(run_algorithm, defaults, algorithm, path) -> str:
    key = OUTPUT_NAMES[algorithm][0]
    with pytest.raises(QgsProcessingException) as caught:
        run_algorithm(algorithm, {**defaults[algorithm], key: str(path)})
    return sentence_of(caught.value)


UNWRITABLE = {
    "nowhere": [one for one in WRITERS if one not in (LOCALIZE, COMPARE)],
    "a file": WRITERS,
    # Not even root can write there.
    "/proc": WRITERS,
}


@pytest.mark.parametrize(
    ("folder", "algorithm"), [(folder, one) for folder, writers in UNWRITABLE.items() for one in writers]
)
def test_an_output_in_a_folder_that_cannot_be_written_is_refused(run_algorithm, defaults, tmp_path, folder, algorithm):
    if folder == "/proc" and not Path("/proc/self").exists():
        pytest.skip("no /proc on this machine")
    (tmp_path / "a file").write_text("a file")
    path = tmp_path / folder / OUTPUT_NAMES[algorithm][1]
    assert folder in output_refused(run_algorithm, defaults, algorithm, path)
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, BUILD, DESCRIBE, SEGMENT])
def test_an_output_that_is_a_folder_is_refused(run_algorithm, defaults, tmp_path, algorithm):
    folder = tmp_path / OUTPUT_NAMES[algorithm][1]
    folder.mkdir()
    assert folder.name in output_refused(run_algorithm, defaults, algorithm, folder)
    assert list(folder.iterdir()) == []


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, BUILD])
def test_a_full_disk_is_reported_and_leaves_nothing(run_algorithm, defaults, small_disk, tmp_path, algorithm):
    random = np.random.default_rng(1)
    parameters = defaults[algorithm]
    if algorithm == RASTERIZE:
        features = [(square(*random.uniform(0, 600, 2), 4), n % 200 + 1) for n in range(8_000)]
        parameters["INPUT"] = str(write_layer(tmp_path / "a.shp", features, [("class", "integer")]))
        parameters["PIXEL_SIZE"] = 0.2
    elif algorithm == DECODE:
        image = random.integers(0, 255, (3, 600, 600)).astype(np.uint8)
        parameters["INPUT"] = str(write_raster(tmp_path / "a.tif", image))
    else:
        labels = write_raster(tmp_path / "a.tif", LABELS, names=NAMES)
        parameters.update(LABELS=str(labels), WINDOW_SIZE=50, STRIDE=5)
    disk = small_disk(60)
    target = disk / OUTPUT_NAMES[algorithm][1]
    before = write_older(target)
    sentence = output_refused(run_algorithm, defaults, algorithm, target)
    assert "full" in sentence and ".part" not in sentence
    assert target.read_bytes() == before
    assert [path.name for path in disk.iterdir()] == [target.name]
    # GDAL objects that failed to close must not be closed again, which would end the process.
    gc.collect()
