"""Makes sheets of everything that SemRef shows, to be looked at: tabs, dialogs, layers, in each look and language.

    .venv/bin/python tools/docs/make_look_sheets.py --output DIR                     # all looks
    .venv/bin/python tools/docs/make_look_sheets.py --output DIR dark zh rtl         # only these
    .venv/bin/python tools/docs/make_look_sheets.py --output DIR --scene tabs zh     # only these scenes

Each look is a session of QGIS with a fresh profile and the packaged plugin. Beside the sheets lies each picture alone.
Nothing of it is kept in the repository. For Chinese a font with its characters is needed.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from make_screenshots import ROOT, Variant, sample_folder, say_what_is_missing, take
from PIL import Image, ImageDraw

SCENES = "tabs", "window", "menus", "windows", "dialogs"
MORE = "flight", "layers"
SHEET_PX = 1800, 1500
CELL_PX = 590
GAP_PX, TITLE_PX = 10, 16


def look(**dressed) -> Variant:
    return Variant(tuple((scene, "") for scene in SCENES), module="look_scenes", **dressed)


LOOKS = {
    "light": look(),
    "dark": look(theme="Night Mapping"),
    "contrast": look(palette="contrast"),
    "scale_200": look(scale=2),
    "large_font": look(font_pt=18),
    "de": look(language="de"),
    "fr": look(language="fr"),
    "es": look(language="es"),
    "zh": look(language="zh-Hans"),
    "rtl": look(reverse=True),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("looks", nargs="*", choices=[*LOOKS, []], help="all without any")
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--samples", type=Path, help="folder to keep the sample projects in, one a language")
    parser.add_argument("--scene", action="append", default=[], choices=[*SCENES, *MORE])
    arguments = parser.parse_args()
    chosen = {name: LOOKS[name] for name in arguments.looks or LOOKS}
    say_what_is_missing(list(chosen.values()))
    with tempfile.TemporaryDirectory(prefix="semref-looks-") as folder:
        work = Path(folder)
        package = work / "semref.zip"
        subprocess.run(
            [sys.executable, str(ROOT / "tools" / "release" / "package.py"), "--output", str(package)], check=True
        )
        failed: list[str] = []
        for name, variant in chosen.items():
            scenes = tuple((scene, "") for scene in arguments.scene) or variant.scenes
            variant = Variant(**{**vars(variant), "scenes": scenes})
            sample = sample_folder(arguments.samples or work / "samples", variant.language)
            target = arguments.output / name
            target.mkdir(parents=True, exist_ok=True)
            try:
                pictures = [keep(picture, target) for picture in take(variant, package, sample, work / name)]
            except SystemExit as problem:
                failed.append(f"{name}: {problem}")
                continue
            for number, sheet in enumerate(sheets(pictures)):
                sheet.save(target / f"sheet_{number:02d}.png")
            print(target, flush=True)
    if failed:
        sys.exit("\n".join(failed))


def keep(picture: Path, folder: Path) -> Path:
    return picture.replace(folder / picture.name)


def sheets(pictures: Sequence[Path]) -> list[Image.Image]:
    """The pictures with their names, side by side and one below the other, on as many sheets as they need."""
    made: list[Image.Image] = []
    left = top = row = SHEET_PX[1]
    for path in pictures:
        cell = Image.open(path).convert("RGB")
        cell.thumbnail((CELL_PX, SHEET_PX[1] - TITLE_PX))
        if left + cell.width > SHEET_PX[0]:
            left, top, row = 0, top + row, 0
        if top + TITLE_PX + cell.height > SHEET_PX[1]:
            made.append(Image.new("RGB", SHEET_PX, "#808080"))
            left = top = row = 0
        ImageDraw.Draw(made[-1]).text((left, top), path.stem, fill="white")
        made[-1].paste(cell, (left, top + TITLE_PX))
        left, row = left + cell.width + GAP_PX, max(row, TITLE_PX + cell.height + GAP_PX)
    return made


if __name__ == "__main__":
    main()
