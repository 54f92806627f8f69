"""The zip works under qgis_process, unpacked into a new profile."""

import configparser
import json
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from made_inputs import read_pixels, square, write_layer

pytestmark = pytest.mark.slow

TIMEOUT_S = 600


@pytest.fixture(scope="module")
def package(repository, tmp_path_factory) -> Path:
    target = tmp_path_factory.mktemp("package") / "semref.zip"
    make_package(repository, target)
    return target


def make_package(repository: Path, target: Path) -> None:
    command = [sys.executable, str(repository / "tools" / "release" / "package.py"), "--output", str(target)]
    subprocess.run(command, check=True, timeout=TIMEOUT_S)


@pytest.fixture(scope="module")
def installed(package, start_qgis_process):
    def install(plugins):
        with zipfile.ZipFile(package) as archive:
            archive.extractall(plugins)

    return start_qgis_process(install)


def test_the_same_source_gives_the_same_zip(package, repository, tmp_path):
    make_package(repository, tmp_path / "again.zip")
    assert (tmp_path / "again.zip").read_bytes() == package.read_bytes()


def test_metadata_state_the_versions_of_qgis_and_the_provider(package):
    """Files and fields of the zip: tests/tools/test_release.py."""
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read_string(zipfile.ZipFile(package).read("semref/metadata.txt").decode("utf-8"))
    general = metadata["general"]
    assert (general["qgisMinimumVersion"], general["qgisMaximumVersion"]) == ("3.22", "4.99")
    assert general["hasProcessingProvider"] == "yes" and "supportsQt6" not in general


def test_qgis_process_lists_and_runs_the_algorithms_of_the_installed_zip(installed, tmp_path):
    assert "semref:rasterizeannotation" in installed("list")
    features = [(square(0, 0, 100), "field", 0), (square(40, 40, 20), "building", 1)]
    layer = write_layer(tmp_path / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    given = {"INPUT": f"{layer}|layername=annotation", "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    given |= {"PIXEL_SIZE": 1, "OUTPUT": tmp_path / "labels.tif"}
    words = [f"{key}={value}" for key, value in given.items()]
    answer = json.loads(installed("--json", "run", "semref:rasterizeannotation", "--", *words))
    assert answer["results"]["CLASS_COUNT"] == 2
    labels = read_pixels(tmp_path / "labels.tif")
    assert labels.shape == (100, 100) and (labels == labels[50, 50]).sum() == 400
    assert (labels == labels[0, 0]).sum() == 10000 - 400
