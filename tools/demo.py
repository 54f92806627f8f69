"""Run the main steps on the sample area: shapefile → label map → reference database → positions.

The demo localizes label images with two methods, and photos with the shipped model.
"""

import csv
import subprocess
import sys
from collections import defaultdict
from math import hypot
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from qgis_session import ROOT, qgis_session

OUTPUT = ROOT / "demo"
SAMPLE = OUTPUT / "sample"
DATABASE = str(OUTPUT / "reference_database.gpkg")
RIGHT_WITHIN_M = 10.0
PUBLISHED = "published method"
ABOUT_OFF_GRID = """
   The published method matches images between windows (off_grid) with a wrong window: it accepts each
   distance below 2. Constellation verifies its positions: docs/explanation/method.md."""


def main() -> None:
    OUTPUT.mkdir(exist_ok=True)
    print("1. Sample area")
    if not SAMPLE.exists():
        command = [sys.executable, "-m", "tools.sample", str(SAMPLE), "--label-images"]
        subprocess.run(command, cwd=ROOT, check=True)
    with qgis_session():
        build()
        print("\n3. From label images to positions (semref:localizeimages), Constellation and published method")
        images, layer = {"IMAGES": [str(SAMPLE / "images")]}, {"FOOTPRINTS": str(OUTPUT / "footprints.gpkg")}
        found = {
            "constellation": localize("positions", METHOD=0, **images, **layer),
            PUBLISHED: localize("published_method", METHOD=1, **images),
        }
        print_positions(found, SAMPLE / "truth.csv")
        print(ABOUT_OFF_GRID)
        print("\n4. From photos to positions (semref:localizeimages with the shipped model)")
        model = str(ROOT / "models" / "sample_area.onnx")
        photos = localize("photo_positions", IMAGES=[str(SAMPLE / "photos")], MODEL=model)
        print_positions({"photo → network → position": photos}, SAMPLE / "photos.csv")
    print(f"\nThe layers are in {OUTPUT}.")


def build() -> None:
    """Run the shipped model that builds a database from a layer."""
    import processing

    print("\n2. From shapefile to label map and reference database (semref:annotationtodatabase)")
    layer = {"INPUT": str(SAMPLE / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    sizes = {"PIXEL_SIZE": 1.0, "WINDOW_SIZE": 640, "STRIDE": 160, "MINIMUM_AREA": 50}
    outputs = {"rasterize:Label map": str(OUTPUT / "label_map.tif"), "build:Reference database": DATABASE}
    table = {"CLASS_TABLE": str(SAMPLE / "classes.csv")}
    counts = processing.run("semref:annotationtodatabase", {**layer, **table, **sizes, **outputs})["CHILD_RESULTS"]
    print("   {WINDOW_COUNT} windows, {REFERENCE_COUNT} landmarks".format(**counts["build"]))


def localize(name: str, **parameters: object) -> dict[str, dict]:
    """Localize images and return the rows of the positions layer by image name."""
    import processing
    from qgis.core import QgsVectorLayer

    path = str(OUTPUT / f"{name}.gpkg")
    processing.run("semref:localizeimages", {"DATABASE": DATABASE, "OUTPUT": path, **parameters})
    layer = QgsVectorLayer(path, name, "ogr")
    rows = (dict(zip(layer.fields().names(), feature.attributes())) for feature in layer.getFeatures())
    return {Path(row["image"]).name: row for row in rows}


def print_positions(found: dict[str, dict[str, dict]], truth: Path) -> None:
    """Print a line for each image, then the number of right positions of each kind of image."""
    print(f"\n   {'image':32s}" + "".join(f" | {title:44s}" for title in found))
    right: dict[str, list[list[bool]]] = defaultdict(list)
    with truth.open(newline="", encoding="utf-8") as file:
        for true in csv.DictReader(file):
            name = Path(true["image"]).name
            cells = [_cell(title, rows[name], true) for title, rows in found.items()]
            right[true["kind"]].append([is_right for _, is_right in cells])
            print(f"   {name:32s}" + "".join(f" | {text:44s}" for text, _ in cells))
    print(f"\n   {'right within 10 m':32s}" + "".join(f" | {title:44s}" for title in found))
    for kind, rows in right.items():
        print(f"   {kind:32s}" + "".join(f" | {f'{sum(column)} of {len(rows)}':44s}" for column in zip(*rows)))


def _cell(title: str, row: dict, true: dict) -> tuple[str, bool]:
    """Return the text for a position, and whether it is right."""
    from semref.core.localizer.record import error_probability

    if row["status"] != "fix":
        return row["status"], False
    distance = hypot(row["x"] - float(true["x"]), row["y"] - float(true["y"]))
    # The published method's confidence is not a probability.
    kind = f"confidence {row['confidence']:.2f}"
    if title != PUBLISHED:
        kind = f"error probability {error_probability(row['confidence'])}"
    is_right = distance <= RIGHT_WITHIN_M
    return f"{distance:7.2f} m off, {kind}{'' if is_right else '  WRONG PLACE'}", is_right


if __name__ == "__main__":
    main()
