"""Trials that the solvers' settings were set on (docs/calibration.md), on the northern half of Liechtenstein.

    .venv/bin/python tools/calibration NAME [--data FOLDER] [--work FOLDER] [--count N] [--only CASES] [--half north]

NAME is one of
    constellation  the rows of tools/bench localization, and the margins of right and of wrong places
    correlation    map correlation with poor labels: margins, the confidence curve that fits them, radius
    areas          leads and details of map correlation's right and wrong places, and the curve of its risk
    radius         poses refined from beside the right place, also on aerial label maps: error over deviation
    agreement      what each road says of the other's best place, right and wrong
    covariance     coverage and likelihood of true errors under other settings of the errors that landmarks share
    biases         how far off networks show their classes: the shipped one, and --model on --tile of dubai_aerial
    probability    right and wrong places of images of all qualities, the curve that fits them, images of two places
    parts          how well parts of images of one place, and of two, agree with the map where there is a fix
    flights        images of flights measured near their places, and told from others near by; --count flights

They print what a setting is chosen from; nothing is changed. Figures to quote are those of tools/bench, whose images
come from the southern half.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import sys
import tempfile
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
ROOT = TOOLS.parent

# Only packages on the path: a file of ours must not hide a module of the same name.
sys.path[0] = str(TOOLS)

MODULES = {
    "constellation": "trials",
    "correlation": "trials",
    "areas": "areas",
    "radius": "trials",
    "agreement": "trials",
    "covariance": "covariance",
    "biases": "biases",
    "probability": "trials",
    "parts": "parts",
    "flights": "flights",
}
COUNTS = {
    "constellation": 300,
    "correlation": 100,
    "areas": 400,
    "radius": 50,
    "agreement": 100,
    "covariance": 60,
    "biases": 5,
    "probability": 1000,
    "parts": 60,
    "flights": 6,
}


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser("tools/calibration", description=__doc__.splitlines()[0])
    parser.add_argument("name", choices=MODULES)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data", help="the real data's folder")
    parser.add_argument("--work", type=Path, help="folder that keeps label maps and databases between runs")
    parser.add_argument("--count", type=int, help=f"images a case; by default {COUNTS}")
    parser.add_argument("--only", default="", help="cases whose names contain one of these, separated by commas")
    parser.add_argument("--half", default="north", choices=("north", "south"))
    parser.add_argument("--model", type=Path, help="biases: a network that was not trained on --tile of dubai_aerial")
    parser.add_argument("--tile", type=int, default=6, help="biases: default %(default)s")
    options = parser.parse_args(arguments)
    from bench import inputs, plugin

    with contextlib.ExitStack() as stack:
        work = options.work or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="semref-calibration-")))
        work.mkdir(parents=True, exist_ok=True)
        stack.enter_context(plugin.qgis())
        area = inputs.main_area(options.data, work)
        only = tuple(part for part in options.only.split(",") if part)
        count = options.count or COUNTS[options.name]
        measured = options.model, options.tile
        run = inputs.Run(area, options.data, work, 1, False, count, only, options.half, *measured)
        print(area.sentence)
        print(getattr(importlib.import_module(f"calibration.{MODULES[options.name]}"), options.name)(run))
    return 0


if __name__ == "__main__":
    sys.exit(main())
