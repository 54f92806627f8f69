"""Writes docs/troubleshooting.md: every sentence that SemRef may say, and for many why, and what to do.

    .venv/bin/python tools/docs/troubleshooting.py

The templates come from the source, from where the sentences are made; what is added to them is in
troubleshooting_notes.txt.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "release"))

from update_translations import MAKERS, ROOMS, name_of, templates_of  # noqa: E402

PAGE = ROOT / "docs" / "troubleshooting.md"
NOTES = Path(__file__).with_name("troubleshooting_notes.txt")

HEAD = """# Troubleshooting by message

*[User guide](user_guide.md) · troubleshooting · [questions](how-to/no_position.md) · [words](reference/glossary.md)*

Every error of SemRef is one sentence that says what is wrong and, mostly, what to do. Search this page for a few words;
where the sentence has a name or number, the page has *what it is* in italics. In other languages the same is said
in other words: the sections are in the order of the work. A message that is not here is
[a fault](user_guide.md#when-something-goes-wrong).

Written by `tools/docs/troubleshooting.py` from the sentences themselves.
"""

SECTIONS = {
    "An image has no position": ("core/constellation", "core/correlation", "core/localization", "core/localizer"),
    "Flights and motion": ("core/flight",),
    "Python packages": ("processing/packages",),
    "Label maps, classes, images": ("core/labels", "core/annotation"),
    "Layers, reference systems, annotations": ("processing", "core/geometry", "core/windows"),
    "Databases": ("core/database",),
    "Files": ("storage",),
    "Networks": ("core/segmentation", "training"),
    "What to expect of a database": ("core/assessment", "core/evaluation", "core/simulation"),
    "On board": ("core/onboard",),
}
"""Headings, and where the sentences below them are made; the first room that has a sentence counts."""

OTHERS = "Everything else"
"""Heading of all other rooms."""


class Note(NamedTuple):
    """Why a sentence is said, and what to do: Markdown."""

    why: str
    do: str


def notes() -> dict[str, Note]:
    """What is added to sentences, by template."""
    lines = [line for line in NOTES.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return {template: Note(why, do) for template, why, do in (line.split(" | ") for line in lines)}


def sentences() -> dict[str, str]:
    """Where each sentence is made, by template: a path from the root; of a plural the form for many.

    Parts of sentences are left out where there is no note on them.
    """
    found: dict[str, str] = {}
    added = notes()
    for maker, template, path in _made():
        words = re.sub(r"\{[^}]*\}", "", template)
        is_whole = maker != "Sentence" or words.endswith(".")
        if template in added or is_whole and re.search(r"[a-z]", words):
            found.setdefault(template, path)
    return found


def reasons() -> set[str]:
    """Templates of why an image has no position, or of what its fix does not hold for."""
    rooms = SECTIONS["An image has no position"]
    made = {template for maker, template, path in _made() if maker == "Sentence" and path.startswith(rooms)}
    return made & set(sentences())


def _made() -> Iterator[tuple[str, str, str]]:
    """What makes each sentence, its template and its file."""
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Call) and name_of(node.func) in MAKERS:
                    for template in _without_singular(node):
                        yield name_of(node.func), template, path.relative_to(ROOT).as_posix()


def _without_singular(call: ast.Call) -> list[str]:
    said = call.args[0] if call.args else None
    is_plural = isinstance(said, ast.IfExp) and "Constant(value=1" in ast.dump(said.test)
    return templates_of(call)[-1:] if is_plural else templates_of(call)


def page(templates: dict[str, str]) -> str:
    """The whole page, of sentences with where they are made."""
    parts, added = [HEAD], notes()
    left = dict(templates)
    for heading, rooms in {**SECTIONS, OTHERS: ("",)}.items():
        chosen = [template for template, path in left.items() if path.startswith(rooms)]
        left = {template: path for template, path in left.items() if template not in chosen}
        explained = [template for template in added if template in chosen]
        plain = sorted((template for template in chosen if template not in added), key=lambda t: shown(t).lower())
        if chosen:
            parts.append(f"## {heading}\n")
        if explained:
            parts.append("| message | why | what to do |\n|---|---|---|")
            parts += [_row(shown(template), *added[template]) for template in explained]
            parts.append("")
        if plain:
            parts.append("| message | what to do |\n|---|---|")
            parts += [_row(*_parted(shown(template))) for template in plain]
            parts.append("")
    return "\n".join(parts)


def shown(template: str) -> str:
    """A template as a reader sees it: values by their names, in italics."""
    text = re.sub(r"\{(\w*)[^}]*\}", lambda found: f"*{found[1].replace('_', ' ') or 'value'}*", template)
    return text.replace("|", "\\|").replace("<", "&lt;")


def _parted(text: str) -> tuple[str, str]:
    """What is wrong, and what to do: mostly there is a semicolon between them."""
    wrong, _, do = text.partition("; ")
    return (f"{wrong}.", do[:1].upper() + do[1:]) if do else (text, "")


def _row(*cells: str) -> str:
    return f"| {' | '.join(cells)} |"


def main() -> None:
    PAGE.write_text(page(sentences()), encoding="utf-8")
    print(PAGE)


if __name__ == "__main__":
    main()
