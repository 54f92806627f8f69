"""Checking and repairing annotations of real layers, beside independent computations.

Each run is a process of its own; times are its processor times, so that other programs don't count, and memory is its
peak, QGIS with it. Independent checks: QGIS's own validity check of each feature, and pairwise intersections of GDAL's
geometries of 500 polygons.
"""

from __future__ import annotations

import subprocess
import tempfile
from collections import Counter
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

from bench import child, inputs, page

PAGE = "benchmarks.md"
AREA = "Real layers, as named."
PAIRWISE = 500
SMALLEST_OVERLAP_M2 = 0.01
POLYGONS = 200_000
"""Liechtenstein is repeated until it has about so many."""

CLASSES = (
    "value,name,color,role\n1,building,#d62728,reference\n2,bare_land,#bcbd22,reference\n3,water,#1f77b4,reference\n"
    "4,forest,#2ca02c,\n5,cultivated,#ff7f0e,\n6,grass_scrub,#98df8a,\n7,built_up,#7f7f7f,\n"
)


@dataclass(frozen=True)
class Layer:
    """A real layer and how it is used; pixel_size in m."""

    path: str
    class_field: str
    pixel_size: float
    priority_field: str = ""
    class_table: str = ""


LAYERS = {
    "liechtenstein": Layer("osm_liechtenstein_2021/li_landcover_2021.shp", "class", 1.0, "zorder", CLASSES),
    "berlin": Layer("berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp", "Level_2", 1.0),
    "belgrade": Layer("osm_belgrade/landuse.shp", "type", 5.0),
    "christchurch": Layer("lcdb5_christchurch/lcdb5_christchurch.gpkg", "Name_2018", 15.0),
}


def measure(run: inputs.Run) -> dict[str, str]:
    """Checks and repairs every layer that is here, and a large one."""
    rows: list[list[object]] = []
    remarks: list[str] = []
    with tempfile.TemporaryDirectory(dir=run.work) as folder:
        for name, layer in LAYERS.items():
            if run.quick and name != "belgrade":
                continue
            if not (run.data / layer.path).exists():
                remarks.append(f"{name}: not measured, the data is not here")
                continue
            work = Path(folder) / name
            work.mkdir()
            rows += layer_rows(run, name, layer, work)
            remarks += [f"{name}: {remark}" for remark in layer_remarks(run, layer, work)]
        if not run.quick and (run.data / LAYERS["liechtenstein"].path).exists():
            rows += large_rows(run.data / LAYERS["liechtenstein"].path, Path(folder))
    header = ["layer", "run", "findings by kind", "processor s", "peak MB"]
    text = page.table(header, rows) + "\n\n" + "\n".join(f"- {remark}" for remark in remarks)
    return {"annotation": text}


def settings(layer: Layer, folder: Path) -> dict:
    """Parameters of a layer that all runs share."""
    table = folder / "classes.csv"
    table.write_text(layer.class_table, encoding="utf-8")
    return {
        "CLASS_FIELD": layer.class_field,
        "PRIORITY_FIELD": layer.priority_field or None,
        "CLASS_TABLE": str(table) if layer.class_table else None,
    }


def layer_rows(run: inputs.Run, name: str, layer: Layer, folder: Path) -> list[list[object]]:
    """Check, check with pixels, repair, and both again on what was repaired; the files stay in ``folder``."""
    common, source, repaired = settings(layer, folder), str(run.data / layer.path), str(folder / "repaired.gpkg")
    check, repair = "checkannotation", "repairannotation"
    runs = {
        "check": (check, {"INPUT": source, "ISSUES": str(folder / "issues.gpkg")}),
        "check with pixels": (
            check,
            {"INPUT": source, "ISSUES": str(folder / "pixels.gpkg"), "PIXEL_SIZE": layer.pixel_size},
        ),
        "repair": (repair, {"INPUT": source, "OUTPUT": repaired, "CHANGES": str(folder / "changes.gpkg")}),
        "check again": (check, {"INPUT": repaired, "ISSUES": str(folder / "again.gpkg")}),
        "repair again": (
            repair,
            {"INPUT": repaired, "OUTPUT": str(folder / "twice.gpkg"), "CHANGES": str(folder / "none.gpkg")},
        ),
    }
    rows = []
    for title, (algorithm, parameters) in runs.items():
        told = child.run_in_child(algorithm, {**common, **parameters})
        rows.append([name, title, counted(parameters.get("ISSUES") or parameters["CHANGES"]), *figures(told)])
    return rows


