"""Benchmarks of SemRef; each prints Markdown and can write it into its section of a page in docs/.

    .venv/bin/python tools/bench NAME... [--data FOLDER] [--work FOLDER] [--repetitions N] [--count N] [--only CASES]
                                         [--write]

NAME is one of those in NAMES below, or all; each is a module of this folder. Times are compared within one run: the
candidates take turns, and the ratio of each turn is what counts. Without the real data (--data, ../shared/data) the
sample area of tools/sample is measured instead, and the text says so. --work keeps label maps and
databases from one run for the next; without it they go into a temporary folder that is removed. The dock needs a
window:
xvfb-run -a -s "-screen 0 1600x1000x24" .venv/bin/python tools/bench dock
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import os
import sys
import tempfile
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
ROOT = TOOLS.parent

# Only packages on the path: a file of ours must not hide a module of the same name.
sys.path[0] = str(TOOLS)

NAMES = (
    "rasterize",
    "build",
    "cluster",
    "memory",
    "large_builds",
    "large_databases",
    "matching",
    "motion",
    "sizes",
    "published",
    "localization",
    "coverage",
    "two_dates",
    "elsewhere",
    "elsewhere_automatic",
    "reliability",
    "area_reliability",
    "catalogue_sizes",
    "astroalign",
    "correlation",
    "large_maps",
    "automatic",
    "footprints",
    "attitude",
    "flights",
    "flight_on_board",
    "route_prediction",
    "real_flights",
    "photos",
    "evidence",
    "new_places",
    "own_ground",
    "own_buildings",
    "infrared_map",
    "groups",
    "foreign_ground",
    "assessment",
    "onboard",
    "segment",
    "annotation",
    "update",
    "dock",
)
KEEPING = (
    "coverage",
    "two_dates",
    "elsewhere",
    "elsewhere_automatic",
    "reliability",
    "correlation",
    "automatic",
    "footprints",
)
"""Those that --kept is for."""

MINIMUM_REPETITIONS = 5


def main(arguments: list[str] | None = None) -> int:
    options = parse(arguments)
    from bench import how_it_grows, inputs, machine, page, plugin, summary, what_works

    if "dock" in options.names and os.environ.get("DISPLAY"):
        # Elsewhere windows are never seen.
        os.environ["QT_QPA_PLATFORM"] = "xcb"
    with contextlib.ExitStack() as stack:
        work = options.work or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="semref-bench-")))
        work.mkdir(parents=True, exist_ok=True)
        os.environ["SEMREF_CACHE"] = str(work / "cache")
        stack.enter_context(plugin.qgis())
        area = inputs.main_area(options.data, work, options.sample)
        print(area.sentence, file=sys.stderr)
        run = inputs.Run(
            area,
            options.data,
            work,
            options.repetitions,
            options.quick,
            options.count,
            options.only,
            options.half,
            options.model,
            options.tile,
            options.python,
            options.pictures,
            options.kept,
        )
        for name in options.names:
            benchmark = importlib.import_module(f"bench.{name}")
            before = machine.load()
            sections = benchmark.measure(run)
            measured = getattr(benchmark, "AREA", area.sentence)
            footer = machine.footer(f"tools/bench {name}{options.shown}", measured, before)
            for section, body in sections.items():
                text = f"{body.strip()}\n\n{footer}"
                print(f"\n## {section}\n\n{text}", flush=True)
                if options.write:
                    page.write_section(ROOT / "docs" / benchmark.PAGE, section, text)
        if options.write:
            path = ROOT / "docs" / "benchmarks.md"
            page.write_section(path, summary.NAME, summary.summary(path.read_text(encoding="utf-8")))
            what_works.write()
            how_it_grows.write()
    return 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser("tools/bench", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="+", choices=(*NAMES, "all"), metavar="NAME", help=", ".join((*NAMES, "all")))
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data", help="the real data's folder")
    parser.add_argument("--work", type=Path, help="folder that keeps label maps and databases between runs")
    parser.add_argument("--repetitions", type=int, default=MINIMUM_REPETITIONS, help="turns; default %(default)s")
    parser.add_argument("--count", type=int, help="images or trials a case, for benchmarks that localize")
    parser.add_argument("--only", default="", help="cases whose names contain one of these, by commas; -PART: not")
    parser.add_argument("--half", default="south", choices=("north", "south"), help="of Liechtenstein, for images")
    parser.add_argument(
        "--model", type=Path, help="photos: a network that was not trained on --tile of dubai_aerial, or a folder"
    )
    parser.add_argument("--tile", type=int, default=6, help="photos: default %(default)s")
    parser.add_argument(
        "--python", default=sys.executable, help="onboard: one without QGIS makes the proof; own_…: one with torch"
    )
    parser.add_argument("--pictures", type=Path, help="assessment: folder for the documentation's pictures")
    parser.add_argument("--sample", action="store_true", help="measure the sample area though the real data is here")
    parser.add_argument("--quick", action="store_true", help="smaller cases, to try the benchmark itself")
    parser.add_argument("--kept", action="store_true", help="measure nothing, tell what --work keeps of each case")
    parser.add_argument("--write", action="store_true", help="write the results into docs/")
    options = parser.parse_args(arguments)
    if "all" in options.names:
        options.names = list(NAMES)
    if options.kept and set(options.names) - set(KEEPING):
        parser.error(f"--kept is for {', '.join(KEEPING)}.")
    options.only = tuple(part for part in options.only.split(",") if part)
    options.shown = _shown(options, parser)
    return options


def _shown(options: argparse.Namespace, parser: argparse.ArgumentParser) -> str:
    """The options that change what is measured, as the footer tells them."""
    shown = "".join(f" --{flag}" for flag in ("sample", "quick", "kept") if getattr(options, flag))
    for name in ("repetitions", "count", "half", "tile"):
        if getattr(options, name) != parser.get_default(name):
            shown += f" --{name} {getattr(options, name)}"
    if options.only:
        shown += f" --only '{','.join(options.only)}'"
    return shown + (f" --model {options.model.name}" if options.model else "")


if __name__ == "__main__":
    sys.exit(main())
