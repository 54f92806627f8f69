"""Make the sample area: a made-up landscape as a shapefile, its class table, and pictures of it with known truth.

    .venv/bin/python -m tools.sample                                         # sample/, which ships with the plugin
    .venv/bin/python -m tools.sample FOLDER [--seed 1671]

The folder then holds landcover.shp, classes.csv, orthophoto.tif (a rendered photo of the whole area), photos/*.jpg and
photos.csv, flight/*.jpg and flight.csv, sample.json.
The tables have the center of every image: `column`, `row` in pixels of the map ((0.5, 0.5) is the center of its first
pixel), and `x`, `y` in map units. The heading of the image's top (`rotation_deg`) is in degrees clockwise from grid
north. The scale is in map pixels per image pixel.

The same seed gives the same files. The script does not write to a FOLDER with files. Without FOLDER it does nothing if
sample/ was made by the current code; otherwise it replaces sample/.
"""

from __future__ import annotations

import argparse
import hashlib
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SHIPPED = ROOT / "sample"
MADE_OF = ".made_of"
"""File in SHIPPED with the hash of the code that made it; hidden files do not ship."""

USED = (ROOT / "core" / "simulation" / "views.py", ROOT / "core" / "annotation" / "polygons.py")


def main(arguments: list[str] | None = None) -> int:
    """Run from the command line; returns the exit status."""
    options = parse(arguments)
    made_of = "" if options.folder else code_hash()
    target = (options.folder or SHIPPED).absolute()
    if made_of and (target / MADE_OF).is_file() and (target / MADE_OF).read_text(encoding="ascii") == made_of:
        return 0
    sys.path.append(str(HERE.parent))
    from plugin_package import load_plugin_package

    load_plugin_package()
    from semref.core.errors import SemRefError
    from semref.storage.atomic_output import folder_written_beside

    from .files import write_sample
    from .landscape import make_landscape

    print(f"Creating the sample area in {target}")
    try:
        with folder_written_beside(str(target), replaces=bool(made_of)) as folder:
            write_sample(Path(folder), make_landscape(options.seed))
            if made_of:
                (Path(folder) / MADE_OF).write_text(made_of, encoding="ascii")
    except (SemRefError, ValueError, OSError) as error:
        print(f"tools.sample: {error}", file=sys.stderr)
        return 1
    return 0


def code_hash() -> str:
    """SHA-256 of the generator's code."""
    return hashlib.sha256(b"".join(path.read_bytes() for path in (*sorted(HERE.glob("*.py")), *USED))).hexdigest()


def parse(arguments: list[str] | None) -> argparse.Namespace:
    from . import DEFAULT_SEED

    parser = argparse.ArgumentParser("tools.sample", description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", help="default: sample/ of this checkout, which ships")
    parser.add_argument("--seed", type=int, default=DEFAULT_SEED, help="any number from 0; default %(default)s")
    options = parser.parse_args(arguments)
    if options.seed < 0:
        parser.error(f"the seed must be 0 or more, not {options.seed}")
    if options.folder is None and options.seed != DEFAULT_SEED:
        parser.error("choose a folder for an area other than the shipped one")
    return options


if __name__ == "__main__":
    sys.exit(main())
