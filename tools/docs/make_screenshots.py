"""Take the pictures of the docs: SemRef on its sample project, in desktop QGIS on a virtual screen.

- ``.venv/bin/python tools/docs/make_screenshots.py``: all, into docs/images
- with ``dark first_fix``: only these
- with ``films``: the two animations
- with ``--language fr --output DIR``: all tabs in a language
- with ``options --language de --output DIR``: one scene in a language

Each session starts QGIS with a new profile and the packaged plugin. It needs the packages of tools/setup.sh and, for
Chinese, a font with these characters.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import time
import zipfile
from dataclasses import dataclass
from pathlib import Path

from small_pictures import films, join, shrink

ROOT = Path(__file__).resolve().parents[2]
SESSION = Path(__file__).with_name("screenshot_session.py")
IMAGES = ROOT / "docs" / "images"
SCREEN_PX = 2800, 2600
LIMIT_S, TIME_TO_QUIT_S = 900, 20
LARGEST_BYTES, LARGEST_FILM_BYTES = 250_000, 900_000
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
    "first_fix",
    "dock_localize",
    "own_photos",
    "flight",
    "inspect",
    "correct",
    "prior",
    "toolbox",
    "algorithm_dialog",
    "models",
    "add_model",
    "model_designer",
    "options",
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
        package = package_plugin(work)
        for number, variant in enumerate(variants):
            sample = sample_folder(work / "samples", variant.language)
            seen = in_desktop(variant, package, work / str(number), {"sample": str(sample)})
            keep([work / str(number) / "pictures" / name for name in seen["taken"]], arguments.output)


def package_plugin(folder: Path) -> Path:
    """Return the plugin's zip of this working tree."""
    package = folder / "semref.zip"
    tool = ROOT / "tools" / "release" / "package.py"
    subprocess.run([sys.executable, str(tool), "--output", str(package)], check=True)
    return package


def keep(pictures: list[Path], folder: Path) -> None:
    """Write small pictures to the folder; join frames to animations."""
    moving = films(pictures)
    for name, frames in moving.items():
        target = folder / f"{name}.webp"
        join(frames, target, LARGEST_FILM_BYTES)
        print(f"{target} ({target.stat().st_size / 1000:.0f} kB, {len(frames)} frames)", flush=True)
    for picture in sorted(set(pictures) - {frame for frames in moving.values() for frame in frames}):
        target = folder / picture.name
        shrink(picture, target, LARGEST_BYTES)
        print(f"{target} ({target.stat().st_size / 1000:.0f} kB)", flush=True)


def sample_folder(samples: Path, language: str) -> Path:
    """Return the folder of the sample project; for another language a copy without the project file."""
    folder = samples / language / SAMPLE
    made = next(samples.glob(f"*/{SAMPLE}/*.qgz"), None)
    if not folder.exists() and made is not None:
        shutil.copytree(made.parent, folder, ignore=shutil.ignore_patterns("*.qgz"))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


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


def in_desktop(variant: Variant, package: Path, home: Path, job: dict, limit_s: int = LIMIT_S) -> dict:
    """Run the scenes in desktop QGIS with a new profile and return the result of the session; exit at a failure.

    Args:
        variant: Scenes, language and theme.
        package: The plugin's zip.
        home: Folder of the user, also for ``pictures``.
        job: Further keys of the job (screenshot_session.py).
        limit_s: Time limit of the session.
    """
    profile = home / "profiles" / "default"
    runtime, temporary, result = home / "runtime", home / "tmp", home / "result.json"
    for folder in (profile / "QGIS", profile / "python" / "plugins", home / "pictures", temporary):
        folder.mkdir(parents=True)
    runtime.mkdir(mode=0o700)
    with zipfile.ZipFile(package) as archive:
        archive.extractall(profile / "python" / "plugins")
    (profile / "QGIS" / "QGIS3.ini").write_text(settings(variant), encoding="utf-8")
    job |= {"tools": str(SESSION.parent), "pictures": str(home / "pictures"), "result": str(result)}
    (home / "job.json").write_text(json.dumps({**job, "scenes": variant.scenes}), encoding="utf-8")
    environment = {
        "PATH": os.environ["PATH"],
        "LANG": "C.UTF-8",
        "HOME": str(home),
        "XDG_RUNTIME_DIR": str(runtime),
        # Not the folder of the sample: QGIS would mark its layers as temporary.
        "TMPDIR": str(temporary),
        # OpenCV of the virtual environment, because QGIS runs the system's Python.
        "PYTHONPATH": sysconfig.get_path("purelib"),
        "SEMREF_SCREENSHOTS": str(home / "job.json"),
    }
    command = [
        "xvfb-run",
        "--auto-servernum",
        f"--server-args=-screen 0 {SCREEN_PX[0]}x{SCREEN_PX[1]}x24",
        "qgis",
        "--nologo",
        "--noversioncheck",
        "--profiles-path",
        str(home),
        "--code",
        str(SESSION),
    ]
    said = run(command, environment, home / "output.txt", result, limit_s)
    if not result.exists():
        sys.exit(f"QGIS ended without a result. Its output:\n{said}")
    seen = json.loads(result.read_text(encoding="utf-8"))
    problems = [seen.get("error", ""), *seen["messages"]]
    if any(problems):
        sys.exit("\n".join(filter(None, problems)))
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


def run(command: list[str], environment: dict[str, str], log: Path, result: Path, limit_s: int) -> str:
    """Return the output of the command. After the result exists, the command gets a little time and is then ended."""
    with log.open("wb") as stream:
        process = subprocess.Popen(
            command, env=environment, stdin=subprocess.DEVNULL, stdout=stream, stderr=stream, start_new_session=True
        )
        end = time.monotonic() + limit_s
        while process.poll() is None and time.monotonic() < end and not result.exists():
            time.sleep(0.5)
        try:
            process.wait(TIME_TO_QUIT_S)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    return log.read_text(encoding="utf-8", errors="replace")


if __name__ == "__main__":
    main()
