"""Build the shipped metadata.txt: with the news, and with the translations under all names that QGIS uses."""

import configparser
import re
from pathlib import Path

from changelog import for_metadata

ROOT = Path(__file__).resolve().parents[2]
PLACEHOLDER = "example.org"
ADDRESSES = ("email", "homepage", "repository", "tracker")
CONTACTS = ("SECURITY-ADDRESS", "SECURITY-KEY")
"""Placeholders in SECURITY.md."""

SAME_LANGUAGE = {"zh": ("zh-Hans", "zh_CN")}
"""QGIS looks up the language by the name in its settings, then by the part before an underscore."""


def general(text: str) -> configparser.SectionProxy:
    """Return the section [general], read in the same way as in QGIS."""
    metadata = configparser.ConfigParser(interpolation=None)
    metadata.read_string(text)
    return metadata["general"]


def plugin_version(root: Path = ROOT) -> str:
    """Return the version in metadata.txt."""
    return general((root / "metadata.txt").read_text(encoding="utf-8"))["version"]


def placeholders(text: str, security: str) -> list[str]:
    """Return what the owner has not filled in yet in metadata.txt, as ``key=value``, and in SECURITY.md."""
    found = general(text)
    addresses = {key: found.get(key, PLACEHOLDER) for key in ADDRESSES}
    left = [f"{key}={address}" for key, address in addresses.items() if PLACEHOLDER in address]
    return left + [contact for contact in CONTACTS if contact in security]


def shipped_metadata(root: Path = ROOT) -> str:
    """Return metadata.txt for the zip. Its ``changelog`` is built here from CHANGELOG.md."""
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
