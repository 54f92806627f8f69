"""Four sheets used as one against the database of the whole map: what they hold, answers, opening, bytes written."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from bench import inputs, page, plugin, timing
from bench.ground import Ground, Image, Wanted

PAGE = "benchmarks.md"
SEED = 12
IMAGES = 100
OVERLAPS_M = (0, 200, 600, 1400)
"""By how much sheets overlap; half of each is a multiple of the overview's pixels."""
SEAM_M = 700
"""Sheets meet at multiples of it, of the stride as well."""
NEAR_M = 640
"""Half of the images are centered so near a seam that they show both sides."""


@dataclass(frozen=True)
class Sheets:
    """Databases of four sheets, and the set that names them."""

    overlap: int
    files: tuple[Path, ...]
    set: Path


def measure(run: inputs.Run) -> dict[str, str]:
    """Builds the sheets, compares what they hold together, and localizes the same images in both."""
    from semref.storage.database.reader import read_database

    whole = run.database(run.area.stride)
    ground = Ground.of(run, half="")
    known = read_database(str(whole), with_overview=True, with_bounds=True)
    images = list(_images(ground, run.how_many(IMAGES, 4)))
    answers = [_answers(ground, image) for image in images]
    rows, sheets = [], []
    for overlap in OVERLAPS_M[1:2] if run.quick else OVERLAPS_M:
        sheets.append(_sheets(run, overlap))
        rows.append(_row(ground, sheets[-1], known, images, answers))
    header = [
        *("overlap", "landmarks", "of the whole map’s", "pieces that are whole nowhere", "windows", "overview"),
        *("same answers, constellation", "automatic"),
    ]
    # With the overlap that the guide names.
    usual = sheets[min(1, len(sheets) - 1)]
    candidates = {"whole": _reading(whole), "set": _reading(usual.set)}
    seconds = timing.take_turns(candidates, run.repetitions)
    text = _ABOUT.format(
        count=len(known.references),
        windows=len(known.windows),
        images=len(images),
        seams=len(images) // 2,
        fixes=[sum(of[n].is_fix for of in answers) for n in (0, 1)],
        table=page.table(header, rows),
        overlap=usual.overlap,
        ratio=timing.ratios(seconds["set"], seconds["whole"]).text(),
        seconds=np.median(seconds["whole"]),
        size=page.size(whole.stat().st_size),
        least=page.size(min(file.stat().st_size for file in usual.files)),
        most=page.size(max(file.stat().st_size for file in usual.files)),
    )
    return {"databases_in_parts": text}


_ABOUT = """\
The label map cut into four sheets, a database of each, and a set of the four; landmarks (position, class, area, bounds,
whether the edge cuts them), windows and overview compared with the database of the whole map: {count:,} landmarks,
{windows:,} windows. {images} images with 20 % of the landmarks missed, 20 % invented and 5 % misnamed, half of them
across a seam, localized in both: in the whole map's {fixes[0]} fixes by the constellation and {fixes[1]} by automatic.
An answer is the same if status, place, heading, pixel size, risk and error are, to a millionth.

{table}

Reading the set of sheets that overlap by {overlap} m takes {ratio} times as long as reading the whole database
({seconds:.2f} s). An update writes {least} to {most}, those of one sheet, instead of {size}."""


def _sheets(run: inputs.Run, overlap: int) -> Sheets:
    from osgeo import gdal

    folder = run.work / f"{run.area.name}_sheets_{overlap}"
    folder.mkdir(exist_ok=True)
    labels = gdal.Open(str(run.label_map()))
    width, height = labels.RasterXSize, labels.RasterYSize
    spans = [_spans(size, round(overlap / inputs.PIXEL_SIZE / 2)) for size in (width, height)]
    files = []
    for top, bottom in spans[1]:
        for left, right in spans[0]:
            label_map, database = (folder / f"{left}_{top}{suffix}" for suffix in (".tif", ".gpkg"))
            if not database.exists():
                window = [left, top, right - left, bottom - top]
                gdal.Translate(str(label_map), labels, srcWin=window, creationOptions=["TILED=YES", "COMPRESS=DEFLATE"])
                plugin.run_algorithm("builddatabase", run.build_parameters(label_map, run.area.stride, database))
            files.append(database)
    together = folder / "sheets.semrefset"
    plugin.run_algorithm("combinedatabases", {"DATABASES": list(map(str, files)), "OUTPUT": str(together)})
    return Sheets(overlap, tuple(files), together)


def _spans(size: int, margin: int) -> list[tuple[int, int]]:
    """First and end of the two sheets along an axis, in pixels."""
    middle = _middle(size)
    return [(0, min(middle + margin, size)), (middle - margin, size)]


