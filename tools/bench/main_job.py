"""The main job on the whole area: shapefile → label map → database, as the algorithms report it."""

from __future__ import annotations

import time

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
