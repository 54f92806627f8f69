"""The zip works under qgis_process, unpacked into a new profile."""

import configparser
import json
import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest
from osgeo import gdal, ogr, osr

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
def qgis_process(package, tmp_path_factory):
    """`qgis_process(*arguments)` runs with the unpacked plugin in a new profile and returns its JSON."""
    # Debian 12's wrapper qgis_process passes on an option that its own qgis_process.bin does not support.
    program = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
    if program is None:
        pytest.skip("qgis_process is not installed")
    home = tmp_path_factory.mktemp("home")
    plugins = home / ".local" / "share" / "QGIS" / "QGIS3" / "profiles" / "default" / "python" / "plugins"
    plugins.mkdir(parents=True)
    with zipfile.ZipFile(package) as archive:
        archive.extractall(plugins)
    environment = {
        "PATH": os.environ["PATH"],
        "LANG": "C.UTF-8",
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(tmp_path_factory.mktemp("runtime")),
        "QT_QPA_PLATFORM": "offscreen",
        # OpenCV of a virtual environment, if there is one: qgis_process runs the system's Python.
        "PYTHONPATH": sysconfig.get_path("purelib"),
    }

    def run(*arguments: str, json_output: bool = True):
        command = [program, *(["--json"] if json_output else []), *arguments]
        result = subprocess.run(
            command, env=environment, cwd=home, capture_output=True, text=True, timeout=TIMEOUT_S, check=False
        )
        assert result.returncode == 0, f"{command} exits {result.returncode}:\n{result.stdout}\n{result.stderr}"
        assert "Traceback" not in result.stderr, result.stderr
        return json.loads(result.stdout) if json_output else result.stdout

    run("plugins", "enable", "processing", json_output=False)
    run("plugins", "enable", "semref", json_output=False)
    return run


@pytest.fixture
def annotation(tmp_path) -> Path:
    """Return a GeoPackage with a building of 20 × 20 m in a field of 100 × 100 m."""
    path = tmp_path / "annotation.gpkg"
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(32632)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer("annotation", crs, ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("class", ogr.OFTString))
    layer.CreateField(ogr.FieldDefn("zorder", ogr.OFTInteger))
    for name, order, west, south, size in (("field", 0, 0, 0, 100), ("building", 1, 40, 40, 20)):
        feature = ogr.Feature(layer.GetLayerDefn())
        feature["class"] = name
        feature["zorder"] = order
        west, south = 550000 + west, 5220000 + south
        ring = ((west, south), (west + size, south), (west + size, south + size), (west, south + size), (west, south))
        corners = ", ".join(f"{x} {y}" for x, y in ring)
        feature.SetGeometry(ogr.CreateGeometryFromWkt(f"POLYGON (({corners}))"))
        layer.CreateFeature(feature)
    return path


def test_the_zip_has_one_folder_with_what_the_plugin_repository_asks_for(package):
    names = zipfile.ZipFile(package).namelist()
    assert {name.partition("/")[0] for name in names} == {"semref"}
    assert {"semref/metadata.txt", "semref/LICENSE", "semref/__init__.py", "semref/resources/icon.svg"} <= set(names)


def test_the_zip_has_nothing_hidden_compiled_or_for_developers(package):
    names = zipfile.ZipFile(package).namelist()
    assert [name for name in names if "/." in name or name.endswith(".pyc")] == []
    assert [name for name in names if name.split("/")[1] in ("tests", "tools", "docs")] == []


def test_the_same_source_gives_the_same_zip(package, repository, tmp_path):
    make_package(repository, tmp_path / "again.zip")
    assert (tmp_path / "again.zip").read_bytes() == package.read_bytes()


def test_metadata_names_all_that_the_plugin_repository_requires(package):
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read_string(zipfile.ZipFile(package).read("semref/metadata.txt").decode("utf-8"))
    general = metadata["general"]
    required = [
        "name",
        "description",
        "about",
        "version",
        "qgisMinimumVersion",
        "author",
        "email",
        "tracker",
        "repository",
        "license",
        "icon",
    ]
    assert [key for key in required if not general.get(key)] == []
    assert (general["qgisMinimumVersion"], general["qgisMaximumVersion"]) == ("3.22", "4.99")
    assert general["hasProcessingProvider"] == "yes"
    assert "supportsQt6" not in general


def test_qgis_process_lists_the_provider_of_the_installed_zip(qgis_process):
    assert "semref:rasterizeannotation" in qgis_process("list", json_output=False)


def test_qgis_process_runs_an_algorithm_of_the_installed_zip(qgis_process, annotation, tmp_path):
    target = tmp_path / "labels.tif"
    answer = qgis_process(
        "run",
        "semref:rasterizeannotation",
        "--",
        f"INPUT={annotation}|layername=annotation",
        "CLASS_FIELD=class",
        "PRIORITY_FIELD=zorder",
        "PIXEL_SIZE=1",
        f"OUTPUT={target}",
    )
    assert answer["results"]["CLASS_COUNT"] == 2
    labels = gdal.Open(str(target))
    assert (labels.RasterXSize, labels.RasterYSize) == (100, 100)
    values = list(labels.ReadRaster(0, 0, 100, 100))
    building = values[50 * 100 + 50]
    assert values.count(building) == 400
    assert values.count(values[0]) == 10000 - 400
