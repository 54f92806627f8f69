"""Build HTML pages from the Markdown in docs/, which a browser can read without a network:

    .venv/bin/python tools/docs/build_site.py          # into help/, for Help and for packaging

The first run installs tools/docs/requirements.txt into .venv-docs, which needs a network. Later runs do not.
"""

import argparse
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from reference_pages import FOLDER, NAMES
from site_pages import ROOT, add_algorithm_pages, stage

REQUIREMENTS = Path(__file__).with_name("requirements.txt")
STATE = ".source"
"""File in the site's folder with the hash of the sources. It is hidden, so packaging leaves it out."""

NOT_NEEDED = ("assets/javascripts/lunr", "404.html", "sitemap.xml", "sitemap.xml.gz", "search/search_index.json")
_FROM_THE_WEB = re.compile(r"""(?:src|<link[^>]+href)=["']?(?:https?:)?//[^"'\s>]+""")


def source_state(root: Path = ROOT) -> str:
    """Return a hash of all sources of the site, except the generated reference pages."""
    generated = {root / FOLDER.relative_to(ROOT) / name for name in NAMES}
    files = [path for path in sorted((root / "docs").rglob("*")) if path.is_file() and path not in generated]
    files += [*sorted(root.glob("*.md")), *sorted((root / "tools" / "docs" / "site").iterdir())]
    files += sorted((root / "tools" / "docs").glob("*site*.py"))
    found = hashlib.sha256()
    for path in files:
        found.update(f"{path.relative_to(root).as_posix()} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return found.hexdigest()


def is_up_to_date(site: Path, root: Path = ROOT) -> bool:
    """Return whether the site was built from the current docs."""
    state = site / STATE
    return state.is_file() and state.read_text(encoding="ascii") == source_state(root)


def ready_environment(folder: Path) -> Path:
    """Create or update the environment, and return its Python."""
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    state, wanted = folder / "state", hashlib.sha256(REQUIREMENTS.read_bytes()).hexdigest()
    if not state.is_file() or state.read_text(encoding="ascii") != wanted:
        print(f"Creating {folder}", flush=True)
        shutil.rmtree(folder, ignore_errors=True)
        subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
        install = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-input"]
        subprocess.run([*install, "--requirement", str(REQUIREMENTS)], check=True, stdin=subprocess.DEVNULL)
        state.write_text(wanted, encoding="ascii")
    return python


def build(target: Path, environment: Path, root: Path = ROOT) -> None:
    """Build the site in a temporary folder and move it to the target; exit at a broken link or anchor."""
    python = ready_environment(environment)
    with tempfile.TemporaryDirectory(prefix="semref-site-") as temporary:
        work = Path(temporary)
        write_reference(root)
        stage(root, work)
        command = [str(python), "-m", "mkdocs", "build", "--quiet", "--config-file", str(work / "mkdocs.yml")]
        # The same sources give the same pages.
        variables = {**os.environ, "SOURCE_DATE_EPOCH": "315532800", "NO_MKDOCS_2_WARNING": "1"}
        if subprocess.run([*command, "--site-dir", str(work / "site")], env=variables, check=False).returncode:
            sys.exit("The site was not built. See the messages above.")
        strip(work / "site")
        add_algorithm_pages(root, work / "site")
        (work / "site" / STATE).write_text(source_state(root), encoding="ascii")
        shutil.rmtree(target, ignore_errors=True)
        shutil.copytree(work / "site", target)


def write_reference(root: Path) -> None:
    """Write the generated reference pages; end the program if that is not possible, as without QGIS."""
    command = [sys.executable, str(root / "tools" / "docs" / "reference_pages.py")]
    if subprocess.run(command, check=False, stdout=subprocess.DEVNULL).returncode:
        sys.exit("The reference pages were not written. They need the Python of QGIS: run tools/setup.sh first.")


def strip(site: Path) -> None:
    """Remove files that are not needed without a server; exit if a page would load something from the web."""
    for name in NOT_NEEDED:
        path = site / name
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)
    for path in site.rglob("*.map"):
        path.unlink()
    asks = {path.name: found for path in site.rglob("*.html") if (found := asked_of_the_web(path))}
    if asks:
        sys.exit(f"Pages load files from the web: {asks}")


def asked_of_the_web(page: Path) -> list[str]:
    """Return the tags with which a browser would load files of other hosts for this page, without links to click."""
    return _FROM_THE_WEB.findall(page.read_text(encoding="utf-8"))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=ROOT / "help")
    parser.add_argument("--environment", type=Path, default=ROOT / ".venv-docs")
    arguments = parser.parse_args()
    build(arguments.output, arguments.environment.absolute())
    pages = list(arguments.output.rglob("*.html"))
    size = sum(path.stat().st_size for path in arguments.output.rglob("*") if path.is_file())
    print(f"{arguments.output}: {len(pages)} pages, {size / 1024**2:.1f} MB")


if __name__ == "__main__":
    main()
