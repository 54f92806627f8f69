"""SemRef's outputs in a QGIS without the plugin."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from made_inputs import (
    CLASSES_CSV,
    NAMES,
    NORTH,
    WEST,
    scattered_objects,
    square,
    turned_view,
    write_layer,
    write_raster,
)

SIZE = 300
pytestmark = pytest.mark.slow
LIMIT_S = 300

VECTORS = {
    **dict.fromkeys(("issues", "repaired"), "categorizedSymbol"),
    **dict.fromkeys(("disagreements", "positions", "footprints", "poses", "trials"), "RuleRenderer"),
    **dict.fromkeys(("matches", "track"), "singleSymbol"),
    **dict.fromkeys(("squares", "points"), "graduatedSymbol"),
}
"""Files of layers by name, and how QGIS draws them."""

PLAIN = """
import json, sys
from qgis.core import (QgsApplication, QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsRasterLayer,
                       QgsVectorLayer)

def described(layer):
    found = {"valid": layer.isValid(), "crs": layer.crs().authid(), "history": layer.metadata().history()}
    if not isinstance(layer, QgsVectorLayer):
        found["legend"] = [entry.label for entry in layer.renderer().classes()]
        return found
    found["renderer"] = layer.renderer().type()
    found["titles"] = {field.name(): layer.attributeDisplayName(n) for n, field in enumerate(layer.fields())}
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    features = list(layer.getFeatures())
    found["features"] = len(features)
    found["tip"] = ""
    if features and layer.mapTipTemplate():
        context.setFeature(features[0])
        found["tip"] = QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context)
    return found

application = QgsApplication([], False)
application.initQgis()
layers = {}
for source in sys.argv[1:]:
    is_raster = source.endswith(".tif") or source.startswith("GPKG:")
    layer = QgsRasterLayer(source, "raster") if is_raster else QgsVectorLayer(source, "layer", "ogr")
    layer.loadDefaultMetadata()
    layers[source] = described(layer)
print("SEEN " + json.dumps({"layers": layers, "semref": [name for name in sys.modules if "semref" in name]}))
"""


@pytest.fixture(scope="module")
def written(run_algorithm, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("written")

    def at(name: str) -> str:
        return str(folder / name)

    def run(name: str, **parameters) -> None:
        run_algorithm(f"semref:{name}", parameters)

    labels = scattered_objects(900, 1000, 1300, seed=5)
    annotation = write_layer(
        folder / "annotation.gpkg",
        [(square(0, 0, 100), "field", 1), (square(10, 10, 20), "building", 2), (square(25, 25, 20), "building", 2)],
        [("class", "text"), ("zorder", "integer")],
    )
    Path(at("classes.csv")).write_text(CLASSES_CSV, encoding="utf-8")
    given = write_raster(folder / "given.tif", labels, names=NAMES)
    other = write_raster(folder / "other.tif", scattered_objects(900, 1000, 1300, seed=6), names=NAMES)
    of_class = {"INPUT": str(annotation), "CLASS_FIELD": "class", "CLASS_TABLE": at("classes.csv")}
    run("rasterizeannotation", **of_class, PIXEL_SIZE=1, OUTPUT=at("labels.tif"))
    run("checkannotation", **of_class, ISSUES=at("issues.gpkg"))
    run("repairannotation", **of_class, OUTPUT=at("repaired.gpkg"))
    run("comparelabels", REFERENCE=str(given), PREDICTED=str(other), DISAGREEMENTS=at("disagreements.gpkg"))
    database = at("database.gpkg")
    sizes = {"WINDOW_SIZE": SIZE, "STRIDE": SIZE / 2, "MINIMUM_AREA": 30}
    run("builddatabase", LABELS=str(given), REFERENCE_CLASSES="building;water;bare_land", **sizes, DATABASE=database)
    flight = folder / "flight"
    flight.mkdir()
    for number in range(4):
        view = turned_view(labels, SIZE, 350 + 60 * number, 400, 30, 1.0)
        write_raster(flight / f"{number}.png", view, transform=None)
    images = {"DATABASE": database, "IMAGES": [str(flight)]}
    places = {"OUTPUT": at("positions.gpkg"), "FOOTPRINTS": at("footprints.gpkg"), "MATCHES": at("matches.gpkg")}
    run("localizeimages", **images, **places)
    run("localizeflight", **images, OUTPUT=at("poses.gpkg"), TRACK=at("track.gpkg"))
    quick = {"DATABASE": database, "FOOTPRINT": str(SIZE), "MAP_CORRELATION": False}
    run("assessdatabase", **quick, TRIALS=20, SPACING=200, OUTPUT=at("squares.gpkg"))
    way = f"LINESTRING ({WEST + 200} {NORTH - 300}, {WEST + 700} {NORTH - 500})"
    route = write_layer(folder / "route.gpkg", [(way, "a")])
    run("assessroute", **quick, ROUTE=str(route), TRIALS=2, OUTPUT=at("points.gpkg"))
    run("evaluatelocalization", DATABASE=database, LABELS=str(given), TRIALS=20, OUTPUT=at("trials.gpkg"))
    return folder


@pytest.fixture(scope="module")
def opened(written) -> dict:
    """Return the properties of each layer in a QGIS without the plugin, by file or source."""
    database = written / "database.gpkg"
    tables = [f"{database}|layername={name}" for name in ("windows", "references")]
    files = [str(written / f"{name}.gpkg") for name in VECTORS]
    sources = [*files, *tables, str(written / "labels.tif"), f"GPKG:{database}:overview"]
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    clean["QT_QPA_PLATFORM"] = "offscreen"
    command = [sys.executable, "-c", PLAIN, *sources]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S, env=clean, check=False)
    seen = [line for line in ended.stdout.splitlines() if line.startswith("SEEN ")]
    assert seen, ended.stderr
    found = json.loads(seen[0][len("SEEN ") :])
    assert found["semref"] == []
    return found["layers"]


@pytest.mark.parametrize("name", VECTORS)
def test_a_plain_qgis_draws_every_layer_as_semref_does_with_titles_for_the_columns(written, opened, name):
    info = opened[str(written / f"{name}.gpkg")]
    assert info["valid"] and info["crs"] == "EPSG:32632" and info["features"] > 0
    assert info["renderer"] == VECTORS[name]
    assert info["history"] and info["history"][-1].partition(",")[2].startswith(" SemRef")
    assert "Eval Error" not in info["tip"] and "[%" not in info["tip"]
    assert name == "repaired" or [c for c, title in info["titles"].items() if c == title and c != "fid"] == []


def test_a_plain_qgis_has_the_legend_of_label_map_and_database(written, opened):
    labels, database = opened[str(written / "labels.tif")], written / "database.gpkg"
    assert {"building", "field"} <= set(labels["legend"]) and labels["history"]
    windows, references = (opened[f"{database}|layername={name}"] for name in ("windows", "references"))
    assert references["renderer"] == "categorizedSymbol" and windows["features"] > 0 < references["features"]
    assert opened[f"GPKG:{database}:overview"]["valid"]
