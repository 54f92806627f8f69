"""What metadata.txt says and nothing else repeats: the plugin's version and where it lives on the web."""

import configparser
from functools import lru_cache
from pathlib import Path

_METADATA = Path(__file__).resolve().parent.parent / "metadata.txt"


@lru_cache(maxsize=1)
def plugin_metadata() -> configparser.SectionProxy:
    """The section ``general``."""
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read(_METADATA, encoding="utf-8")
    return metadata["general"]
