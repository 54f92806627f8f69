"""One valid input of each kind, and runs that must be refused."""

from pathlib import Path

import pytest
from bad_input import BUILD, COMPARE, DECODE, DESCRIBE, LOCALIZE, OUTPUT_NAMES, RASTERIZE, SEGMENT, WINDOWS, sentence_of
from made_inputs import write_older
from qgis.core import QgsProcessingException


@pytest.fixture
def defaults(good, tmp_path):
    """Return working parameters of each algorithm; outputs are in tmp_path/out."""
    (tmp_path / "out").mkdir()
    classes = str(good / "classes.csv")
    found = {
        RASTERIZE: {"INPUT": str(good / "annotation.gpkg"), "CLASS_FIELD": "class", "PIXEL_SIZE": 1},
        DECODE: {"INPUT": str(good / "color.png"), "CLASS_TABLE": classes, "METHOD": 1},
        BUILD: {"LABELS": str(good / "labels.tif"), **WINDOWS},
        DESCRIBE: {"INPUT": str(good / "photo.png"), "CLASS_TABLE": classes, "REFERENCES": "TEMPORARY_OUTPUT"},
        LOCALIZE: {"DATABASE": str(good / "area.gpkg"), "IMAGES": [str(good / "photo.png")], "METHOD": 1},
        SEGMENT: {"INPUT": str(good / "color.png"), "MODEL": str(good / "colors.onnx")},
        COMPARE: {"REFERENCE": str(good / "labels.tif"), "PREDICTED": str(good / "labels.tif")},
    }
    for algorithm, (key, name) in OUTPUT_NAMES.items():
        found[algorithm][key] = str(tmp_path / "out" / name)
    return found


@pytest.fixture
def refused(run_algorithm, defaults, tmp_path, feedback):
    """`refused(algorithm, **parameters)` returns the message; an older output of the same name must stay."""

    def run(algorithm, **parameters):
        older = Path(defaults[algorithm][OUTPUT_NAMES[algorithm][0]])
        before = write_older(older)
        with pytest.raises(QgsProcessingException) as caught:
            run_algorithm(algorithm, {**defaults[algorithm], **parameters}, feedback)
        assert older.read_bytes() == before
        assert [path.name for path in older.parent.iterdir()] == [older.name]
        return sentence_of(caught.value)

    return run
