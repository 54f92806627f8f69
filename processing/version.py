"""What metadata.txt says and nothing else repeats – version, addresses on the web – and where the guide is."""

import configparser
from functools import lru_cache
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent
PLACEHOLDER = "example.org"
"""In addresses that an owner has not filled in yet: nobody is led there."""


@lru_cache(maxsize=1)
def _metadata() -> configparser.SectionProxy:
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_ROOT / "metadata.txt", encoding="utf-8")
    return metadata["general"]


def plugin_version() -> str:
    return _metadata()["version"]


def tracker_url() -> str:
    """Where issues are opened; empty while nobody has said where."""
    address = _metadata()["tracker"]
    return "" if PLACEHOLDER in address else address


def guide_url(page: str = "user_guide.md", root: Path = _ROOT) -> str:
    """Address of a page of docs/: in the plugin's folder where the pages come with it, else on the web, or its text."""
    made = _made("index" if page == "README.md" else page[: -len(".md")], root)
    homepage, text = _metadata()["homepage"], root / "docs" / page
    if made or (PLACEHOLDER in homepage and text.is_file()):
        return made or text.as_uri()
    return f"{homepage}/blob/main/docs/{page}"


def algorithm_help_url(name: str, root: Path = _ROOT) -> str:
    """Address of the algorithm's section in the guide; forges leave the colon out of a heading's anchor.

    Where the pages come with the plugin, each algorithm has one that leads to its section: programs that open files
    for others drop what stands behind a #.
    """
    return _made(f"algorithms/{name}", root) or f"{guide_url('how-to/toolbox.md', root)}#semref{name}"


def _made(name: str, root: Path) -> str:
    """Address of a page that was made of docs/ (tools/docs/build_site.py); empty where it was not, as in a clone."""
    page = root / "help" / f"{name}.html"
    return page.as_uri() if page.is_file() else ""
