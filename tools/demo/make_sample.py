"""Make the sample area: a made-up landscape as a shapefile, its class table, and pictures of it with known truth.

    python tools/demo/make_sample.py OUTPUT_FOLDER [--seed 1671] [--pixel-size 1.0]

OUTPUT_FOLDER then holds landcover.shp, classes.csv, images/*.png, truth.csv, orthophoto.tif (a rendered photo of the
whole area), photos/*.jpg, photos.csv and sample.json.
truth.csv and photos.csv give every picture's center: `column`, `row` in pixels of the map ((0.5, 0.5) is the center of
its first pixel) and `x`, `y` in map units; `rotation_deg` is the heading of the picture's top in degrees clockwise from
grid north; `scale` is map pixels per picture pixel; `window` names the window it is centered on, if any.
The same seed gives the same files. A folder made by an earlier run is replaced; any other folder is left alone.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1]))
from qgis_session import load_plugin_package

load_plugin_package()
from semref.core.errors import SemRefError  # noqa: E402
from semref.core.sample import DEFAULT_SEED, pictures  # noqa: E402
from semref.core.sample.classes import CLASSES  # noqa: E402
from semref.core.sample.landscape import make_landscape  # noqa: E402
from semref.storage import sample_files  # noqa: E402
from semref.storage.files import folder_written_beside  # noqa: E402
from semref.storage.pictures import write_png  # noqa: E402

PIXEL_SIZES_M = (0.25, 2.0)  # finer maps take gigabytes, coarser ones are too small for the pictures


def main(arguments: list[str] | None = None) -> int:
    """Run from the command line; returns the exit status."""
    options = parse(arguments)
    target = options.output_folder.absolute()
    try:
        with folder_written_beside(str(target), sample_files.MARKER) as folder:
            report = write_all(Path(folder), options.seed, options.pixel_size)
    except (SemRefError, ValueError) as error:
        print(f"make_sample: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"make_sample: Cannot write {target}: {error.strerror or error}.", file=sys.stderr)
        return 1
    print(f"{report}\nWritten to {target}")
    return 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output_folder", type=Path)
    parser.add_argument("--seed", type=int, default=DEFAULT_SEED, help="any number from 0; default %(default)s")
    parser.add_argument("--pixel-size", type=float, default=1.0, help="meters; default %(default)s")
    options = parser.parse_args(arguments)
    if options.seed < 0:
        parser.error(f"the seed must be 0 or more, not {options.seed}")
    if not PIXEL_SIZES_M[0] <= options.pixel_size <= PIXEL_SIZES_M[1]:
        parser.error("the pixel size must be from {} to {} m, not {}".format(*PIXEL_SIZES_M, options.pixel_size))
    return options


def write_all(folder: Path, seed: int, pixel_size: float) -> str:
    """All files of semref:makesample, then label pictures and their truth.csv; returns the summary."""
    landscape = make_landscape(seed)
    labels = sample_files.rasterize(landscape, pixel_size)
    views = pictures.plan_views(labels.shape, seed)
    photo = sample_files.render_photo(landscape, pixel_size)
    for _ in sample_files.sample_steps(folder, landscape, photo, pixel_size):
        pass
    (folder / "images").mkdir()
    for view in views:
        write_png(folder / "images" / view.name, picture_bands(labels, view))
    sample_files.write_truth(landscape, pixel_size, views, folder / "truth.csv")
    return summary(landscape, labels, views)


def picture_bands(labels_hw: np.ndarray, view: pictures.Picture) -> np.ndarray:
    """(1 or 3, H, W) the view's class values, or its class colors."""
    picture = pictures.cut(labels_hw, view)
    return np.moveaxis(pictures.colored(picture), 2, 0) if view.in_color else picture[None]


def summary(landscape, labels_hw, views) -> str:
    """What was made, as lines of text: features and pixels of each class, oddities, pictures of each kind."""
    counts = Counter(f.class_value for f in landscape.features)
    pixels = np.bincount(labels_hw.ravel(), minlength=256)
    lines = [
        f"Landscape of seed {landscape.seed}: {len(landscape.features)} features, "
        f"label map {labels_hw.shape[1]} × {labels_hw.shape[0]} pixels"
    ]
    lines += [f"  {c.value} {c.name:<11}{counts[c.value]:>6} features {pixels[c.value]:>10} pixels" for c in CLASSES]
    lines.append(f"  0 {'unlabeled':<11}{'':>6}          {pixels[0]:>10} pixels")
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
