"""Take the pictures of the docs: SemRef on its sample project, in desktop QGIS on a virtual screen.

- ``.venv/bin/python tools/docs/make_screenshots.py``: all, into docs/images
- with ``dark first_fix``: only these
- with ``films``: the two animations
- with ``--language fr --output DIR``: all tabs in a language
- with ``options --language de --output DIR``: one scene in a language

Each session starts QGIS with a new profile and the packaged plugin. It needs the packages of tools/setup.sh and, for
Chinese, a font with these characters.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from small_pictures import films, join, shrink

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "data"))

from desktop_qgis import make_package, run_desktop  # noqa: E402

SESSION = Path(__file__).with_name("screenshot_session.py")
IMAGES = ROOT / "docs" / "images"
SCREEN_PX = 2800, 2600
LARGEST_FILM_BYTES = 900_000
SAMPLE = "semref_sample"
CHINESE_FONT = "fonts-wqy-microhei"


@dataclass(frozen=True)
class Variant:
    """One session of QGIS.

    Attributes:
        scenes: (scene, suffix of the names of its pictures) of each scene.
        theme: Theme of QGIS.
        language: Name of the language in QGIS.
    """

    scenes: tuple[tuple[str, str], ...]
    theme: str = "default"
    language: str = "en_US"


LIGHT = (
    *("first_fix", "dock_localize", "own_photos", "flight", "inspect", "correct", "prior"),
    *("toolbox", "algorithm_dialog", "models", "add_model", "model_designer", "options"),
)
FILMS = ("moving_fix", "moving_flight")

VARIANTS: dict[str, Variant] = {
    "light": Variant(tuple((scene, "") for scene in LIGHT)),
    "films": Variant(tuple((scene, "") for scene in FILMS)),
    "dark": Variant((("whole_window", "_dark"),), theme="Night Mapping"),
    "chinese": Variant((("whole_window", "_chinese"),), language="zh-Hans"),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("only", nargs="*", help="scenes or variants; default: all")
    parser.add_argument("--output", type=Path, default=IMAGES)
    parser.add_argument("--language", action="append", default=[], help="of the scenes, or of all tabs of the dock")
    arguments = parser.parse_args()
    variants = chosen(arguments.only, arguments.language)
    say_what_is_missing(variants)
    arguments.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="semref-screenshots-") as folder:
        work = Path(folder)
        package = work / "semref.zip"
        make_package(ROOT, package)
        for number, variant in enumerate(variants):
            sample = work / "samples" / str(number) / SAMPLE
            sample.mkdir(parents=True)
            seen = in_desktop(variant, package, work / str(number), {"sample": str(sample)})
            keep([work / str(number) / "pictures" / name for name in seen["taken"]], arguments.output)


def keep(pictures: list[Path], folder: Path) -> None:
    """Write small pictures to the folder; join frames to animations."""
    moving = films(pictures)
    for name, frames in moving.items():
        target = folder / f"{name}.webp"
        join(frames, target, LARGEST_FILM_BYTES)
        print(f"{target} ({target.stat().st_size / 1000:.0f} kB, {len(frames)} frames)", flush=True)
    for picture in sorted(set(pictures) - {frame for frames in moving.values() for frame in frames}):
        target = folder / picture.name
        shrink(picture, target)
        print(f"{target} ({target.stat().st_size / 1000:.0f} kB)", flush=True)


def chosen(only: list[str], languages: list[str]) -> list[Variant]:
    unknown = set(only) - set(VARIANTS) - set(LIGHT) - set(FILMS)
    if unknown:
        sys.exit(f"Unknown: {', '.join(sorted(unknown))}. Choose from {', '.join((*VARIANTS, *LIGHT, *FILMS))}.")
    if languages:
        wanted = [name for name in only if name in LIGHT] or ["all_tabs"]
        return [Variant(tuple((name, f"_{one}") for name in wanted), language=one) for one in languages]
    if not only:
        return list(VARIANTS.values())
    variants = [VARIANTS[name] for name in only if name in VARIANTS]
    scenes = tuple((name, "") for name in only if name in (*LIGHT, *FILMS))
    return [*variants, Variant(scenes)] if scenes else variants


def say_what_is_missing(variants: list[Variant]) -> None:
    for program, source in (("qgis", "qgis"), ("xvfb-run", "xvfb")):
        if shutil.which(program) is None:
            sys.exit(f"{program} is missing: apt-get install {source}")
    if any(variant.language.startswith("zh") for variant in variants):
        fonts = subprocess.run(["fc-list", ":lang=zh-cn"], capture_output=True, text=True, check=False).stdout
        if not fonts.strip():
            sys.exit(f"No font has Chinese characters: apt-get install {CHINESE_FONT}")


def in_desktop(variant: Variant, package: Path, home: Path, job: dict) -> dict:
    """Run the scenes in desktop QGIS with a new profile and return the result of the session; exit at a failure.

    Args:
        variant: Scenes, language and theme.
        package: The plugin's zip.
        home: Folder of the user, also for ``pictures``.
        job: Further keys of the job (screenshot_session.py).
    """
    profile, pictures, temporary = home / "profiles" / "default", home / "pictures", home / "tmp"
    for folder in (profile / "QGIS", profile / "python" / "plugins", pictures, temporary):
        folder.mkdir(parents=True)
    with zipfile.ZipFile(package) as archive:
        archive.extractall(profile / "python" / "plugins")
    (profile / "QGIS" / "QGIS3.ini").write_text(settings(variant), encoding="utf-8")
    job |= {"tools": str(SESSION.parent), "pictures": str(pictures), "scenes": variant.scenes}
    (home / "job.json").write_text(json.dumps(job), encoding="utf-8")
    variables = {
        # Not the folder of the sample: QGIS would mark its layers as temporary.
        "TMPDIR": str(temporary),
        "SEMREF_SCREENSHOTS": str(home / "job.json"),
        # Faster than for tests.
        "MALLOC_PERTURB_": "0",
    }
    screen = f"--server-args=-screen 0 {SCREEN_PX[0]}x{SCREEN_PX[1]}x24"
    seen = run_desktop(home, "", SESSION, variables, ("xvfb-run", "--auto-servernum", screen))
    if seen["messages"]:
        sys.exit("\n".join(seen["messages"]))
    return seen


def settings(variant: Variant) -> str:
    """Return the settings of the new profile: active plugins, language and theme."""
    return (
        "[PythonPlugins]\nsemref=true\nprocessing=true\n\n"
        f"[locale]\noverrideFlag=true\nuserLocale={variant.language}\nglobalLocale={variant.language}\n\n"
        f"[UI]\nUITheme={variant.theme}\n\n"
        "[qgis]\ncheckVersion=false\naskToSaveProjectChanges=false\n"
        "\n[app]\naskToSaveMemoryLayers=false\n"
    )


if __name__ == "__main__":
    main()
