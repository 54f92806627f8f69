"""Outputs where the plugin is not: the programs of GDAL, and a plain QGIS, open each of them, as it should look."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from made_inputs import rectangle, scattered_objects, turned_view, write_layer, write_raster

NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
LABELS = scattered_objects(420, 480, 260, seed=21)
LOOKS = {
    "area.gpkg|windows": "singleSymbol",
    "area.gpkg|references": "categorizedSymbol",
    "issues.gpkg|issues": "categorizedSymbol",
    "positions.gpkg|positions": "RuleRenderer",
    "footprints.gpkg|footprints": "singleSymbol",
    "squares.gpkg|squares": "graduatedSymbol",
    "trials.gpkg|trials": "RuleRenderer",
    "burned.tif|": "paletted",
}
"""What draws each layer."""

PLAIN = """
import json, os, sys
from pathlib import Path
from qgis.core import QgsApplication, QgsRasterLayer, QgsVectorLayer

application = QgsApplication([], False)
application.initQgis()
found = {}
for path in sys.argv[1:]:
    name = Path(path).name
    if path.endswith(".tif"):
        layers = {"": QgsRasterLayer(path, name)}
    else:
        whole = QgsVectorLayer(path, name, "ogr")
        names = [part.split("!!::!!")[1] for part in whole.dataProvider().subLayers()]
        layers = {one: QgsVectorLayer(f"{path}|layername={one}", one, "ogr") for one in names}
    for one, layer in layers.items():
        is_vector = isinstance(layer, QgsVectorLayer)
        if is_vector and not layer.isSpatial():
            continue
        layer.loadDefaultMetadata()
        titles = [layer.attributeDisplayName(n) for n in layer.attributeList()] if is_vector else []
        keys = [field.name() for field in layer.fields()] if is_vector else []
        found[f"{name}|{one}"] = {
            "valid": layer.isValid(),
            "crs": layer.crs().authid(),
            "renderer": layer.renderer().type() if layer.renderer() else "",
            "styled": layer.loadDefaultStyle()[1],
            "titled": sum(title != key for title, key in zip(titles, keys)),
            "abstract": layer.metadata().abstract(),
        }
        del layer
    layers.clear()
found["plugin"] = any(name.startswith("semref") for name in sys.modules)
Path(os.environ["FOUND"]).write_text(json.dumps(found), encoding="utf-8")
os._exit(0)
"""


@pytest.fixture(scope="module")
def outputs(run_algorithm, tmp_path_factory) -> dict[str, str]:
    """Paths by name: a file of each kind that a person opens."""
    folder = tmp_path_factory.mktemp("outputs")
    path = {name: str(folder / name) for name in {look.partition("|")[0] for look in LOOKS}}
    labels = str(write_raster(folder / "labels.tif", LABELS, names=NAMES))
    fields = [(rectangle(20 * n, 15 * n, 60, 40), NAMES[1 + n % 4]) for n in range(12)]
    annotation = {"INPUT": str(write_layer(folder / "annotation.gpkg", fields)), "CLASS_FIELD": "class"}
    run_algorithm("semref:rasterizeannotation", {**annotation, "PIXEL_SIZE": 1, "OUTPUT": path["burned.tif"]})
    run_algorithm("semref:checkannotation", {**annotation, "ISSUES": path["issues.gpkg"]})
    run_algorithm(
        "semref:builddatabase",
        {
            "LABELS": labels,
            "REFERENCE_CLASSES": "building;water;bare_land",
            "WINDOW_SIZE": 160,
            "STRIDE": 40,
            "MINIMUM_AREA": 30,
            "DATABASE": path["area.gpkg"],
        },
    )
    database = {"DATABASE": path["area.gpkg"]}
    image = write_raster(folder / "image.png", turned_view(LABELS, 160, 230, 200, 30), transform=None)
    found = {"OUTPUT": path["positions.gpkg"], "FOOTPRINTS": path["footprints.gpkg"]}
    results = run_algorithm("semref:localizeimages", {**database, "IMAGES": [str(image)], **found})
    assert results["FIX_COUNT"] == 1
    run_algorithm("semref:assessdatabase", {**database, "TRIALS": 20, "OUTPUT": path["squares.gpkg"]})
    tried = {"LABELS": labels, "TRIALS": 4, "METHODS": [1], "OUTPUT": path["trials.gpkg"], "REPORT": None}
    run_algorithm("semref:evaluatelocalization", {**database, **tried})
    return path


@pytest.mark.slow
def test_a_qgis_without_the_plugin_draws_every_output_as_it_is_meant(outputs, tmp_path):
    told = tmp_path / "found.json"
    quiet = {"QT_QPA_PLATFORM": "offscreen", "FOUND": str(told), "QGIS_CUSTOM_CONFIG_PATH": str(tmp_path / "profile")}
    # An own process: in this one the plugin's code would be at hand.
    command = [sys.executable, "-c", PLAIN, *outputs.values()]
    ended = subprocess.run(command, cwd=tmp_path, env={**os.environ, **quiet}, capture_output=True, timeout=600)
    assert told.is_file(), ended.stderr.decode(errors="replace")
    found = json.loads(told.read_text(encoding="utf-8"))
    assert found.pop("plugin") is False
    assert sorted(found) == sorted(LOOKS)
    for name, layer in found.items():
        assert layer["valid"] and layer["crs"].startswith("EPSG:"), name
        assert layer["renderer"] == LOOKS[name], (name, layer["renderer"])
        assert layer["styled"] and layer["abstract"], name
        assert layer["titled"] > 0 or name.endswith(".tif|"), name


@pytest.mark.slow
@pytest.mark.parametrize("program", ["ogrinfo", "gdalinfo"])
def test_the_plain_programs_of_gdal_read_every_output_without_a_complaint(outputs, program, tmp_path):
    found = shutil.which(program)
    if found is None:
        pytest.skip(f"{program} is not installed")
    is_raster = program == "gdalinfo"
    for name, path in outputs.items():
        if name.endswith(".tif") == is_raster:
            before = Path(path).read_bytes()
            options = [] if is_raster else ["-ro", "-al", "-so"]
            answer = subprocess.run([found, *options, path], capture_output=True, text=True, timeout=600)
            assert answer.returncode == 0 and not answer.stderr.strip(), (name, answer.stderr)
            assert Path(path).read_bytes() == before, name
            for word in ("Categories", "building", "Color Table") if is_raster else ("Geometry:", 'ID["EPSG"'):
                assert word in answer.stdout, (name, word)
