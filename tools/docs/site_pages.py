"""Prepares the Markdown of docs/ and of the repository's root for MkDocs, in the order of the menu."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from list_algorithms import ids

ROOT = Path(__file__).resolve().parents[2]
SITE = Path(__file__).with_name("site")

MENU: dict[str, tuple[tuple[str, str], ...]] = {
    "Tutorials": (
        ("What do you want to do?", "README.md"),
        ("First fix", "tutorials/first_fix.md"),
        ("Your own area and photos", "tutorials/own_area_and_photos.md"),
        ("First flight", "tutorials/first_flight.md"),
    ),
    "How-to": (
        ("Check and correct a layer", "how-to/correct_a_layer.md"),
        ("Build and update a database", "how-to/build_and_update.md"),
        ("Find out where it will work", "how-to/where_it_works.md"),
        ("Train a network", "how-to/train_a_network.md"),
        ("Run on board", "how-to/on_board.md"),
        ("Use toolbox, terminal and Python", "how-to/toolbox.md"),
        ("Use many machines", "how-to/many_machines.md"),
        ("Install offline", "how-to/offline.md"),
        ("Solve “No position”", "how-to/no_position.md"),
    ),
    "Reference": (
        ("Algorithms", "reference/algorithms.md"),
        ("Messages", "reference/messages.md"),
        ("Command line", "reference/command_line.md"),
        ("Solver settings", "reference/settings.md"),
        ("File formats", "reference/file_formats.md"),
        ("Networks", "reference/networks.md"),
        ("Glossary", "reference/glossary.md"),
        ("Third-party licenses", "reference/third_party.md"),
        ("Security", "SECURITY.md"),
        ("Changes", "CHANGELOG.md"),
    ),
    "Explanation": (
        ("What to expect", "explanation/what_to_expect.md"),
        ("Method", "explanation/method.md"),
        ("Published method", "explanation/published_method.md"),
        ("Scale", "explanation/scale.md"),
        ("Benchmarks", "benchmarks.md"),
    ),
    "Contributors": (
        ("Contributing", "CONTRIBUTING.md"),
        ("Architecture", "architecture.md"),
        ("Development", "development.md"),
        ("Publishing", "publishing.md"),
        ("Decisions", "decisions/README.md"),
        ("Code of conduct", "CODE_OF_CONDUCT.md"),
    ),
}
"""Titles and pages by section; pages are paths in docs/ or names in the repository's root."""

OF_THE_ROOT = ("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md")
REPLACED = {"README.md": "docs/README.md", "CITATION.cff": "docs/README.md"}
"""Files of the root that have no page, and the page that links to them open instead."""

_LINK = re.compile(r"(?P<picture>!?)\[(?P<text>(?:[^\[\]]|\[[^\]]*\]\([^)]*\))*)\]\((?P<target>[^)\s]+)\)")
_ITEM = re.compile(r"(?:\d+\. |[-*] )")


def stage(root: Path, work: Path) -> None:
    """Write mkdocs.yml and all pages with their pictures into a folder."""
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
    shutil.copy(SITE / "formulas.py", work)
    settings = (SITE / "mkdocs.yml").read_text(encoding="utf-8")
    (work / "mkdocs.yml").write_text(settings.replace("nav: []", navigation(root)), encoding="utf-8")


def page_places(root: Path) -> dict[Path, str]:
    """Return the place in the site of each page and picture, by its path in the repository."""
    docs = root / "docs"
    found = {path: path.relative_to(docs).as_posix() for path in docs.rglob("*") if path.is_file()}
    found.update({root / name: name for name in OF_THE_ROOT})
    return found


def staged(path: Path, root: Path, places: dict[Path, str]) -> str:
    """Return a page with links to pages of the site; a link to any other file becomes its name."""

    def link(found: re.Match) -> str:
        target, _, anchor = found["target"].partition("#")
        text = _LINK.sub(link, found["text"])
        if "://" in target or target.startswith("mailto:") or not target:
            return f"{found['picture']}[{text}]({found['target']})"
        linked = (path.parent / target).resolve()
        linked = root / REPLACED.get(linked.relative_to(root).as_posix(), linked.relative_to(root).as_posix())
        if linked not in places:
            return text if text.startswith("`") else f"{text} (`{linked.relative_to(root).as_posix()}`)"
        here = os.path.dirname(places[path])
        there = os.path.relpath(places[linked], here or ".").replace(os.sep, "/")
        return f"{found['picture']}[{text}]({there}{'#' + anchor if anchor else ''})"

    parts = re.split(r"(^```.*?^```)", path.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    text = "".join(part if part.startswith("```") else _LINK.sub(link, part) for part in parts)
    return f"---\nsearch:\n  boost: {boost(places[path])}\n---\n\n{indented(text)}"


def boost(place: str) -> float:
    """Return the weight of a page in the search. Pages for users come before those for contributors."""
    weights = {"Tutorials": 4, "How-to": 4, "Reference": 1.5}
    return next((weights.get(section, 0.5) for section, pages in MENU.items() if place in dict(pages).values()), 0.5)


def indented(text: str) -> str:
    """Indent the paragraphs of list items by four spaces for MkDocs; forges align them with the item's text."""
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
    """Write a page for each algorithm that opens its section; Help opens these pages."""
    folder = site / "algorithms"
    folder.mkdir()
    text = (root / "docs" / "reference" / "algorithms.md").read_text(encoding="utf-8")
    for algorithm in ids(text):
        name = algorithm.partition(":")[2]
        target = f"../reference/algorithms.html#semref{name}"
        leads = f'<meta charset="utf-8"><meta http-equiv="refresh" content="0; url={target}">'
        page = f'<!doctype html><html lang="en"><head>{leads}<title>{algorithm}</title></head>'
        (folder / f"{name}.html").write_text(f'{page}<body><a href="{target}">{name}</a></body></html>\n', "utf-8")


def navigation(root: Path) -> str:
    """Return the menu as YAML, with pages that it does not name at the end."""
    lines = ["nav:"]
    for section, entries in MENU.items():
        lines.append(f"  - {section}:")
        lines += [f'      - "{title}": {page}' for title, page in entries]
    named = {page for entries in MENU.values() for _, page in entries}
    others = sorted({page for page in page_places(root).values() if page.endswith(".md")} - named)
    lines += ['      - "All decisions":', *(f"          - {page}" for page in others)]
    return "\n".join(lines)