def _middle(size: int) -> int:
    step = round(SEAM_M / inputs.PIXEL_SIZE)
    return max(round(size / 2 / step), 1) * step


def _images(ground: Ground, count: int):
    """Spoiled images, every other one near a seam."""
    from semref.core.simulation.label_errors import spoil_labels
    from semref.core.simulation.noise import LabelNoise

    rng = np.random.default_rng(SEED)
    noise = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05)
    height, width = ground.labels_hw.shape
    x, y = ground.frame.to_map(np.array([_middle(width), _middle(height)])).tolist()
    everywhere = ground.extent
    left, bottom, right, top = everywhere
    seams = ((x - NEAR_M, bottom, x + NEAR_M, top), (left, y - NEAR_M, right, y + NEAR_M))
    donor: Image | None = None
    for n in range(count):
        ground.extent = everywhere if n % 2 else seams[n // 2 % 2]
        image = ground.draw(Wanted(), rng)
        area = inputs.MINIMUM_AREA / image.view.pixel_size**2
        donor_hw = None if donor is None else donor.labels_hw
        values = ground.spoiled_values
        spoiled = spoil_labels(image.labels_hw, noise.in_pixels(image.view.pixel_size), rng, values, donor_hw, area)
        donor = image
        yield Image(image.query, spoiled, image.landmarks)
    ground.extent = everywhere


def _answers(ground: Ground, image: Image) -> tuple:
    localizer = ground.localizer
    return localizer.localize_by_constellation(image.labels_hw), localizer.localize_automatically(image.labels_hw)


def _row(ground: Ground, sheets: Sheets, known, images: list[Image], answers: list[tuple]) -> list[str]:
    from semref.core.database.joined import cut_landmarks
    from semref.storage.database.reader import read_database, read_parts

    together = read_database(str(sheets.set), with_overview=True)
    parts = [part.parameters for part in read_parts([str(file) for file in sheets.files])]
    other = Ground(ground.labels_hw, together)
    found, true = _landmarks(together.references), _landmarks(known.references)
    windows = _windows(together.windows) & _windows(known.windows)
    same_overview = "the same" if np.array_equal(together.overview, known.overview) else "another"
    found_there = [_answers(other, image) for image in images]
    return [
        f"{sheets.overlap} m",
        f"{len(together.references):,}",
        f"{len(found & true):,} of {len(true):,}",
        f"{cut_landmarks(together, parts):,}",
        f"{len(windows):,} of {len(known.windows):,}",
        same_overview,
        *(_compared([of[n] for of in found_there], [of[n] for of in answers]) for n in (0, 1)),
    ]


def _landmarks(references) -> set[tuple]:
    columns = np.round(references.positions, 6), references.classes, references.areas_m2, references.touches_edge
    return set(map(tuple, np.column_stack([*columns, references.bounds_px]).tolist()))


def _windows(windows) -> set[tuple]:
    keys = np.column_stack([windows.levels, windows.first_pixels, windows.counts]).tolist()
    return {(*key, vector.tobytes()) for key, vector in zip(keys, windows.vectors)}


def _compared(found: list, expected: list) -> str:
    """How many answers are the same; of others, how many fixes there are, and how far apart they are at most."""
    same = sum(map(_same, found, expected))
    if same == len(expected):
        return f"{same} of {same}"
    both = [(one, two) for one, two in zip(found, expected) if one.is_fix and two.is_fix]
    most = max(float(np.hypot(*np.subtract(one.best.position, two.best.position))) for one, two in both)
    fixes = sum(one.is_fix for one in found), sum(two.is_fix for two in expected)
    return f"{same} of {len(expected)}; {fixes[0]} fixes instead of {fixes[1]}, at most {most:.1f} m apart"


def _same(one, two) -> bool:
    if one.status != two.status or (one.best is None) != (two.best is None):
        return False
    pairs = [(of.risk or 0.0, of.error_95_m or 0.0) for of in (one, two)]
    if one.best is not None:
        places = [(*of.best.position, of.best.heading_deg or 0.0, of.best.pixel_size_m or 0.0) for of in (one, two)]
        pairs = [(*place, *pair) for place, pair in zip(places, pairs)]
    return bool(np.allclose(*pairs, rtol=0, atol=1e-6))


def _reading(path: Path) -> Callable[[], float]:
    from semref.storage.database.reader import read_database

    def read() -> float:
        begin = time.perf_counter()
        read_database(str(path), with_overview=True)
        return time.perf_counter() - begin

    return read
