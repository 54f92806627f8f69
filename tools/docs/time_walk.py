"""Time the walk of docs/how-to/train_a_network.md: from orthophoto and polygons to a position, in desktop QGIS.

    .venv/bin/python tools/docs/time_walk.py --python PYTHON_WITH_TORCH [--minutes 5] [--processor-time] [--write]
                                             [--place banepa [--data FOLDER]]

The walk uses a new profile with the packaged plugin on a virtual screen. The ground is the sample area, a folder with
the same files (orthophoto.tif, landcover.shp, photos, photos.csv), or a real place, which walk_ground.py cuts from the
real data. Without the data or torch, the script prints a message and exits. --write replaces table and pictures
of the docs; otherwise they go to the folder --pictures. On a busy machine, --processor-time counts the processor time
of the training instead of elapsed time.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from make_screenshots import IMAGES, LARGEST_BYTES, ROOT, Variant, in_desktop, say_what_is_missing
from palette_png import shrink
from walk_ground import PLACES, RealPlace, fill, lacks

sys.path.append(str(ROOT / "tools"))
from plugin_package import load_plugin_package

load_plugin_package()
from benchmarks import results  # noqa: E402

SESSION = Path(__file__).with_name("walk_session.py")
GUIDE = ROOT / "docs" / "how-to" / "train_a_network.md"
SECTION = "own network walk"
LIMIT_S = 7200
SAMPLE = {
    "polygons": "landcover.shp",
    "buildings_alone": False,
    # Sizes of the sample project: about those of its photos and houses.
    "fields": {"WINDOW_SIZE": "640", "STRIDE": "160", "MINIMUM_AREA": "50"},
    "picture": "",
}
SAMPLE_MARKER = "sample.json"
REAL_PICTURE = "own_network_real_place"
STEPS = {
    "options": "Options: choose the Python of the training environment",
    "layers": "Add orthophoto and polygons to the map, open the dock",
    "train": "Train: time limit ({minutes:g} minutes{details}) and file name",
    "database": "Build the database: {fields}, file name",
    "localize": "Add {photos} photos, press *Localize*",
    "look": "Select the first result",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--python", required=True, help="a Python with torch")
    parser.add_argument("--minutes", type=float, default=5, help="minutes of training")
    parser.add_argument("--processor-time", action="store_true", help="count processor time instead of elapsed time")
    parser.add_argument("--place", choices=PLACES, help="a real place instead of the sample area")
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data", help="folder of the real data")
    parser.add_argument("--ground", type=Path, help="folder with the files of tools/sample")
    parser.add_argument("--folder", type=Path, help="folder of the walk's files, which the pictures show")
    parser.add_argument("--pictures", type=Path, help="folder for the pictures instead of the docs")
    parser.add_argument("--write", action="store_true", help="write table and pictures into the docs")
    arguments = parser.parse_args()
    place = PLACES.get(arguments.place)
    missing = (place and lacks(place, arguments.data)) or lacks_torch(arguments.python)
    if missing:
        print(missing)
        return
    say_what_is_missing([Variant(())])
    with tempfile.TemporaryDirectory(prefix="semref-", dir=arguments.folder) as folder:
        work = Path(folder)
        package = work / "semref.zip"
        make = [sys.executable, str(ROOT / "tools" / "release" / "package.py"), "--output", str(package)]
        subprocess.run(make, check=True)
        python = by_processor_time(work, arguments.python) if arguments.processor_time else arguments.python
        ground = arguments.ground
        if place is not None:
            ground = work / "ground"
            ground.mkdir()
            fill(place, arguments.data, ground)
        seen = walk(package, work / "home", ground, python, arguments.minutes, place)
        keep(work / "home" / "pictures", IMAGES if arguments.write else arguments.pictures, place)
    print(json.dumps(seen, indent=1))
    command = f"tools/docs/time_walk.py --python PYTHON --minutes {arguments.minutes:g}"
    command += " --processor-time" if arguments.processor_time else ""
    command += f" --place {arguments.place}" if place else ""
    is_sample = ground is None or (ground / SAMPLE_MARKER).exists()
    about = f"{place.name}. {place.credit}" if place else "The sample area." if is_sample else "Ground of one's own."
    table = walk_table(seen, arguments.minutes, arguments.processor_time, place)
    body = f"{table}\n\n*{about}* {results.footer(command)}"
    print(body)
    if arguments.write:
        results.write_section(GUIDE, f"{SECTION}, {arguments.place}" if place else SECTION, body)


def lacks_torch(python: str) -> str:
    """Return a message if this Python cannot train; otherwise an empty text."""
    try:
        found = subprocess.run([python, "-c", "import torch"], check=False, capture_output=True).returncode == 0
    except OSError:
        found = False
    return "" if found else f"Not walked: {python} is no Python with torch."


def walk(
    package: Path, home: Path, ground: Path | None, python: str, minutes: float, place: RealPlace | None = None
) -> dict:
    """Run the session and return its result; exit at an error."""
    work, made = home / "work", home / "ground"
    work.mkdir(parents=True)
    # Packaging created it.
    shutil.copytree(ROOT / "sample", made, ignore=shutil.ignore_patterns(".*"))
    job = {"tools": str(SESSION.parent), "ground": str(ground or made), "work": str(work)}
    job |= {"python": str(python), "minutes": minutes, "pictures": str(home / "pictures"), **there(place)}
    (home / "walk.json").write_text(json.dumps(job), encoding="utf-8")
    variables = {"SEMREF_WALK": str(home / "walk.json"), "SEMREF_DESKTOP_RESULT": str(home / "result.json")}
    return in_desktop(Variant(()), package, home, SESSION, variables, LIMIT_S)


def there(place: RealPlace | None) -> dict:
    """Return the job of the session for a place."""
    if place is None:
        return SAMPLE
    return {"polygons": "buildings.gpkg", "buildings_alone": True, "fields": place.fields, "picture": REAL_PICTURE}


def keep(pictures: Path, folder: Path | None, place: RealPlace | None = None) -> None:
    """Write small pictures to the folder, or delete them without a folder. Of a real place keep the last one only."""
    if folder is None:
        return
    folder.mkdir(parents=True, exist_ok=True)
    for picture in sorted(pictures.glob("*.png" if place is None else f"{REAL_PICTURE}.png")):
        shutil.copy(picture, folder)
        shrink(picture, folder / picture.name, LARGEST_BYTES)


def by_processor_time(folder: Path, python: str) -> str:
    """Write a program that trains with this Python and counts minutes of processor time."""
    program = folder / "python"
    program.write_text(_BY_PROCESSOR_TIME.format(own=sys.executable, python=python), encoding="utf-8")
    program.chmod(0o755)
    return str(program)


# The first line cannot have a path with a space. sh reads the second line; for Python it is a string.
_BY_PROCESSOR_TIME = """\
#!/bin/sh
'''exec' "{own}" "$0" "$@"
' '''
import json, os, sys
if len(sys.argv) > 2:
    job = json.load(open(sys.argv[2]))
    json.dump({{**job, "processor_time": True, "threads": 1}}, open(sys.argv[2], "w"))
os.execv({python!r}, [{python!r}, *sys.argv[1:]])
"""


def walk_table(seen: dict, minutes: float, by_processor: bool = False, place: RealPlace | None = None) -> str:
    """Return the clicks and seconds of each step, and the result, as Markdown."""
    details = " of one processor" if by_processor else ""
    details += ", class “other”" if place else ""
    fields = "window size, stride, minimum area"
    fields = f"pixel size, {fields}, classes, class “other”" if place else fields
    names = {"minutes": minutes, "details": details, "photos": seen["photos"], "fields": fields}
    rows = [[STEPS[name].format(**names), clicks, f"{seconds:.0f}"] for name, clicks, seconds in seen["steps"]]
    clicks, seconds = (sum(step[place] for step in seen["steps"]) for place in (1, 2))
    rows.append(["together", clicks, f"{seconds:.0f}"])
    table = results.markdown(["step", "clicks", "seconds"], rows)
    outcome = (
        f"{seen['fixes']} of {seen['photos']} photos have a position, {seen['within_radius']} of them within the "
        f"95 % radius of the true position. Mean IoU of the network: {seen['mean_iou']:.0%}."
    )
    return f"{table}\n\n{outcome}"


if __name__ == "__main__":
    main()
