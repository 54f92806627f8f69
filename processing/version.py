"""What metadata.txt says and nothing else repeats: the plugin's version and where it lives on the web."""

import configparser
from functools import lru_cache
from pathlib import Path

_METADATA = Path(__file__).resolve().parent.parent / "metadata.txt"


def plugin_version() -> str:
    return _general()["version"]


def user_guide_url() -> str:
    return f"{_general()['homepage']}/blob/main/docs/user_guide.md"


@lru_cache(maxsize=1)
def _general() -> configparser.SectionProxy:
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_METADATA, encoding="utf-8")
    return metadata["general"]
