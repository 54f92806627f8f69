"""Writes docs/troubleshooting.md: every sentence that SemRef may say, and for many why, and what to do.

    .venv/bin/python tools/docs/troubleshooting.py

The sentences come from the tables that the plugin says them from, so the page can't tell others; what is added to them
lies in troubleshooting_notes.txt.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "troubleshooting.md"
NOTES = Path(__file__).with_name("troubleshooting_notes.txt")

HEAD = """# Troubleshooting by message

*[User guide](user_guide.md) · troubleshooting · [questions](faq.md) · [words](glossary.md)*

Every error of SemRef is one sentence that says what is wrong and, mostly, what to do. Search this page for a few words;
where the sentence has a name or number, the page has *what it is* in italics. In other languages the same is said
in other words: the sections are in the order of the work. A message that is not here is
[a fault](user_guide.md#when-something-goes-wrong).

Written by `tools/docs/troubleshooting.py` from the sentences themselves.
"""

SECTIONS = {
    "An image has no position": ("localization",),
    "Flights and motion": ("flight",),
    "Python packages": ("packages",),
    "Label maps, classes, images": ("labels",),
    "Layers, reference systems, annotations": ("exchange", "algorithms", "framework", "geometry", "windows"),
    "Databases": ("database",),
    "Files": ("storage",),
    "Networks": ("segmentation", "training"),
    "What to expect of a database": ("assessment", "simulation"),
    "On board": ("onboard",),
}
"""Headings and the rooms of the codes below them."""

OTHERS = "Everything else"
"""Heading of rooms that no other one has."""

_NO_MESSAGE = re.compile(
    r"localization\.(status|method|cause|part_of|radius_of|searched|all_headings|headings_near|whole_map|ground_near"
    r"|shows_|more_needed|neither_road|(left|right|upper|lower)_part).*"
    r"|database\.setting_.*|.*\.(and_more|line|at_line|unknown_reason|unknown_format|the_database)"
)
"""Parts of sentences, and what is no complaint."""


class Note(NamedTuple):
    """Why a sentence is said, and what to do: Markdown."""

    why: str
    do: str


def notes() -> dict[str, Note]:
    """What is added to sentences, by code."""
    lines = [line for line in NOTES.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    return {code: Note(why, do) for code, why, do in (line.split(" | ") for line in lines)}


def sentences() -> dict[str, str]:
    """English templates by code, as algorithms and windows say them; of a plural the form for many.

    Behind the code stands the key of a parameter, where an algorithm that has it says the sentence otherwise.
    """
    sys.path.append(str(ROOT / "tools"))
    from plugin_package import load_plugin_package

    load_plugin_package()
    import semref.processing
    import semref.storage
    import semref.training  # noqa: F401  All three add their rooms' sentences.
    from semref.core.sentences.sentence import Plural, _templates
    from semref.processing.wording.keys import EVERYWHERE, SENTENCES_BY_KEY

    found = {
        code: template.other if isinstance(template, Plural) else template for code, template in _templates.items()
    }
    found["localization.too_few_landmarks"] = found["localization.too_few_landmarks"].format(
        shown=found["localization.shows_landmarks"], needed=found["localization.more_needed"]
    )
    for code, (key, template) in SENTENCES_BY_KEY.items():
        found[code if key == EVERYWHERE else f"{code} {key}"] = template
    return {code: template for code, template in found.items() if not _NO_MESSAGE.fullmatch(code)}


def page(templates: dict[str, str]) -> str:
    """The whole page."""
    parts, added = [HEAD], notes()
    named = {room for rooms in SECTIONS.values() for room in rooms}
    others = tuple(sorted({code.split(".")[0] for code in templates} - named))
    for heading, rooms in {**SECTIONS, OTHERS: others}.items():
        codes = [code for code in templates if code.split(".")[0] in rooms]
        explained = [code for code in codes if code in added]
        plain = sorted((code for code in codes if code not in added), key=lambda code: shown(templates[code]).lower())
        if codes:
            parts.append(f"## {heading}\n")
        if explained:
            parts.append("| message | why | what to do |\n|---|---|---|")
            parts += [_row(shown(templates[code]), *added[code]) for code in explained]
            parts.append("")
        if plain:
            parts.append("| message | what to do |\n|---|---|")
            parts += [_row(*_parted(shown(templates[code]))) for code in plain]
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
