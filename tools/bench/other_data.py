"""Annotation of other makes, rasterized: what the algorithm repaired, skipped and chose, from its own log."""

from __future__ import annotations

import re
import time
from dataclasses import dataclass

from bench import inputs, page, plugin


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


def measure(run: inputs.Run) -> str:
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
