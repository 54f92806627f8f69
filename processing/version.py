"""What metadata.txt says and nothing else repeats: the plugin's version and where it lives on the web."""

import configparser
from functools import lru_cache
from pathlib import Path

_METADATA = Path(__file__).resolve().parent.parent / "metadata.txt"


def plugin_version() -> str:
    return _general()["version"]


def guide_url(page: str = "user_guide.md") -> str:
    """Address of a page of docs/."""
    return f"{_general()['homepage']}/blob/main/docs/{page}"


def algorithm_help_url(name: str) -> str:
    """Address of the algorithm's section in the guide; forges leave the colon out of a heading's anchor."""
    return f"{guide_url('guide/toolbox.md')}#semref{name}"


@lru_cache(maxsize=1)
def _general() -> configparser.SectionProxy:
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_METADATA, encoding="utf-8")
    return metadata["general"]
