"""The main job on the whole area, shapefile → label map → database; and annotation of other makes, rasterized."""

from __future__ import annotations

import re
import time
from dataclasses import dataclass

import numpy as np

from bench import inputs, page, plugin


def measure(run: inputs.Run) -> str:
    from semref.storage.database.reader import read_database

    labels, database = run.work / "main_job.tif", run.work / "main_job.gpkg"
    begin = time.perf_counter()
    rasterized = plugin.run_algorithm("rasterizeannotation", run.rasterize_parameters(labels))
    between = time.perf_counter()
    built = plugin.run_algorithm("builddatabase", run.build_parameters(labels, run.area.stride, database))
    end = time.perf_counter()
    pixels = inputs.read_labels(labels)
    content = read_database(str(database))
    windows, references = content.windows, content.references
    names = {c.value: c.name for c in content.class_table}
    classes = ", ".join(
        f"{names[value]} {number:,}" for value, number in zip(*np.unique(references.classes, return_counts=True))
    )
    height, width = pixels.shape
    lacking = int((~windows.described).sum())
    empty = int((windows.counts == 0).sum())
    rows = [
        [
            "`semref:rasterizeannotation`",
            f"{between - begin:.1f}",
            page.size(labels.stat().st_size),
            f"{width:,} × {height:,} pixels, {(pixels > 0).mean():.1%} labeled",
        ],
        [
            "`semref:builddatabase`",
            f"{end - between:.1f}",
            page.size(database.stat().st_size),
            f"{len(windows):,} windows, {len(references):,} landmarks ({classes})",
        ],
    ]
    said = "\n".join(f"> {line}  " for line in (*_said(rasterized.log), *_said(built.log)))
    lacking_text = (
        f"{lacking:,} of {len(windows):,} windows ({lacking / len(windows):.0%}) show fewer than three landmarks and "
        f"have no vector; {empty:,} of them show none at all (the map is a rectangle around the country)."
    )
    return f"{page.table(['step', 's', 'file', 'result'], rows)}\n\n{lacking_text} The algorithms said:\n\n{said}"


def _said(log: tuple[str, ...]) -> list[str]:
    """What an algorithm said for people: no progress, no echo of parameters."""
    noise = ("Burning", "Finding", "Describing", "Writing", "Results")
    return [line for line in log if not line.startswith(noise)]


# --- annotation of other makes ---


@dataclass(frozen=True)
class Case:
    """A layer of the real data, its class field, and a pixel size in meters."""

    title: str
    source: str
    field: str
    pixel_size: float


CASES = (
    Case("Liechtenstein land cover", "osm_liechtenstein_2021/li_landcover_2021.shp", "class", 1.0),
    Case("LCDB Christchurch", "lcdb5_christchurch/lcdb5_christchurch.gpkg", "Name_2018", 10.0),
    Case("Berlin urban gradient", "berlin_urban_gradient/LandCov_BerlinUrbanGradient.shp", "Level_2", 3.6),
    Case("OSM Belgrade land use", "osm_belgrade/landuse.shp", "type", 5.0),
    Case("Swellendam buildings", "swellendam/training_data.gpkg|layername=buildings", "building", 1.0),
)


def other_data(run: inputs.Run) -> str:
    """What the algorithm repaired, skipped and chose of other layers, from its own log."""
    rows = []
    for case in CASES:
        if not (run.data / case.source.partition("|")[0]).exists():
            rows.append([case.title, "not here"] + [""] * 7)
            continue
        rows.append(_row(run, case))
    header = [
        "layer (field, pixel)",
        "features used",
        "multipart",
        "repaired",
        "skipped",
        "CRS of the label map",
        "pixels",
        "classes on the map",
        "s",
    ]
    return page.table(header, rows)


def _row(run: inputs.Run, case: Case) -> list[str]:
    from osgeo import gdal, osr

    output = run.work / "other.tif"
    parameters = {"INPUT": str(run.data / case.source), "CLASS_FIELD": case.field, "PIXEL_SIZE": case.pixel_size}
    begin = time.perf_counter()
    found = plugin.run_algorithm("rasterizeannotation", {**parameters, "OUTPUT": str(output)})
    seconds = time.perf_counter() - begin
    dataset = gdal.Open(str(output))
    system = osr.SpatialReference(dataset.GetProjection())
    log = " ".join(found.log)
    reprojected = " (reprojected)" if "does not measure in meters" in log else ""
    return [
        f"{case.title} (`{case.field}`, {case.pixel_size:g} m)",
        _first(r"Used: (\d+) feature", log),
        _first(r"(\d+) of them multipart", log),
        _first(r"Repaired invalid geometry: (\d+ features?, \d+ polygons?)", log),
        "; ".join(f"{number} {what}" for what, number in re.findall(r"Skipped, ([^:]+): (\d+) feature", log)) or "0",
        f"EPSG:{system.GetAuthorityCode(None)} {system.GetName()}{reprojected}",
        f"{dataset.RasterXSize:,} × {dataset.RasterYSize:,}",
        str(found.results["CLASS_COUNT"]),
        f"{seconds:.1f}",
    ]


def _first(pattern: str, text: str) -> str:
    found = re.search(pattern, text)
    return found.group(1) if found else "0"
