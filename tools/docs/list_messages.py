"""The reference page of messages: every sentence that SemRef can show, and for many the reason and what to do.

The templates come from the source code. troubleshooting_notes.txt has what the page adds to them.
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

from update_translations import MAKERS, ROOMS, calls_in, name_of, templates_of  # noqa: E402

NOTES = Path(__file__).with_name("troubleshooting_notes.txt")

HEAD = Path(__file__).with_name("heads").joinpath("messages.md").read_text(encoding="utf-8")

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
"""Headings, and the folders of the messages below each; a message belongs to the first heading that fits."""

OTHERS = "Other messages"
"""Heading for messages of all other folders."""


class Note(NamedTuple):
    """The reason for a message, and what to do, in Markdown."""

    why: str
    do: str


def notes() -> dict[str, Note]:
    """Return the notes by template."""
    lines = [line for line in NOTES.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return {template: Note(why, do) for template, why, do in (line.split(" | ") for line in lines)}


def sentences() -> dict[str, str]:
    """Return the file of each message by template, a path from the root; of a plural only the form for many.

    Parts of sentences are left out unless they have a note.
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
    """Return the templates of the reasons why an image has no position, and of the limits of a position."""
    rooms = SECTIONS["An image has no position"]
    made = {template for maker, template, path in _made() if maker == "Sentence" and path.startswith(rooms)}
    return made & set(sentences())


def _made() -> Iterator[tuple[str, str, str]]:
    """Yield the class of each message, its template and its file."""
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*.py")):
            for call in calls_in(path.read_text(encoding="utf-8")):
                for template in _without_singular(call) if name_of(call.func) in MAKERS else ():
                    yield name_of(call.func), template, path.relative_to(ROOT).as_posix()


def _without_singular(call: ast.Call) -> list[str]:
    text = call.args[0] if call.args else None
    is_plural = isinstance(text, ast.IfExp) and "Constant(value=1" in ast.dump(text.test)
    return templates_of(call)[-1:] if is_plural else templates_of(call)


def page(templates: dict[str, str] | None = None) -> str:
    """Return the whole page.

    Args:
        templates: The file of each message by template; None for all of the source code.
    """
    left = sentences() if templates is None else dict(templates)
    parts, added = [HEAD], notes()
    for heading, rooms in {**SECTIONS, OTHERS: ("",)}.items():
        chosen = {template for template, path in left.items() if path.startswith(rooms)}
        left = {template: path for template, path in left.items() if template not in chosen}
        explained = [template for template in added if template in chosen]
        plain = sorted(map(shown, chosen.difference(explained)), key=str.lower)
        if chosen:
            parts.append(f"## {heading}\n")
        if explained:
            parts.append("| message | reason | what to do |\n|---|---|---|")
            parts += [f"| {shown(template)} | {' | '.join(map(_moved, added[template]))} |" for template in explained]
            parts.append("")
        if plain:
            parts += [*(f"- {text}" for text in plain), ""]
    return "\n".join(parts)


def shown(template: str) -> str:
    """Return a template with the names of its values in italics."""
    text = re.sub(r"\{(\w*)[^}]*\}", lambda found: f"*{found[1].replace('_', ' ') or 'value'}*", template)
    return text.replace("|", "\\|").replace("<", "&lt;")


def _moved(note: str) -> str:
    """Links of the notes start from docs/, those of the page from docs/reference/."""
    return re.sub(r"\]\((?!\w+:|#)", "](../", note)
