"""Run the main steps on the sample area: shapefile → label map → reference database → positions.

The demo localizes label images with two methods, and photos with the shipped model.
"""

from __future__ import annotations

import csv
import subprocess
import sys
from collections import defaultdict
from math import hypot
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from qgis_session import ROOT, qgis_session

OUTPUT = ROOT / "demo"
WINDOW_SIZE_M, STRIDE_M, MINIMUM_AREA_M2 = 640, 160, 50
RIGHT_WITHIN_M = 10.0
MODEL = ROOT / "models" / "sample_area.onnx"
METHODS = (("positions", 0, "constellation"), ("published", 1, "published method"))
"""Output, METHOD of semref:localizeimages, and column title."""
ABOUT_OFF_GRID = """
   The published method matches images between windows (off_grid) with a wrong window: it accepts each
   distance below 2. Constellation verifies its positions: docs/explanation/method.md."""
PHOTO_METHODS = (("photo_positions", 0, "photo → network → position"),)


def main() -> None:
    OUTPUT.mkdir(exist_ok=True)
    sample = OUTPUT / "sample"
    print("1. Sample area")
    if not sample.exists():
        command = [sys.executable, "-m", "tools.sample", str(sample), "--label-images"]
        subprocess.run(command, cwd=ROOT, check=True)
    with qgis_session():
        paths = run_algorithms(sample)
        found = {name: read_positions(paths[name]) for name, _, _ in (*METHODS, *PHOTO_METHODS)}
        print_fixes(found, read_truth(sample / "truth.csv"), METHODS)
        print(ABOUT_OFF_GRID)
        print_fixes(found, read_truth(sample / "photos.csv"), PHOTO_METHODS)
    print(f"\nThe layers are in {OUTPUT}.")


def run_algorithms(sample: Path) -> dict[str, str]:
    """Run the shipped model and the localization with Processing, and return the paths of the outputs."""
    import processing

    paths = {
        name: str(OUTPUT / file)
        for name, file in (
            ("labels", "label_map.tif"),
            ("database", "reference_database.gpkg"),
            ("positions", "positions.gpkg"),
            ("footprints", "footprints.gpkg"),
            ("published", "published_method.gpkg"),
            ("photo_positions", "photo_positions.gpkg"),
        )
    }
    print("\n2. From shapefile to label map and reference database (semref:annotationtodatabase)")
    built = processing.run(
        "semref:annotationtodatabase",
        {
            "INPUT": str(sample / "landcover.shp"),
            "CLASS_FIELD": "class",
            "PRIORITY_FIELD": "zorder",
            "CLASS_TABLE": str(sample / "classes.csv"),
            "PIXEL_SIZE": 1.0,
            "WINDOW_SIZE": WINDOW_SIZE_M,
            "STRIDE": STRIDE_M,
            "MINIMUM_AREA": MINIMUM_AREA_M2,
            "rasterize:Label map": paths["labels"],
            "build:Reference database": paths["database"],
        },
        feedback=_printing_feedback(),
    )
    counts = built["CHILD_RESULTS"]["build"]
    print(f"   {counts['WINDOW_COUNT']} windows, {counts['REFERENCE_COUNT']} landmarks")
    print("\n3. From label images to positions (semref:localizeimages), Constellation and published method")
    for name, method, _ in METHODS:
        parameters = {"DATABASE": paths["database"], "IMAGES": [str(sample / "images")], "METHOD": method}
        if method == 0:
            parameters["FOOTPRINTS"] = paths["footprints"]
        processing.run("semref:localizeimages", {**parameters, "OUTPUT": paths[name]})
    print("\n4. From photos to positions (semref:localizeimages with the shipped model)")
    parameters = {"DATABASE": paths["database"], "IMAGES": [str(sample / "photos")], "MODEL": str(MODEL)}
    processing.run("semref:localizeimages", {**parameters, "OUTPUT": paths["photo_positions"]})
    return paths


def _printing_feedback():
    from qgis.core import QgsProcessingFeedback

    class Printing(QgsProcessingFeedback):
        def pushWarning(self, text):
            print(f"   {text}")

        def reportError(self, text, fatal=False):
            print(f"   {text}", file=sys.stderr)

    return Printing(False)


def read_positions(path: str) -> dict[str, dict]:
    """Return the rows of the positions layer by image name."""
    from qgis.core import QgsVectorLayer

    layer = QgsVectorLayer(path, "positions", "ogr")
    names = layer.fields().names()
    rows = (dict(zip(names, feature.attributes())) for feature in layer.getFeatures())
    return {Path(row["image"]).name: row for row in rows}


def read_truth(path: Path) -> list[dict]:
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def print_fixes(found: dict[str, dict[str, dict]], truth: list[dict], methods) -> None:
    """Print a line for each image, then the number of right positions of each kind."""
    print(f"\n   {'image':32s}" + "".join(f" | {title:44s}" for _, _, title in methods))
    right: dict[str, list[list[bool]]] = defaultdict(list)
    for row in truth:
        name = Path(row["image"]).name
        errors = [_error(found[method][name], row) for method, _, _ in methods]
        right[row["kind"]].append([error is not None and error <= RIGHT_WITHIN_M for error in errors])
        cells = (_cell(found[method][name], error) for (method, _, _), error in zip(methods, errors))
        print(f"   {name:32s}" + "".join(f" | {cell:44s}" for cell in cells))
    print(f"\n   {'right within 10 m':32s}" + "".join(f" | {title:44s}" for _, _, title in methods))
    for kind, rows in right.items():
        cells = (f"{sum(column)} of {len(rows)}" for column in zip(*rows))
        print(f"   {kind:32s}" + "".join(f" | {cell:44s}" for cell in cells))


def _error(fix: dict, truth: dict) -> float | None:
    """Return the distance from the true position in m; None without a position."""
    if fix["status"] != "fix":
        return None
    return hypot(fix["x"] - float(truth["x"]), fix["y"] - float(truth["y"]))


def _cell(fix: dict, error: float | None) -> str:
    from semref.core.localizer.record import error_probability

    if error is None:
        return fix["status"]
    wrong = "" if error <= RIGHT_WITHIN_M else "  WRONG PLACE"
    if fix["method"] == "topology vector":
        # The published method's confidence is not a probability.
        return f"{error:7.2f} m off, confidence {fix['confidence']:.2f}{wrong}"
    return f"{error:7.2f} m off, error probability {error_probability(fix['confidence'])}{wrong}"


if __name__ == "__main__":
    main()
