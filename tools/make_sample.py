"""Make the sample area: a made-up landscape as a shapefile, its class table, and pictures of it with known truth.

    python tools/make_sample.py OUTPUT_FOLDER [--seed 1671] [--pixel-size 1.0]

OUTPUT_FOLDER then holds landcover.shp, classes.csv, images/*.png, truth.csv, orthophoto.tif (a rendered photo of the
whole area), photos/*.jpg, photos.csv and sample.json.
truth.csv and photos.csv give every picture's centre: `column`, `row` in pixels of the map ((0.5, 0.5) is the centre of
its first pixel) and `x`, `y` in map units; `rotation_deg` is the heading of the picture's top in degrees clockwise from
grid north; `scale` is map pixels per picture pixel; `window` names the window it is centred on, if any.
The same seed gives the same files. A folder made by an earlier run is replaced; any other folder is left alone.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections import Counter
from pathlib import Path

DEFAULT_SEED = 1671  # the paper's number in Remote Sensing
PIXEL_SIZES_M = (0.25, 2.0)  # finer maps take gigabytes, coarser ones are too small for the pictures
MARKER = "sample.json"  # tells a folder of ours from somebody's data
MAKER = "semref make_sample"


def main(arguments: list[str] | None = None) -> int:
    """Run from the command line; returns the exit status."""
    options = parse(arguments)
    try:
        from sample.writers import SampleError
    except ImportError as error:
        print(f"make_sample: {error}. Run it with the Python of the project's .venv.", file=sys.stderr)
        return 1
    try:
        check_target(options.output_folder)
        report = build(options.output_folder, options.seed, options.pixel_size)
    except (SampleError, ValueError, RuntimeError) as error:  # RuntimeError: GDAL where its exceptions are on
        print(f"make_sample: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"make_sample: Cannot write {options.output_folder}: {error.strerror or error}.", file=sys.stderr)
        return 1
    print(report)
    return 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output_folder", type=Path)
    parser.add_argument("--seed", type=int, default=DEFAULT_SEED, help="any number from 0; default %(default)s")
    parser.add_argument("--pixel-size", type=float, default=1.0, help="metres; default %(default)s")
    options = parser.parse_args(arguments)
    if options.seed < 0:
        parser.error(f"the seed must be 0 or more, not {options.seed}")
    if not PIXEL_SIZES_M[0] <= options.pixel_size <= PIXEL_SIZES_M[1]:
        parser.error("the pixel size must be from {} to {} m, not {}".format(*PIXEL_SIZES_M, options.pixel_size))
    return options


def check_target(folder: Path) -> None:
    """Raises ValueError when the output folder exists and holds something that is not ours."""
    if not folder.exists():
        return
    if not folder.is_dir():
        raise ValueError(f"{folder} is a file; choose a folder.")
    if any(folder.iterdir()) and not is_ours(folder):
        raise ValueError(f"{folder} holds other files and is left alone; choose a new or empty folder.")


def is_ours(folder: Path) -> bool:
    try:
        return json.loads((folder / MARKER).read_text(encoding="utf-8")).get("made_by") == MAKER
    except (OSError, ValueError, AttributeError):
        return False


def build(target: Path, seed: int, pixel_size: float) -> str:
    """Make everything in a folder beside the target, then move it into place; returns the summary."""
    target = target.absolute()
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f".{target.name}-", dir=target.parent) as temporary:
        made = Path(temporary) / "sample"
        (made / "images").mkdir(parents=True)
        report = write_all(made, seed, pixel_size)
        if target.exists():
            target.rename(Path(temporary) / "replaced")  # goes with the temporary folder
        made.rename(target)
    return f"{report}\nWritten to {target}"


def write_all(folder: Path, seed: int, pixel_size: float) -> str:
    """Write all files of the sample into an existing folder; returns the summary."""
    from sample import pictures, writers
    from sample.landscape import make_landscape

    landscape = make_landscape(seed)
    writers.write_shapefile(landscape, folder)
    writers.write_classes(folder / "classes.csv")
    labels = writers.rasterize(landscape, pixel_size)
    views = pictures.plan_views(labels.shape, seed)
    writers.write_pictures(labels, views, folder / "images")
    writers.write_truth(landscape, pixel_size, views, folder / "truth.csv")
    write_photos(folder, landscape, pixel_size, seed)
    marker = {
        "made_by": MAKER,
        "seed": seed,
        "pixel_size": pixel_size,
        "window_size": pictures.WINDOW_PX,
        "stride": pictures.STRIDE_PX,
        "width": labels.shape[1],
        "height": labels.shape[0],
        "images": len(views),
    }
    (folder / MARKER).write_text(json.dumps(marker, indent=2) + "\n", encoding="utf-8")
    return summary(landscape, labels, views)


def write_photos(folder: Path, landscape, pixel_size: float, seed: int) -> None:
    """orthophoto.tif, photos/*.jpg and photos.csv."""
    from sample import photo, pictures, writers

    picture = photo.render(landscape, writers.grid_of(landscape, pixel_size), pixel_size)
    writers.write_orthophoto(landscape, pixel_size, picture, folder / "orthophoto.tif")
    views = pictures.plan_photos(picture.shape[:2], seed)
    (folder / "photos").mkdir()
    writers.write_photos(picture, views, seed, folder / "photos")
    writers.write_truth(landscape, pixel_size, views, folder / "photos.csv")


def summary(landscape, labels_hw, views) -> str:
    """What was made, as lines of text: features and pixels of each class, oddities, pictures of each kind."""
    import numpy as np
    from sample.classes import CLASSES

    counts = Counter(f.class_value for f in landscape.features)
    pixels = np.bincount(labels_hw.ravel(), minlength=256)
    lines = [
        f"Landscape of seed {landscape.seed}: {len(landscape.features)} features, "
        f"label map {labels_hw.shape[1]} × {labels_hw.shape[0]} pixels"
    ]
    lines += [f"  {c.value} {c.name:<11}{counts[c.value]:>6} features {pixels[c.value]:>10} pixels" for c in CLASSES]
    lines.append(f"  0 {'unlabelled':<11}{'':>6}          {pixels[0]:>10} pixels")
    shapes = [f.geometry for f in landscape.features if f.geometry is not None]
    holes = sum(any(p.interiors for p in getattr(s, "geoms", [s])) for s in shapes)
    lines.append(
        f"  oddities: {sum(s.geom_type == 'MultiPolygon' for s in shapes)} multipart, {holes} with holes, "
        f"{sum(not s.is_valid for s in shapes)} invalid, {len(landscape.features) - len(shapes)} empty"
    )
    kinds = Counter(v.kind for v in views)
    lines.append(f"  {len(views)} pictures: " + ", ".join(f"{n} {kind}" for kind, n in kinds.items()))
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
