"""What the site is made of: the Markdown of docs/ and of the repository's root, in the order of its menu."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SITE = Path(__file__).with_name("site")

MENU: dict[str, tuple[tuple[str, str], ...]] = {
    "Start": (
        ("What do you want to do?", "README.md"),
        ("The first fix", "tutorials/first_fix.md"),
        ("User guide", "user_guide.md"),
        ("What works, what not", "explanation/what_to_expect.md"),
    ),
    "Guide": (
        ("Your own area", "guide/own_area.md"),
        ("Your own photos", "tutorials/own_area_and_photos.md"),
        ("Your own network", "how-to/train_a_network.md"),
        ("Correct a map", "how-to/correct_a_layer.md"),
        ("A round trip", "how-to/build_and_update.md"),
        ("Plan a flight", "how-to/where_it_works.md"),
        ("Flights", "tutorials/first_flight.md"),
        ("On board", "how-to/on_board.md"),
        ("For toolbox users", "how-to/toolbox.md"),
        ("On many cores or machines", "how-to/many_machines.md"),
        ("Without a network", "how-to/offline.md"),
    ),
    "Look up": (
        ("Troubleshooting", "troubleshooting.md"),
        ("Questions", "how-to/no_position.md"),
        ("Words", "reference/glossary.md"),
        ("Models", "reference/networks.md"),
        ("Training", "training.md"),
        ("File formats", "reference/file_formats.md"),
        ("Changes", "CHANGELOG.md"),
        ("Licenses of others", "reference/third_party.md"),
    ),
    "How well, and why": (
        ("Methods", "explanation/method.md"),
        ("Benchmarks", "benchmarks.md"),
        ("Countries and continents", "explanation/scale.md"),
        ("The published method", "explanation/published_method.md"),
        ("Reliability", "reliability.md"),
        ("Calibration", "calibration.md"),
        ("Security", "SECURITY.md"),
    ),
    "For developers": (
        ("Contributing", "CONTRIBUTING.md"),
        ("Architecture", "architecture.md"),
        ("Development", "development.md"),
        ("Publishing", "publishing.md"),
        ("Decisions", "decisions/README.md"),
        ("Code of conduct", "CODE_OF_CONDUCT.md"),
    ),
}
"""Titles and pages, paths within docs/ or names in the repository's root."""

OF_THE_ROOT = ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md")
STANDS_FOR = {"README.md": "docs/README.md", "CITATION.cff": "docs/README.md"}
"""Files of the root that have no page, and the page that a link to them leads to."""

_LINK = re.compile(r"(?P<picture>!?)\[(?P<text>(?:[^\[\]]|\[[^\]]*\]\([^)]*\))*)\]\((?P<target>[^)\s]+)\)")
_ITEM = re.compile(r"(?:\d+\. |[-*] )")


def stage(root: Path, work: Path) -> None:
    """Puts mkdocs.yml and all pages with their pictures, as MkDocs wants them, into a folder."""
    places = page_places(root)
    for path, place in places.items():
        target = work / "docs" / place
        target.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix == ".md":
            target.write_text(staged(path, root, places), encoding="utf-8")
        else:
            shutil.copy(path, target)
    for name, folder in (("extra.css", "stylesheets"), ("iframe-worker.js", "javascripts")):
        (work / "docs" / folder).mkdir()
        shutil.copy(SITE / name, work / "docs" / folder)
    settings = (SITE / "mkdocs.yml").read_text(encoding="utf-8")
    (work / "mkdocs.yml").write_text(settings.replace("nav: []", navigation(root)), encoding="utf-8")


def page_places(root: Path) -> dict[Path, str]:
    """Where in the site each page and picture lies, by its path in the repository."""
    docs = root / "docs"
    found = {path: path.relative_to(docs).as_posix() for path in docs.rglob("*") if path.is_file()}
    found.update({root / name: name for name in OF_THE_ROOT})
    return found


def staged(path: Path, root: Path, places: dict[Path, str]) -> str:
    """A page with links that lead within the site; where there is no page, the text alone stays."""

    def link(found: re.Match) -> str:
        target, _, anchor = found["target"].partition("#")
        text = _LINK.sub(link, found["text"])
        if "://" in target or target.startswith("mailto:") or not target:
            return f"{found['picture']}[{text}]({found['target']})"
        linked = (path.parent / target).resolve()
        linked = root / STANDS_FOR.get(linked.relative_to(root).as_posix(), linked.relative_to(root).as_posix())
        if linked not in places:
            return text if text.startswith("`") else f"{text} (`{linked.relative_to(root).as_posix()}`)"
        here = os.path.dirname(places[path])
        there = os.path.relpath(places[linked], here or ".").replace(os.sep, "/")
        return f"{found['picture']}[{text}]({there}{'#' + anchor if anchor else ''})"

    parts = re.split(r"(^```.*?^```)", path.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    text = "".join(part if part.startswith("```") else _LINK.sub(link, part) for part in parts)
    return f"---\nsearch:\n  boost: {boost(places[path])}\n---\n\n{indented(text)}"


def boost(place: str) -> float:
    """How much more a page counts in the search than its words say: who asks wants to do something, mostly."""
    guide = {page for section in ("Start", "Guide") for _, page in MENU[section]}
    look_up = {page for _, page in MENU["Look up"]}
    return 4 if place in guide else 1.5 if place in look_up else 0.5


def indented(text: str) -> str:
    """What belongs to a list's entry, four spaces in: forges want it below the entry's text, MkDocs wants four."""
    lines, width, blank = [], 0, True
    for line in text.split("\n"):
        item = _ITEM.match(line)
        if item:
            width = item.end()
        elif width and line.startswith(" " * width):
            line = " " * 4 + line[width:]
        elif line and blank:
            width = 0
        blank = not line
        lines.append(line)
    return "\n".join(lines)


def add_algorithm_pages(root: Path, site: Path) -> None:
    """A page for each algorithm's Help that leads to its section at once."""
    folder = site / "algorithms"
    folder.mkdir()
    text = (root / "docs" / "how-to" / "toolbox.md").read_text(encoding="utf-8")
    for name in re.findall(r"^#### semref:(\w+)$", text, flags=re.MULTILINE):
        target = f"../how-to/toolbox.html#semref{name}"
        leads = f'<meta charset="utf-8"><meta http-equiv="refresh" content="0; url={target}">'
        page = f'<!doctype html><html lang="en"><head>{leads}<title>semref:{name}</title></head>'
        (folder / f"{name}.html").write_text(f'{page}<body><a href="{target}">{name}</a></body></html>\n', "utf-8")


def navigation(root: Path) -> str:
    """The menu as YAML; pages that it does not name come below the last heading, so that none is lost."""
    lines = ["nav:"]
    for section, entries in MENU.items():
        lines.append(f"  - {section}:")
        lines += [f'      - "{title}": {page}' for title, page in entries]
    named = {page for entries in MENU.values() for _, page in entries}
    others = sorted({page for page in page_places(root).values() if page.endswith(".md")} - named)
    lines += [f"      - {page}" for page in others]
    return "\n".join(lines)
