"""Time the walk of docs/tutorials/own_area_and_photos.md: from orthophoto, map and photos to a position in QGIS.

    .venv/bin/python tools/docs/time_walk.py --place banepa [--minutes 3 --python PYTHON_WITH_TORCH] [--write]

The walk uses the dialog *Set up an area* in a new profile with the packaged plugin on a virtual screen. The ground is
the sample area, or a real place, which walk_ground.py cuts from the real data. --write replaces table and pictures of
the docs; otherwise they go to --pictures.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
import tempfile
from pathlib import Path

from make_screenshots import IMAGES, ROOT, Variant, in_desktop, keep, make_package, say_what_is_missing

sys.path.append(str(ROOT / "tools"))
from plugin_package import load_plugin_package

load_plugin_package()
from walk_ground import PLACES, fill  # noqa: E402

from benchmarks import results  # noqa: E402

GUIDE = ROOT / "docs" / "tutorials" / "own_area_and_photos.md"
SECTION = "own area walk"
SAMPLE_MODEL = "models/sample_area.onnx"
STEPS = {
    "layers": "Drop orthophoto and map on QGIS, open *Set up an area…*",
    "fields": "Enter photos{minutes} and folder",
    "run": "Run",
    "look": "Select the first result",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--python", default="", help="a Python with torch")
    parser.add_argument("--minutes", type=float, default=0, help="minutes of training")
    parser.add_argument("--place", choices=PLACES, help="a real place instead of the sample area")
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data", help="folder of the real data")
    parser.add_argument("--pictures", type=Path, help="folder for the pictures instead of the docs")
    parser.add_argument("--write", action="store_true", help="write table and pictures into the docs")
    arguments = parser.parse_args()
    place = PLACES.get(arguments.place)
    say_what_is_missing([Variant(())])
    with tempfile.TemporaryDirectory(prefix="semref-") as folder:
        work, ground = Path(folder), None
        if place is not None:
            ground = work / "ground"
            ground.mkdir()
            fill(place, arguments.data, ground)
        package = work / "semref.zip"
        make_package(ROOT, package)
        seen = walk(package, work / "home", ground, arguments.python, arguments.minutes)
        target = IMAGES if arguments.write else arguments.pictures
        if target is not None:
            target.mkdir(parents=True, exist_ok=True)
            keep([work / "home" / "pictures" / name for name in seen.pop("taken")], target)
    print(json.dumps(seen, indent=1))
    command = f"tools/docs/time_walk.py --minutes {arguments.minutes:g}"
    command += " --python PYTHON" if arguments.minutes else ""
    command += f" --place {arguments.place}" if place else ""
    about = f"{place.name}. {place.credit}" if place else "The sample area."
    body = f"{walk_table(seen, arguments.minutes)}\n\n*{about}* {results.footer(command)}"
    print(body)
    if arguments.write:
        results.write_section(GUIDE, f"{SECTION}, {arguments.place}, {arguments.minutes:g} minutes", body)


def walk(package: Path, home: Path, ground: Path | None, python: str, minutes: float) -> dict:
    """Run the session and return its result; exit at an error."""
    work, made = home / "work", home / "ground"
    work.mkdir(parents=True)
    # Packaging created it.
    shutil.copytree(ROOT / "sample", made, ignore=shutil.ignore_patterns(".*"))
    job = {"ground": str(ground or made), "work": str(work), "python": str(python), "minutes": minutes}
    job |= {"polygons": "buildings.gpkg" if ground else "landcover.shp"}
    job |= {"model": "" if ground else str(ROOT / SAMPLE_MODEL)}
    return in_desktop(Variant((("walk_session.walk", ""),)), package, home, job)


def walk_table(seen: dict, minutes: float) -> str:
    """Return clicks, seconds and processor seconds of each step, and the result, as Markdown."""
    named = f", training ({minutes:g} minutes)" if minutes else ""
    rows = [[STEPS[name].format(minutes=named), *map(round, numbers)] for name, *numbers in seen["steps"]]
    rows.append(["together", *(round(sum(step[column] for step in seen["steps"])) for column in (1, 2, 3))])
    table = results.markdown(["step", "clicks", "seconds", "processor seconds"], rows)
    outcome = (
        f"{seen['fixes']} of {seen['photos']} photos have a position, {seen['within_radius']} of them within the "
        f"95 % radius of the true position. {seen['expected']}"
    )
    return f"{table}\n\n{outcome}"


if __name__ == "__main__":
    main()
