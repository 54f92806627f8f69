"""metadata.txt as it ships: with what is new in it, and with the translations under every name that QGIS asks for."""

from __future__ import annotations

import configparser
import re
from pathlib import Path

from changelog import for_metadata

ROOT = Path(__file__).resolve().parents[2]
PLACEHOLDER = "example.org"
ADDRESSES = ("email", "homepage", "repository", "tracker")
SAME_LANGUAGE = {"zh": ("zh-Hans", "zh_CN")}
"""QGIS asks for the language as its settings name it, and then for what stands before an underscore."""


def general(text: str) -> configparser.SectionProxy:
    """The section [general], read as QGIS reads it."""
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read_string(text)
    return metadata["general"]


def plugin_version(root: Path = ROOT) -> str:
    """The version in metadata.txt, the only place that has it."""
    return general((root / "metadata.txt").read_text(encoding="utf-8"))["version"]


def placeholders(text: str) -> list[str]:
    """Addresses that an owner has not filled in yet, as ``key=value``."""
    found = general(text)
    told = {key: found.get(key, PLACEHOLDER) for key in ADDRESSES}
    return [f"{key}={address}" for key, address in told.items() if PLACEHOLDER in address]


def shipped_metadata(root: Path = ROOT) -> str:
    """metadata.txt of the zip; ``changelog`` is made here and stands nowhere else, so it can't say anything else."""
    text = (root / "metadata.txt").read_text(encoding="utf-8").rstrip("\n")
    lines = []
    for line in text.splitlines():
        lines.append(line)
        found = re.match(r"(\w+)\[(\w+)\]=(.*)", line)
        if found:
            key, language, value = found.groups()
            lines += [f"{key}[{other}]={value}" for other in SAME_LANGUAGE.get(language, ())]
    lines.append(f"changelog={for_metadata((root / 'CHANGELOG.md').read_text(encoding='utf-8'))}")
    return "\n".join(lines) + "\n"
