"""The two dates of LCDB Christchurch as label maps with the same classes, and databases of the earlier one."""

from __future__ import annotations

import csv
from pathlib import Path

from bench import inputs, plugin

SOURCE = "lcdb5_christchurch/lcdb5_christchurch.gpkg"
PIXEL_SIZE_M = 10.0
MINIMUM_AREA_M2 = 5_000.0
NOT_LAND = 255
"""LCDB's code of it is 0, which means unlabeled in a label map."""

BEFORE, AFTER = 1996, 2018

PATCHES = (
    "Urban Parkland/Open Space",
    "Surface Mine or Dump",
    "Lake or Pond",
    "Orchard, Vineyard or Other Perennial Crop",
    "Gorse and/or Broom",
    "Broadleaved Indigenous Hardwoods",
    "Deciduous Hardwoods",
    "Exotic Forest",
)
"""Reference classes: those that lie as separate patches in what fills the map (settlement, pasture, cropland)."""


def label_map(run: inputs.Run, year: int) -> Path:
    """Label map of a date; values are LCDB's own class codes, the same at every date."""
    path = run.work / f"lcdb_{year}.tif"
    if not path.exists():
        parameters = {
            "INPUT": str(run.data / SOURCE),
            "CLASS_FIELD": f"Name_{year}",
            "CLASS_TABLE": str(_class_table(run)),
            "PIXEL_SIZE": PIXEL_SIZE_M,
            "OUTPUT": str(path),
        }
        plugin.run_algorithm("rasterizeannotation", parameters)
    return path


def database(run: inputs.Run, window_m: float) -> Path:
    """Database of the earlier date with windows as large as the images, every quarter of a window."""
    path = run.work / f"lcdb_{BEFORE}_{window_m:g}.gpkg"
    if not path.exists():
        parameters = {
            "LABELS": str(label_map(run, BEFORE)),
            "WINDOW_SIZE": window_m,
            "STRIDE": window_m / 4,
            "MINIMUM_AREA": MINIMUM_AREA_M2,
            "DATABASE": str(path),
        }
        plugin.run_algorithm("builddatabase", parameters)
    return path


def _class_table(run: inputs.Run) -> Path:
    from osgeo import ogr

    path = run.work / "lcdb_classes.csv"
    layer = ogr.Open(str(run.data / SOURCE))
    found = set()
    for feature in layer.GetLayer(0):
        for year in (BEFORE, AFTER):
            found.add((int(feature.GetField(f"Class_{year}")), feature.GetField(f"Name_{year}")))
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "role"])
        rows.writerows(
            [value or NOT_LAND, name, "reference" if name in PATCHES else "background"] for value, name in sorted(found)
        )
    return path
