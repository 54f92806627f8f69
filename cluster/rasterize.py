"""``rasterize``: an annotation file to a label map by many workers, as ``semref:rasterizeannotation`` makes it."""

from __future__ import annotations

from argparse import Namespace
from typing import Any

from ..core.errors import ParameterError
from ..storage.annotation_file import filled_beneath, read_annotation
from ..storage.burning import burn_job
from ..storage.pixel_grid import Bounds, pixel_grid, union_of_bounds
from ..storage.text_tables import read_class_table
from .burn import burnt
from .inputs import Teller, require_apart, require_unchanged, state


def rasterize(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Makes the label map that the command line asks for. Workers get polygons; the file is read here alone.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        What came of it, by name.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    require_apart(options.annotation, options.labels)
    extent = _extent(options.extent)
    table = read_class_table(options.class_table) if options.class_table else None
    before = {options.annotation: state(options.annotation)}
    teller.step("Reading the annotation", 0.0)
    found = read_annotation(
        options.annotation, options.class_field, options.priority_field or "", table, options.layer or ""
    )
    require_unchanged(before)
    if found.skipped:
        teller.say(f"{found.skipped} features without geometry, area or class were left out.")
    table = found.table.with_filling() if options.other_ground else found.table
    bounds = extent or union_of_bounds([polygon.bounds for polygon in found.polygons])
    frame = pixel_grid(bounds, options.pixel_size, found.crs)
    counts = burnt(burn_job(frame, table, filled_beneath(found.polygons, table)), options, teller)
    height, width = frame.shape_hw
    return {
        "labels": options.labels,
        "width": width,
        "height": height,
        "classes": sum(1 for c in table if c.value and counts[c.value]),
        "labeled_fraction": float(counts[1:].sum() / counts.sum()),
    }


def _extent(text: str | None) -> Bounds | None:
    """Left, bottom, right, top; None where they are left out."""
    if not text:
        return None
    try:
        left, bottom, right, top = (float(part) for part in text.split(","))
    except ValueError:
        raise ParameterError("cluster.no_extent", text=text) from None
    if not (left < right and bottom < top):
        raise ParameterError("cluster.no_extent", text=text)
    return left, bottom, right, top
