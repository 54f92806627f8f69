"""Does one thing for long and measures what the process that does it holds (Linux).

    python -m tools.soak [--images 10000] [--folder FOLDER]          images through ``python -m core watch``
    python -m tools.soak --flight [--images 10000]                   the same as one flight, killed half way
    python -m tools.soak --localizations 2000 [--folder FOLDER]      runs of semref:localizeimages in one QGIS

Prints a line for each tenth, and ends with 1 when memory, descriptors or threads grew after the first tenth
(``held.MOST_GROWTH_MB``), or when one of the things did not end as it should.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
import time
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]


def main() -> int:
    """Runs it; 0 when nothing grew."""
    from .held import verdict

    parser = argparse.ArgumentParser(prog="python -m tools.soak", description=__doc__.split("\n")[0])
    parser.add_argument("--images", type=int, default=10_000, help="through watch")
    parser.add_argument("--localizations", type=int, help="in one QGIS, instead of images through watch")
    parser.add_argument("--flight", action="store_true", help="images through watch as one flight")
    parser.add_argument("--folder", type=Path, help="empty one to work in (default: a temporary one)")
    options = parser.parse_args()
    folder = options.folder or Path(tempfile.mkdtemp())
    started = time.perf_counter()
    try:
        if options.localizations:
            from .localizing import localize_over_and_over

            rows = localize_over_and_over(options.localizations, folder)
        else:
            from .watching import watch_images

            rows, _ = watch_images(options.images, folder, options.flight)
    finally:
        if options.folder is None:
            shutil.rmtree(folder)
    flat, words = verdict(rows)
    print(f"{rows[-1].done} in {time.perf_counter() - started:.0f} s; {words}")
    return 0 if flat else 1


if __name__ == "__main__":
    sys.exit(main())
