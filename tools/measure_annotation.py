"""Measure checking and repairing annotations on real layers and print Markdown.

    python tools/measure_annotation.py [--only liechtenstein,berlin,belgrade,christchurch] [--polygons 200000]
                                       [--scale-runs check,repair]

Reads ../shared/data (or SEMREF_DATA). Each run is a process of its own; times are its processor times, so that other
programs don't count, and memory is its peak, QGIS with it. Independent checks: QGIS's own validity check of each
feature, and pairwise intersections of GDAL's geometries of 500 polygons. QGIS is never loaded in this process: shapely,
which tiles the large layer, would then run on QGIS's GEOS, which can't write what this shapely asks of it.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"
for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
VALIDITY = "validity"
PAIRWISE = 500
SMALLEST_OVERLAP_M2 = 0.01
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
    "liechtenstein, no priority": Layer("osm_liechtenstein_2021/li_landcover_2021.shp", "class", 1.0, "", CLASSES),
    "berlin": Layer("berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp", "Level_2", 1.0),
    "belgrade": Layer("osm_belgrade/landuse.shp", "type", 1.0),
    "christchurch": Layer("lcdb5_christchurch/lcdb5_christchurch.gpkg", "Name_2018", 15.0),
}


def main() -> int:
    options = parse()
    if options.job:
        return run_job(*options.job)
    with tempfile.TemporaryDirectory() as folder:
        for name in options.only:
            layer = LAYERS[name]
            if not (DATA / layer.path).exists():
                print(f"measure_annotation: the real data is not here: {DATA / layer.path}")
                continue
            measure(name, layer, Path(folder) / name.replace(", ", "_").replace(" ", "_"))
        if options.polygons:
            measure_scale(options.polygons, Path(folder) / "scale", options.scale_runs.split(","))
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default=",".join(name for name in LAYERS if "," not in name))
    parser.add_argument("--no-priority", action="store_true", help="Liechtenstein without its priority field, too")
    parser.add_argument("--polygons", type=int, default=200_000, help="size of the tiled layer; 0 leaves it out")
    parser.add_argument("--scale-runs", default="check,repair", help="of the tiled layer")
    parser.add_argument("--job", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    options.only = [name for name in options.only.split(",") if name]
    if options.no_priority:
        options.only.append("liechtenstein, no priority")
    return options


def measure(name: str, layer: Layer, folder: Path) -> None:
    folder.mkdir()
    table = folder / "classes.csv"
    table.write_text(layer.class_table)
    common = {"CLASS_FIELD": layer.class_field, "PRIORITY_FIELD": layer.priority_field or None}
    common["CLASS_TABLE"] = str(table) if layer.class_table else None
    source, issues = str(DATA / layer.path), str(folder / "issues.gpkg")
    repaired, twice = str(folder / "repaired.gpkg"), str(folder / "twice.gpkg")
    runs = {
        "check": ("checkannotation", {"INPUT": source, "ISSUES": issues}),
        "check with pixels": (
            "checkannotation",
            {"INPUT": source, "ISSUES": str(folder / "pixels.gpkg"), "PIXEL_SIZE": layer.pixel_size},
        ),
        "repair": ("repairannotation", {"INPUT": source, "OUTPUT": repaired, "CHANGES": str(folder / "changes.gpkg")}),
        "check again": ("checkannotation", {"INPUT": repaired, "ISSUES": str(folder / "again.gpkg")}),
        "repair again": (
            "repairannotation",
            {"INPUT": repaired, "OUTPUT": twice, "CHANGES": str(folder / "none.gpkg")},
        ),
    }
    print(f"\n### {name}: {layer.path}\n\n| run | findings by kind | s | peak MB |\n|---|---|---|---|")
    for title, (algorithm, parameters) in runs.items():
        told = in_process(algorithm, {**common, **parameters})
        found = parameters.get("ISSUES") or parameters["CHANGES"]
        print(f"| {title} | {counted(found)} | {told['seconds']:.1f} | {told['megabytes']:.0f} |", flush=True)
    print(f"\n- repaired twice: {'the same' if same_layer(repaired, twice) else 'DIFFERENT'}")
    print(f"- {compare_validity(in_process(VALIDITY, {'source': source}), issues)}")
    print(f"- {compare_overlaps(folder, source, layer, common)}")
    print(f"- {compare_label_maps(folder, source, repaired, issues, layer, common)}", flush=True)


def in_process(algorithm: str, parameters: dict) -> dict:
    command = [sys.executable, __file__, "--job", algorithm, json.dumps(parameters)]
    answer = subprocess.run(command, check=True, capture_output=True, text=True)
    return json.loads(answer.stdout.splitlines()[-1])


def run_job(algorithm: str, parameters: str) -> int:
    from bench.child import peak_bytes

    run = start_qgis()
    if algorithm == VALIDITY:
        print(json.dumps(invalid_in_qgis(**json.loads(parameters))), flush=True)
        os._exit(0)
    started = time.process_time()
    run(f"semref:{algorithm}", json.loads(parameters))
    seconds = time.process_time() - started
    megabytes = peak_bytes() / 1e6
    print(json.dumps({"seconds": seconds, "megabytes": megabytes}), flush=True)
    # QGIS has nothing to save, and leaving it takes long.
    os._exit(0)


def start_qgis():
    """`run(algorithm id, parameters)` in a QGIS with the provider."""
    import importlib.util

    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)
    from qgis.core import QgsApplication

    start_qgis.application = QgsApplication([], False)
    start_qgis.application.initQgis()
    sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
    import processing
    from processing.core.Processing import Processing

    from semref.processing.provider import register_provider

    Processing.initialize()
    start_qgis.provider = register_provider(QgsApplication.processingRegistry())
    return processing.run


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
    if not layer.isValid():
        sys.exit(f"{source} can't be read.")
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
    in_process("checkannotation", {**common, "INPUT": subset, "ISSUES": issues})
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
        in_process("rasterizeannotation", parameters)
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


def measure_scale(polygons: int, folder: Path, runs: list) -> None:
    """Liechtenstein side by side with itself."""
    from osgeo import ogr

    layer = LAYERS["liechtenstein"]
    if not (DATA / layer.path).exists():
        return
    folder.mkdir()
    source = ogr.Open(str(DATA / layer.path))
    west, east, south, north = source[0].GetExtent()
    tiled = ogr.GetDriverByName("GPKG").CreateDataSource(str(folder / "tiled.gpkg"))
    target = tiled.CreateLayer("tiled", source[0].GetSpatialRef(), ogr.wkbPolygon)
    for field in source[0].schema:
        target.CreateField(field)
    target.StartTransaction()
    copies = -(-polygons // source[0].GetFeatureCount())
    import shapely

    for copy in range(copies):
        offset = (copy % 4 * (east - west + 100), copy // 4 * (north - south + 100))
        for feature in source[0]:
            shape = shapely.transform(
                shapely.from_wkb(bytes(feature.GetGeometryRef().ExportToWkb())), lambda xy, by=offset: xy + by
            )
            made = ogr.Feature(target.GetLayerDefn())
            made.SetFrom(feature)
            made.SetFID(-1)
            made.SetGeometry(ogr.CreateGeometryFromWkb(shapely.to_wkb(shape, output_dimension=3)))
            target.CreateFeature(made)
    count = target.GetFeatureCount()
    target.CommitTransaction()
    del target, tiled
    table = folder / "classes.csv"
    table.write_text(layer.class_table)
    common = {"CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "CLASS_TABLE": str(table)}
    common["INPUT"] = str(folder / "tiled.gpkg")
    print(f"\n### {count} polygons: Liechtenstein {copies} times\n\n| run | s | peak MB |\n|---|---|---|")
    for title, algorithm, outputs in (
        ("check", "checkannotation", {"ISSUES": str(folder / "issues.gpkg")}),
        ("repair", "repairannotation", {"OUTPUT": str(folder / "repaired.gpkg"), "CHANGES": str(folder / "c.gpkg")}),
    ):
        if title not in runs:
            continue
        told = in_process(algorithm, {**common, **outputs})
        print(f"| {title} | {told['seconds']:.1f} | {told['megabytes']:.0f} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
