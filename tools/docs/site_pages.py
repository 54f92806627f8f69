"""Prepares the Markdown of docs/ and of the repository's root for MkDocs."""

import os
import re
import shutil
from pathlib import Path

from list_algorithms import ids

ROOT = Path(__file__).resolve().parents[2]
SITE = Path(__file__).with_name("site")

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
    for name in ("hooks.py", "mkdocs.yml"):
        shutil.copy(SITE / name, work)


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
    return indented(text)


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