def figures(told: dict) -> list[str]:
    """Processor seconds and peak memory of a child."""
    return [f"{told['processor_seconds']:.1f}", f"{told['peak_bytes'] / 1e6:.0f}"]


def layer_remarks(run: inputs.Run, layer: Layer, folder: Path) -> list[str]:
    """What the independent computations say."""
    common, source = settings(layer, folder), str(run.data / layer.path)
    repaired, issues = str(folder / "repaired.gpkg"), str(folder / "issues.gpkg")
    twice = "the same" if same_layer(repaired, str(folder / "twice.gpkg")) else "DIFFERENT"
    return [
        f"repaired twice: {twice}",
        compare_validity(invalid_in_qgis(source), issues),
        compare_overlaps(folder, source, layer, common),
        compare_label_maps(folder, source, repaired, issues, layer, common),
    ]


def rows_of(path: str):
    from osgeo import ogr

    source = ogr.Open(path)
    return [(feature.items(), feature.GetGeometryRef() and feature.GetGeometryRef().Clone()) for feature in source[0]]


def counted(path: str) -> str:
    counts = Counter((row["kind"], row["severity"]) for row, _ in rows_of(path))
    return ", ".join(f"{number} {kind} ({severity})" for (kind, severity), number in sorted(counts.items())) or "none"


def same_layer(one: str, other: str) -> bool:
    def content(path):
        return [(row, bytes(geometry.ExportToWkb())) for row, geometry in rows_of(path)]

    return content(one) == content(other)


def invalid_in_qgis(source: str) -> dict:
    """How many features and parts QGIS finds, and the ids of the invalid features with the number of invalid parts."""
    from qgis.core import QgsVectorLayer

    layer = QgsVectorLayer(source, "source", "ogr")
    features, invalid, parts = 0, [], 0
    for feature in layer.getFeatures():
        geometry = feature.geometry()
        features += 1
        if geometry.isNull():
            continue
        if not geometry.isGeosValid():
            invalid.append(feature.id())
        parts += sum(not part.isGeosValid() for part in geometry.asGeometryCollection())
    return {"features": features, "invalid": invalid, "parts": parts}


def compare_validity(qgis: dict, issues: str) -> str:
    told = [row["feature_id"] for row, _ in rows_of(issues) if row["kind"] == "invalid"]
    return (
        f"invalid: {len(set(told))} features and {len(told)} findings; QGIS: {len(qgis['invalid'])} of "
        f"{qgis['features']} features, {qgis['parts']} parts{'' if set(told) == set(qgis['invalid']) else ' – OTHERS'}"
    )


def compare_overlaps(folder: Path, source: str, layer: Layer, common: dict) -> str:
    """Overlap areas of the first 500 polygons against plain pairwise intersections."""
    from osgeo import gdal, ogr

    subset = str(folder / "subset.gpkg")
    command = ["ogr2ogr", subset, source, "-limit", str(PAIRWISE), "-nlt", "MULTIPOLYGON", "-nln", "subset"]
    subprocess.run(command, check=True, capture_output=True)
    issues = str(folder / "subset_issues.gpkg")
    child.run_in_child("checkannotation", {**common, "INPUT": subset, "ISSUES": issues})
    found = Counter()
    for row, _ in rows_of(issues):
        if row["kind"] == "overlap":
            found[frozenset((row["feature_id"], row["other_id"]))] += row["area"]
    opened = ogr.Open(subset)
    # Intersections may be lines, of which GDAL would say at each that they have no area.
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    shapes = [(f.GetFID(), f[layer.class_field], f.GetGeometryRef().Clone()) for f in opened[0]]
    shapes = [(fid, value, shape if shape.IsValid() else shape.MakeValid()) for fid, value, shape in shapes]
    plain = {}
    for (one, class_one, first), (other, class_other, second) in combinations(shapes, 2):
        if class_one != class_other and first.Intersects(second):
            area = first.Intersection(second).Area()
            if area > SMALLEST_OVERLAP_M2:
                plain[frozenset((one, other))] = area
    gdal.PopErrorHandler()
    found = {pair: area for pair, area in found.items() if area > SMALLEST_OVERLAP_M2}
    farthest = max((abs(found.get(p, 0) - plain.get(p, 0)) for p in {*found, *plain}), default=0)
    return (
        f"overlaps of the first {len(shapes)}: {len(found)} pairs, {sum(found.values()):.3f} m²; pairwise "
        f"{len(plain)} pairs, {sum(plain.values()):.3f} m²; largest difference of a pair {farthest:.1e} m²"
    )


