"""Small files of each kind, and what each algorithm is given of them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

LAYER = {
    "type": "FeatureCollection",
    "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}},
    "features": [
        {
            "type": "Feature",
            "properties": {"class": name, "priority": n},
            "geometry": {
                "type": "Polygon",
                "coordinates": [[[x, 5e6], [x + 30, 5e6], [x + 30, 5e6 + 25], [x, 5e6 + 25], [x, 5e6]]],
            },
        }
        for n, (name, x) in enumerate((("building", 550000.0), ("water", 550020.0), ("building", 550060.0)))
    ],
}


def inputs(folder: Path) -> dict[str, str]:
    """Small files of each kind, by name."""
    import onboard_area
    from made_inputs import NORTH, WEST, scattered_objects, write_layer, write_raster
    from made_models import metadata, write_model
    from osgeo import gdal

    folder.mkdir()
    labels = scattered_objects(120, 160, 40, seed=2)
    names = ["unlabeled", "building", "water", "bare_land", "field"]
    made = {
        "labels": write_raster(folder / "labels.tif", labels, names=names),
        "newer": write_raster(folder / "newer.tif", np.roll(labels, 9, 0), names=names),
        "image": write_raster(folder / "image.png", labels[10:70, 10:70], transform=None),
        "photo": write_raster(folder / "photo.tif", np.stack([labels * 50] * 3), crs=None, transform=None),
        "colors": write_raster(folder / "colors.tif", np.stack([labels * 50] * 3)),
        "layer": folder / "layer.geojson",
        "classes": folder / "classes.csv",
        "cameras": folder / "cameras.csv",
        "route": folder / "route.plan",
        "key": folder / "fleet.key",
        "model": write_model(folder / "model.onnx", metadata=metadata(tile_size=32)),
        "table": folder / "broken.csv",
        "odometry": folder / "odometry.csv",
        "positions": write_layer(
            folder / "positions.gpkg",
            [(f"POINT ({WEST + 60} {NORTH - 60})", "image.png", "fix", 30.0, 1.0)],
            [("image", "text"), ("status", "text"), ("heading", "real"), ("pixel_size", "real")],
        ),
    }
    (folder / "layer.geojson").write_text(json.dumps(LAYER), encoding="ascii")
    (folder / "classes.csv").write_text(f"{_classes(onboard_area)}", encoding="ascii")
    (folder / "cameras.csv").write_text("image,roll,pitch,field_of_view\nimage.png,1,2,60\n", encoding="ascii")
    (folder / "odometry.csv").write_text("image,dx_m,dy_m,dheading_deg\nimage.png,0,0,0\n", encoding="ascii")
    (folder / "broken.csv").write_text("a;b\n1\n", encoding="ascii")
    (folder / "fleet.key").write_bytes(bytes(range(32)))
    memory = gdal.GetDriverByName("MEM").Create("", 1, 1)
    memory.SetGeoTransform((WEST, 1, 0, NORTH, 0, -1))
    return {name: str(path) for name, path in made.items()}


def _classes(onboard_area: Any) -> str:
    return onboard_area.TABLE.to_csv().replace("field", "forest")


def base_parameters(files: dict[str, str], out: Path) -> dict[str, dict[str, Any]]:
    """Parameters with which each algorithm works, in less than a second."""
    report, layer, raster = str(out / "r.html"), str(out / "x.gpkg"), str(out / "x.tif")
    database, classes = files["database"], "building;water;bare_land"
    annotated = {"INPUT": files["layer"], "CLASS_FIELD": "class"}
    return {
        "rasterizeannotation": {**annotated, "PIXEL_SIZE": 1, "OUTPUT": raster},
        "classifyopenstreetmap": {"INPUT": files["layer"], "OTHER_CLASS": "building", "OUTPUT": layer},
        "checkannotation": {**annotated, "PIXEL_SIZE": 1, "ISSUES": layer, "REPORT": report},
        "repairannotation": {**annotated, "OUTPUT": layer, "CHANGES": str(out / "y.gpkg")},
        "classtable": {**annotated, "REFERENCE_CLASSES": "water", "OUTPUT": report},
        "builddatabase": {
            "LABELS": files["labels"],
            "REFERENCE_CLASSES": classes,
            **dict(zip(("WINDOW_SIZE", "STRIDE", "MINIMUM_AREA"), (60, 30, 30))),
            "DATABASE": layer,
        },
        "updatedatabase": {"DATABASE": database, "LABELS": files["newer"], "OUTPUT": layer},
        "comparelabels": {
            "REFERENCE": files["labels"],
            "PREDICTED": files["newer"],
            "REPORT": report,
            "DISAGREEMENTS": raster,
        },
        "describeimage": {
            "INPUT": files["labels"],
            "REFERENCE_CLASSES": classes,
            "DATABASE": database,
            "REFERENCES": layer,
        },
        "decodecolorlabels": {"INPUT": files["colors"], "CLASS_TABLE": files["classes"], "OUTPUT": raster},
        "exportonboard": {"DATABASE": database, "KEY_FILE": files["key"], "OUTPUT": str(out / "x.npz")},
        "localizeimages": {
            "DATABASE": database,
            "IMAGES": files["image"],
            "OUTPUT": layer,
            "ATTITUDE": files["cameras"],
        },
        "localizeflight": {
            "DATABASE": database,
            "IMAGES": files["image"],
            "ODOMETRY": files["odometry"],
            "OUTPUT": layer,
            "TRACK": str(out / "y.gpkg"),
            "REPORT": report,
        },
        "georeferenceimages": {
            "POSITIONS": files["positions"],
            "IMAGES": files["image"],
            "OUTPUT": str(out / "placed"),
        },
        "assessroute": {"DATABASE": database, "ROUTE": files["route"], "TRIALS": 1, "OUTPUT": layer},
        "assessdatabase": {"DATABASE": database, "TRIALS": 1, "SPACING": 60, "OUTPUT": layer},
        "evaluatelocalization": {"DATABASE": database, "LABELS": files["labels"], "TRIALS": 1, "OUTPUT": report},
        "exporttrainingtiles": {
            "IMAGE": files["colors"],
            "LABELS": files["labels"],
            "TILE_SIZE": 32,
            "STRIDE": 32,
            "OUTPUT": str(out / "tiles"),
        },
        "segmentimage": {"INPUT": files["photo"], "MODEL": files["model"], "OUTPUT": raster},
        "routesheet": {"ROUTE": files["positions"], "OUTPUT": report},
    }


def write_plan(files: dict[str, str], database: str) -> None:
    from semref.storage.database.reader import read_database

    windows = read_database(database).windows
    del windows
    items = [
        {"type": "SimpleItem", "command": 16, "params": [0, 0, 0, None, latitude, 9.6585, 50]}
        for latitude in (47.1305, 47.1310)
    ]
    Path(files["route"]).write_text(json.dumps({"mission": {"items": items}}), encoding="ascii")
