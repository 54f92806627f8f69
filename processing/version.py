"""The plugin's version, which stands in metadata.txt and nowhere else."""

import configparser
from functools import lru_cache
from pathlib import Path

_METADATA = Path(__file__).resolve().parent.parent / "metadata.txt"


@lru_cache(maxsize=1)
def plugin_version() -> str:
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_METADATA, encoding="utf-8")
    return metadata.get("general", "version")