def compare_label_maps(folder: Path, source: str, repaired: str, issues: str, layer: Layer, common: dict) -> str:
    """Pixels that differ before and after, and how many of these lie outside what was reported."""
    from osgeo import gdal, ogr

    maps = []
    extent = None
    for name, path in (("before", source), ("after", repaired)):
        output = str(folder / f"{name}.tif")
        parameters = {**common, "INPUT": path, "PIXEL_SIZE": layer.pixel_size, "OUTPUT": output, "EXTENT": extent}
        if name == "after" and not layer.class_table:
            # Values are numbered by what there is: those of the first map count.
            table = folder / "first.csv"
            table.write_text(gdal.Open(maps[0]).GetMetadataItem("SEMREF_CLASS_TABLE"))
            parameters["CLASS_TABLE"] = str(table)
        child.run_in_child("rasterizeannotation", parameters)
        maps.append(output)
        first = gdal.Open(maps[0])
        x0, pixel, _, y0, _, _ = first.GetGeoTransform()
        extent = f"{x0},{x0 + pixel * first.RasterXSize},{y0 - pixel * first.RasterYSize},{y0}"
    reported = gdal.GetDriverByName("MEM").Create("", first.RasterXSize, first.RasterYSize, 1)
    reported.SetGeoTransform(first.GetGeoTransform())
    reported.SetProjection(first.GetProjection())
    found = ogr.Open(issues)
    findings = found[0]
    findings.SetAttributeFilter("severity = 'error' OR kind IN ('gap', 'sliver')")
    gdal.RasterizeLayer(reported, [1], findings, burn_values=[1], options=["ALL_TOUCHED=TRUE"])
    changed = first.ReadAsArray() != gdal.Open(maps[1]).ReadAsArray()
    outside = changed & (reported.ReadAsArray() == 0)
    return (
        f"label map of {first.RasterXSize} × {first.RasterYSize} pixels of {layer.pixel_size:g} m: {changed.sum()} "
        f"pixels changed, {outside.sum()} of them where no error, gap or sliver was reported"
    )


def large_rows(source: Path, folder: Path) -> list[list[object]]:
    """Check and repair of Liechtenstein side by side with itself."""
    layer = LAYERS["liechtenstein"]
    count = tile_layer(source, folder / "tiled.gpkg")
    common = {**settings(layer, folder), "INPUT": str(folder / "tiled.gpkg")}
    outputs = {"OUTPUT": str(folder / "repaired.gpkg"), "CHANGES": str(folder / "changes.gpkg")}
    rows = []
    for title, algorithm, written in (
        ("check", "checkannotation", {"ISSUES": str(folder / "issues.gpkg")}),
        ("repair", "repairannotation", outputs),
    ):
        told = child.run_in_child(algorithm, {**common, **written})
        rows.append([f"liechtenstein repeated, {count:,} features", title, "", *figures(told)])
    return rows


def tile_layer(path: Path, target_path: Path) -> int:
    """Writes a layer side by side with itself until it has POLYGONS features; returns how many it has."""
    from osgeo import gdal, ogr

    source = ogr.Open(str(path))
    west, east, south, north = source[0].GetExtent()
    copies = -(-POLYGONS // source[0].GetFeatureCount())
    for copy in range(copies):
        x, y = copy % 4 * (east - west + 100), copy // 4 * (north - south + 100)
        options = gdal.VectorTranslateOptions(
            format="GPKG",
            accessMode="append" if copy else None,
            layerName="tiled",
            SQLDialect="SQLite",
            SQLStatement=f'SELECT ShiftCoords(geometry, {x}, {y}) AS geometry, * FROM "{source[0].GetName()}"',
        )
        gdal.VectorTranslate(str(target_path), str(path), options=options)
    return copies * source[0].GetFeatureCount()
