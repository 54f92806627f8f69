"""Version and web addresses from metadata.txt, and the addresses of help pages."""

import configparser
from functools import lru_cache
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent
PLACEHOLDER = "example.org"
"""Marks addresses in metadata.txt that the owner has not filled in yet; SemRef does not open them."""


@lru_cache(maxsize=1)
def _metadata() -> configparser.SectionProxy:
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_ROOT / "metadata.txt", encoding="utf-8")
    return metadata["general"]


def plugin_version() -> str:
    return _metadata()["version"]


def tracker_url() -> str:
    """Return the address for new issues; empty until the owner fills it in."""
    address = _metadata()["tracker"]
    return "" if PLACEHOLDER in address else address


def guide_url(page: str = "README.md", root: Path = _ROOT) -> str:
    """Return the address of a page of docs/: the page that ships with the plugin, the web page, or the Markdown file.

    Args:
        page: Path of the page in docs/; the default is the index.
    """
    built = _built("index" if page == "README.md" else page[: -len(".md")], root)
    homepage, text = _metadata()["homepage"], root / "docs" / page
    if built or (PLACEHOLDER in homepage and text.is_file()):
        return built or text.as_uri()
    return f"{homepage}/blob/main/docs/{page}"


def algorithm_help_url(name: str, root: Path = _ROOT) -> str:
    """Return the address of the algorithm's reference section; without built pages that of the index.

    Each algorithm has a page that leads to its section, because some programs that open files drop the part after #.
    """
    return _built(f"algorithms/{name}", root) or guide_url(root=root)


def _built(name: str, root: Path) -> str:
    """Return the address of a page that tools/docs/build_site.py built; empty if there is none, as in a clone."""
    page = root / "help" / f"{name}.html"
    return page.as_uri() if page.is_file() else ""
