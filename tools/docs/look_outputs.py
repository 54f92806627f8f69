"""Makes every kind of output of the sample project, and pictures of its layers and reports, to be looked at.

    .venv/bin/python tools/docs/look_outputs.py SAMPLE --output DIR

SAMPLE: the folder of a sample project (*Plugins ▸ SemRef ▸ Open the sample project…*). Layers are opened as a QGIS
without the plugin opens them: each with what its file says. Reports are shown by chromium, light, dark and on paper,
where it is installed.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from qgis_session import ROOT, qgis_session

PAGE_PX, MAP_PX = (1100, 3200), (900, 700)
MODEL = ROOT / "models" / "sample_area.onnx"
ROUTE = "LINESTRING(548000 5421000, 549500 5422200, 551000 5421200)"
TRIALS = 20


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sample", type=Path)
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    folder = arguments.output / "outputs"
    folder.mkdir(parents=True, exist_ok=True)
    with qgis_session():
        for name, parameters in jobs(arguments.sample, folder).items():
            run(name.partition("#")[0], parameters)
        for path in (*sorted(folder.glob("*.gpkg")), *sorted(folder.glob("*.tif"))):
            draw(path, arguments.output)
    for path in sorted(folder.glob("*.html")):
        show(path, arguments.output)


def jobs(sample: Path, out: Path) -> dict[str, dict]:
    """Parameters by algorithm; what stands behind # tells one from another."""
    database, labels = str(out / "database.gpkg"), str(out / "label_map.tif")
    annotation = {"INPUT": str(sample / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    table = {"CLASS_TABLE": str(sample / "classes.csv")}
    simulated = {"DATABASE": database, "TRIALS": TRIALS}
    images = {"DATABASE": database, "MODEL": str(MODEL)}
    result = {"OUTPUT": str(out / "positions.gpkg"), "FOOTPRINTS": str(out / "footprints.gpkg")}
    return {
        "rasterizeannotation": {**annotation, **table, "PIXEL_SIZE": 1, "OUTPUT": labels},
        "builddatabase": {
            "LABELS": labels,
            "WINDOW_SIZE": 640,
            "STRIDE": 160,
            "MINIMUM_AREA": 50,
            "DATABASE": database,
        },
        "checkannotation": {**annotation, **table, **outputs(out, "check", ISSUES="gpkg", REPORT="html")},
        "localizeimages": {
            **images,
            "IMAGES": [str(sample / "photos")],
            **result,
            "MATCHES": str(out / "matches.gpkg"),
        },
        "localizeflight": {
            **images,
            "IMAGES": [str(sample / "flight")],
            **outputs(out, "flight", OUTPUT="gpkg", TRACK="gpkg", REPORT="html"),
        },
        "assessdatabase": {**simulated, "SPACING": 400, **outputs(out, "assess", OUTPUT="gpkg", REPORT="html")},
        "assessroute": {**simulated, "ROUTE": ROUTE, **outputs(out, "route", OUTPUT="gpkg", REPORT="html")},
        "evaluatelocalization": {
            **simulated,
            "LABELS": labels,
            **outputs(out, "evaluate", OUTPUT="gpkg", REPORT="html"),
        },
        "segmentimage": {"INPUT": str(sample / "orthophoto.tif"), "MODEL": str(MODEL), "OUTPUT": str(out / "seen.tif")},
        "comparelabels": {
            "REFERENCE": labels,
            "PREDICTED": str(out / "seen.tif"),
            **outputs(out, "compare", DISAGREEMENTS="gpkg", REPORT="html"),
        },
    }


def outputs(folder: Path, name: str, **kinds: str) -> dict[str, str]:
    return {key: str(folder / f"{name}_{key.lower()}.{suffix}") for key, suffix in kinds.items()}


def run(name: str, parameters: dict) -> None:
    import processing
    from qgis.core import QgsFeature, QgsGeometry, QgsProcessingException, QgsVectorLayer

    if "ROUTE" in parameters:
        layer = QgsVectorLayer("LineString?crs=EPSG:25832", "route", "memory")
        feature = QgsFeature()
        feature.setGeometry(QgsGeometry.fromWkt(parameters["ROUTE"]))
        layer.dataProvider().addFeatures([feature])
        parameters = {**parameters, "ROUTE": layer}
    try:
        processing.run(f"semref:{name}", parameters)
        print(name, flush=True)
    except QgsProcessingException as problem:
        print(f"{name}: {problem}", file=sys.stderr, flush=True)


def draw(path: Path, folder: Path) -> None:
    """The layers of a file as they come, with their legend printed."""
    from qgis.core import QgsMapRendererParallelJob, QgsMapSettings, QgsRasterLayer, QgsVectorLayer
    from qgis.PyQt.QtCore import QSize
    from qgis.PyQt.QtGui import QColor

    if path.suffix == ".gpkg":
        whole = QgsVectorLayer(str(path), path.stem, "ogr")
        names = [text.split("!!::!!")[1] for text in whole.dataProvider().subLayers()]
        found = [QgsVectorLayer(f"{path}|layername={name}", name, "ogr") for name in names]
        layers = [layer for layer in found if layer.isSpatial()]
    else:
        layers = [QgsRasterLayer(str(path), path.stem)]
    for layer in layers:
        layer.loadDefaultMetadata()
        settings = QgsMapSettings()
        settings.setLayers([layer])
        settings.setDestinationCrs(layer.crs())
        settings.setOutputSize(QSize(*MAP_PX))
        settings.setBackgroundColor(QColor("#8a9a70"))
        settings.setExtent(layer.extent().buffered(0.03 * layer.extent().width()))
        job = QgsMapRendererParallelJob(settings)
        job.start()
        job.waitForFinished()
        job.renderedImage().save(str(folder / f"layer_{path.stem}_{layer.name()}.png"))
        told = layer.metadata()
        print(f"\n{path.name}: {layer.name()}\n  title: {told.title()}; licenses: {told.licenses()}")
        print(f"  history: {[line[:100] for line in told.history()]}")
        print(f"  legend: {legend(layer)}")
        if isinstance(layer, QgsVectorLayer):
            print(f"  columns: {[layer.attributeDisplayName(n) for n in layer.attributeList()]}")


def legend(layer) -> list[str]:
    renderer = layer.renderer()
    if hasattr(renderer, "legendSymbolItems"):
        return [item.label() for item in renderer.legendSymbolItems()]
    return [one.label for one in renderer.classes()]


def show(path: Path, folder: Path) -> None:
    """Pictures of a page."""
    browser = shutil.which("chromium")
    if browser is None:
        return
    quiet = [
        browser,
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--hide-scrollbars",
        "--run-all-compositor-stages-before-draw",
    ]
    for look, options in {
        "light": [],
        "dark": ["--force-dark-mode", "--blink-settings=preferredColorScheme=0"],
    }.items():
        target = folder / f"report_{path.stem}_{look}.png"
        size = f"--window-size={PAGE_PX[0]},{PAGE_PX[1]}"
        subprocess.run(
            [*quiet, *options, size, f"--screenshot={target}", path.as_uri()], capture_output=True, timeout=90
        )
    target = folder / f"report_{path.stem}.pdf"
    subprocess.run(
        [*quiet, "--no-pdf-header-footer", f"--print-to-pdf={target}", path.as_uri()], capture_output=True, timeout=90
    )


if __name__ == "__main__":
    main()
