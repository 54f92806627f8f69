"""Runs of semref:localizeimages in one QGIS, as a user or a model makes them over a long day.

A small sample area is made once. Each run localizes one image: a label image by one of the methods, or, one of 20, a
photo with the network that ships. Outputs go to memory or, one of two, to the same files again and again; one of
``UNREADABLE_EACH`` images is none, one of ``CANCELED_EACH`` runs is canceled on its way, and one of ``REFUSED_EACH`` is
refused because its database is missing.
"""

from __future__ import annotations

import gc
import os
from pathlib import Path
from typing import Any

from .held import Held, held, line

UNREADABLE_EACH, CANCELED_EACH, REFUSED_EACH, PHOTO_EACH = 50, 40, 100, 20
SIZE_XY = (1500.0, 1300.0)
"""Meters of the made-up land, hardly less holds a photo turned by any angle."""
METHODS = (0, 1, 2, 3)


class Area:
    """Made-up land, its database, twelve photos and their label images."""

    def __init__(self, folder: Path) -> None:
        from qgis_session import ROOT

        from benchmarks.maps import run_algorithm
        from sample import DEFAULT_SEED, files, landscape

        landscape.SIZE_XY = SIZE_XY
        sample = folder / "sample"
        sample.mkdir()
        files.write_sample(sample, landscape.make_landscape(DEFAULT_SEED), files.PIXEL_SIZE_M)
        self.labels, self.database = str(folder / "labels.tif"), str(folder / "database.gpkg")
        land = {"INPUT": str(sample / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
        table = {"CLASS_TABLE": str(sample / "classes.csv")}
        run_algorithm("rasterizeannotation", {**land, **table, "PIXEL_SIZE": 1.0, "OUTPUT": self.labels})
        windows = {"WINDOW_SIZE": 640, "STRIDE": 160, "MINIMUM_AREA": 50}
        run_algorithm("builddatabase", {"LABELS": self.labels, **windows, "DATABASE": self.database})
        self.model = str(ROOT / "models" / "sample_area.onnx")
        self.photos = sorted(str(path) for path in (sample / "photos").glob("*.jpg"))
        images = folder / "images"
        kept = {"OUTPUT": "TEMPORARY_OUTPUT", "LABELS": str(images)}
        run_algorithm("localizeimages", {"DATABASE": self.database, "IMAGES": self.photos, "MODEL": self.model, **kept})
        self.images = sorted(str(path) for path in images.glob("*.tif")) or sorted(map(str, images.glob("*.png")))
        self.unreadable = str(folder / "unreadable.tif")
        Path(self.unreadable).write_text("no image", encoding="utf-8")


def parameters_of(number: int, area: Area, folder: Path) -> dict[str, Any]:
    """What the run with this number is asked for."""
    photo = number % PHOTO_EACH == 0
    images = area.photos if photo else area.images
    image = area.unreadable if number % UNREADABLE_EACH == 7 else images[number % len(images)]
    database = str(folder / "missing.gpkg") if number % REFUSED_EACH == 11 else area.database
    chosen = {"DATABASE": database, "IMAGES": [image], "METHOD": METHODS[number % len(METHODS)]}
    if photo:
        chosen["MODEL"] = area.model
    outputs = ("OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES")
    if number % 2:
        return {**chosen, **{name: str(folder / f"{name.lower()}.gpkg") for name in outputs}}
    return {**chosen, **dict.fromkeys(outputs, "TEMPORARY_OUTPUT")}


def run(number: int, area: Area, folder: Path) -> str:
    """How it ended: ``fix``, ``no fix``, ``canceled`` or ``refused``."""
    import processing
    from qgis.core import QgsProcessingException, QgsProcessingFeedback

    feedback = QgsProcessingFeedback(False)
    canceled = number % CANCELED_EACH == 13
    if canceled:
        feedback.progressChanged.connect(feedback.cancel)
    try:
        results = processing.run("semref:localizeimages", parameters_of(number, area, folder), feedback=feedback)
    except QgsProcessingException as error:
        return "refused" if "missing.gpkg" in str(error) else "canceled" if canceled else f"failed: {error}"
    return "fix" if results["FIX_COUNT"] else "no fix"


def localize_over_and_over(count: int, folder: Path) -> list[Held]:
    """What QGIS holds after each tenth of ``count`` runs; ends the program when one of them failed."""
    from qgis.core import QgsApplication
    from qgis_session import qgis_session

    rows, ends = [], {}
    with qgis_session():
        area = Area(folder)
        for number in range(count):
            end = run(number, area, folder)
            ends[end] = ends.get(end, 0) + 1
            if end.startswith("failed"):
                raise SystemExit(f"run {number} {end}")
            # As the event loop of a real QGIS does between two runs.
            QgsApplication.processEvents()
            if (number + 1) % max(count // 10, 1) == 0:
                gc.collect()
                rows.append(held(number + 1, os.getpid()))
                print(line(rows[-1]), flush=True)
        strays = sorted(path.name for path in folder.iterdir() if path.name.startswith(".") or "-journal" in path.name)
    print("ends:", ", ".join(f"{end} {number}" for end, number in sorted(ends.items())))
    if strays:
        raise SystemExit(f"strays stay: {', '.join(strays)}")
    return rows
