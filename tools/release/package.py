"""Build dist/semref-VERSION.zip, the file that users install: python tools/release/package.py [--output FILE].

check_zip.py checks it.
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from metadata import placeholders, plugin_version, shipped_metadata

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "docs"))

from build_site import is_up_to_date  # noqa: E402

SHIPPED_FILES = (
    *("metadata.txt", "LICENSE", "README.md", "CHANGELOG.md", "CITATION.cff"),
    *("__init__.py", "plugin.py", "program.py"),
)
HELP, SAMPLE = "help", "sample"
SHIPPED_FOLDERS = ("core", "storage", "cluster", "training", "processing", "ui", "resources", "models")
TIMESTAMP = (1980, 1, 1, 0, 0, 0)  # the zip format's first day: same content, same zip
LRELEASE_NAMES = ("lrelease", "lrelease-qt5", "/usr/lib/qt5/bin/lrelease", "/usr/lib/qt6/bin/lrelease")


def shipped_paths(root: Path = ROOT) -> list[Path]:
    """Return the sorted paths, relative to `root`, of the files that the zip contains unchanged."""
    paths = [Path(name) for name in SHIPPED_FILES if (root / name).is_file()]
    for folder in (*SHIPPED_FOLDERS, SAMPLE, *([HELP] if has_guide(root) else [])):
        paths += [path.relative_to(root) for path in (root / folder).rglob("*") if path.is_file()]
    return sorted(path for path in paths if not is_leftover(path))


def has_guide(root: Path) -> bool:
    """Return whether help/ was built from the current docs; otherwise print a warning."""
    if is_up_to_date(root / HELP, root):
        return True
    print("The zip has no help pages, because help/ is missing or old. Run tools/docs/build_site.py.", file=sys.stderr)
    return False


def is_leftover(path: Path) -> bool:
    return path.suffix == ".pyc" or any(part.startswith(".") or part == "__pycache__" for part in path.parts)


def compiled_translations(root: Path = ROOT) -> dict[Path, bytes]:
    """Return the .qm of every i18n/*.ts; print a warning and return nothing if Qt's lrelease is missing."""
    sources = sorted((root / "i18n").glob("*.ts"))
    if not sources:
        return {}
    lrelease = next(filter(None, map(shutil.which, LRELEASE_NAMES)), None)
    if lrelease is None:
        print("The zip has no translations: lrelease (Debian: qttools5-dev-tools) is missing.", file=sys.stderr)
        return {}
    translations = {}
    with tempfile.TemporaryDirectory() as folder:
        for source in sources:
            target = Path(folder) / f"{source.stem}.qm"
            subprocess.run([lrelease, "-silent", str(source), "-qm", str(target)], check=True)
            translations[Path("i18n") / target.name] = target.read_bytes()
    return translations


def write_package(target: Path, root: Path = ROOT) -> None:
    contents = {path: (root / path).read_bytes() for path in shipped_paths(root)}
    contents[Path("metadata.txt")] = shipped_metadata(root).encode("utf-8")
    contents.update(compiled_translations(root))
    target.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as package:
        for path in sorted(contents):
            entry = zipfile.ZipInfo(f"semref/{path.as_posix()}", TIMESTAMP)
            entry.external_attr = 0o100644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            package.writestr(entry, contents[path])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=ROOT / "dist" / f"semref-{plugin_version()}.zip")
    target = parser.parse_args().output
    subprocess.run([sys.executable, "-m", "tools.sample"], cwd=ROOT, check=True)
    write_package(target)
    print(f"{target} ({target.stat().st_size / 1024:.0f} kB)")
    left = placeholders(*((ROOT / name).read_text(encoding="utf-8") for name in ("metadata.txt", "SECURITY.md")))
    if left:
        print(f"Fill in before publishing: {', '.join(left)} (docs/publishing.md)", file=sys.stderr)


if __name__ == "__main__":
    main()
