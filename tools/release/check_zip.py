"""Check a zip before its release: .venv/bin/python tools/release/check_zip.py FILE [VERSION]."""

import ast
import re
import sys
import zipfile
from pathlib import Path, PurePosixPath

from changelog import releases
from metadata import general

BINARY_SUFFIXES = (".onnx", ".png", ".webp", ".tif", ".jpg", ".shp", ".shx", ".dbf", ".qm")
"""Suffixes of the sample model, pictures, the sample area and translations. The plugin repository rejects other
binaries."""

MAXIMUM_BYTES = 25 * 1024 * 1024  # limit of plugins.qgis.org
REQUIRED = (
    *("name", "description", "about", "version", "qgisMinimumVersion", "author", "email"),
    *("homepage", "repository", "tracker", "license", "icon", "changelog"),
)
LANGUAGES = ("de", "es", "fr", "zh")
FOR_DEVELOPERS = {"tests", "tools", "docs"}
HELP_START = "semref/help/index.html"
SAMPLE_MARKER = "semref/sample/sample.json"


def faults(package: Path, version: str = "") -> list[str]:
    """Return the reasons against a release of the zip, one sentence each.

    Args:
        package: The zip.
        version: The expected version; empty for any.
    """
    if package.stat().st_size > MAXIMUM_BYTES:
        return [f"The zip has {package.stat().st_size / 1024**2:.1f} MB; the plugin repository accepts at most 25."]
    with zipfile.ZipFile(package) as archive:
        contents = {name: archive.read(name) for name in archive.namelist()}
    return [*_of_names(contents), *_of_contents(contents), *_of_metadata(contents, version)]


def _of_names(contents: dict[str, bytes]) -> list[str]:
    found = []
    for name in contents:
        parts = PurePosixPath(name).parts
        if parts[0] != "semref" or ".." in parts:
            found.append(f"{name} is not in the folder semref.")
        elif any(part.startswith(".") for part in parts) or name.endswith(".pyc") or parts[1] in FOR_DEVELOPERS:
            found.append(f"{name} is not for users.")
    languages = {PurePosixPath(name).stem.split("_")[1] for name in contents if name.endswith(".qm")}
    found += [f"The translation into {language} is missing." for language in LANGUAGES if language not in languages]
    if HELP_START not in contents:
        found.append("The guide is missing; run tools/docs/build_site.py before packaging.")
    if SAMPLE_MARKER not in contents:
        found.append("The sample area is missing; run python -m tools.sample before packaging.")
    return found


def _of_contents(contents: dict[str, bytes]) -> list[str]:
    found = []
    for name, content in contents.items():
        if PurePosixPath(name).suffix in BINARY_SUFFIXES:
            continue
        try:
            text = content.decode("utf-8")
            if "\0" in text:
                found.append(f"{name} is binary.")
            if name.endswith(".py"):
                ast.parse(text, name, feature_version=(3, 9))
        except (UnicodeDecodeError, SyntaxError) as error:
            found.append(f"{name}: {error}")
    return found


def _of_metadata(contents: dict[str, bytes], version: str) -> list[str]:
    text = contents.get("semref/metadata.txt", b"[general]").decode("utf-8")
    found = general(text)
    keys = [*REQUIRED, *(f"{key}[{language}]" for key in ("description", "about") for language in LANGUAGES)]
    wrong = [f"metadata.txt lacks {key}." for key in keys if not found.get(key)]
    # QGIS reads the file with Python's interpolation, which fails at this sign.
    wrong += [f"metadata.txt: {key} has a per cent sign." for key in found if "%" in found[key]]
    has = found.get("version", "")
    if version and has != version:
        wrong.append(f"metadata.txt has version {has}, not {version}.")
    newest = (releases(contents.get("semref/CHANGELOG.md", b"").decode("utf-8")) or [None])[0]
    if newest is None or (newest.version, bool(newest.date), bool(newest.news)) != (has, True, True):
        wrong.append(f"CHANGELOG.md does not begin with {has}, its date and its news.")
    cited = re.search(r"^version: (\S+)$", contents.get("semref/CITATION.cff", b"").decode("utf-8"), re.MULTILINE)
    if cited is None or cited[1] != has:
        wrong.append(f"CITATION.cff does not have version {has}.")
    if found.get("icon") and f"semref/{found['icon']}" not in contents:
        wrong.append(f"The icon {found['icon']} is missing.")
    return wrong


def main() -> None:
    package, version = Path(sys.argv[1]), (sys.argv[2:] or [""])[0]
    found = faults(package, version)
    for fault in found:
        print(fault, file=sys.stderr)
    if found:
        sys.exit(1)
    with zipfile.ZipFile(package) as archive:
        count = len(archive.namelist())
    print(f"{package}: {count} files, {package.stat().st_size / 1024**2:.1f} MB, no faults")


if __name__ == "__main__":
    main()
