"""Read the news of each version from CHANGELOG.md, for the plugin manager and the plugin repository."""

import re
from dataclasses import dataclass

_VERSION = re.compile(r"^## \[(?P<version>[^\]]+)\](?: – (?P<date>\d{4}-\d{2}-\d{2}))?\s*$", flags=re.MULTILINE)
NEWS = "### News"
SHOWN_VERSIONS = 3


@dataclass(frozen=True)
class Release:
    """A version of the changelog. ``date`` is empty before the release; ``news`` has a sentence or two per change."""

    version: str
    date: str
    news: tuple[str, ...]


def releases(changelog: str) -> list[Release]:
    """Return the versions, the newest first."""
    headings = list(_VERSION.finditer(changelog))
    ends = [heading.start() for heading in headings[1:]] + [len(changelog)]
    return [
        Release(heading["version"], heading["date"] or "", _news(changelog[heading.end() : end]))
        for heading, end in zip(headings, ends)
    ]


def _news(section: str) -> tuple[str, ...]:
    """Return the list below the heading "News" as plain text, without links and stars."""
    _, _, rest = section.partition(f"{NEWS}\n")
    text = re.split(r"^#", rest, maxsplit=1, flags=re.MULTILINE)[0]
    entries = re.split(r"^- ", text, flags=re.MULTILINE)[1:]
    return tuple(_plain(entry) for entry in entries)


def _plain(entry: str) -> str:
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", " ".join(entry.split()))
    return re.sub(r"[*`]", "", text)


def for_metadata(changelog: str) -> str:
    """Return the value of ``changelog`` in metadata.txt: the news of the newest versions."""
    shown = [release for release in releases(changelog) if release.news][:SHOWN_VERSIONS]
    lines = []
    for release in shown:
        lines.append(f"{release.version} ({release.date})" if release.date else release.version)
        lines += [f" - {entry}" for entry in release.news]
    return "\n ".join(lines)
