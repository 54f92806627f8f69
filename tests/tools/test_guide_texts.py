import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "release"))
from update_translations import all_texts  # noqa: E402

PAGES = sorted([*(ROOT / "docs" / "tutorials").glob("*.md"), *(ROOT / "docs" / "how-to").glob("*.md")])
QUOTES = ROOT / "docs" / "how-to" / "no_position.md"
SEPARATOR = "▸"

LABELS_OF_QGIS = {
    "Add Directory", "Advanced", "Clip", "Copy as JSON", "Copy as Python Command", "Copy as qgis_process Command",
    "Data Management Tools", "Export", "Export Map to Image…", "Geoprocessing Tools", "History…", "Models",
    "Open Existing Model…", "Import/Export", "Install Plugin", "Install from ZIP", "Load default style",
    "Manage and Install Plugins…", "Merge Vector Layers", "Options…", "Panels", "Plugins", "Processing", "Project",
    "Raise exception",
    "Results Viewer", "Run", "Run as Batch Process…", "Save As…", "SemRef", "Settings", "Styles",
    "Temporal Controller", "Toolbox", "Vector", "View",
}  # fmt: skip
FEWEST_LETTERS = 6
"""A template with fewer letters would match almost everything."""


@pytest.fixture(scope="module")
def texts() -> set[str]:
    models = [path.read_text(encoding="utf-8") for path in (ROOT / "models").glob("*.model3")]
    labels = {label for text in models for label in re.findall(r'"description" type="QString" value="([^"]+)"', text)}
    return {*all_texts(), *labels}


@pytest.fixture(scope="module")
def templates(texts) -> list[re.Pattern]:
    """Return a regular expression for each text, with any values in its placeholders."""
    long = [text for text in texts if len(re.sub(r"\{[^}]*\}|\W", "", text)) >= FEWEST_LETTERS]
    parts = [re.split(r"\{[^}]*\}", text.removeprefix("{reason} ")) for text in long]
    return [re.compile(".+?".join(map(re.escape, part))) for part in parts]


def is_shown(sentence: str, templates: list[re.Pattern]) -> bool:
    return any(template.fullmatch(sentence) for template in templates)


def test_quoted_messages_are_messages_of_the_code(templates):
    lines = QUOTES.read_text(encoding="utf-8").splitlines()
    quoted = [line[2:] for line in lines if line.startswith("> ")]
    assert len(quoted) >= 7
    for sentence in quoted:
        parts = [sentence] if is_shown(sentence, templates) else sentence.rstrip(".").split("; ")
        # A part of a joined message begins with a lower-case letter.
        wrong = [part for part in parts if not is_shown(part, templates)]
        assert [part for part in wrong if not is_shown(part[0].lower() + part[1:], templates)] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_labels_in_italics_are_labels_of_the_screen(page, texts, templates):
    text = page.read_text(encoding="utf-8")
    body = re.sub(r"<!-- bench.*?/bench.*?-->|```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)
    named = re.findall(r"(?<![*\w])\*([^*\n]+)\*(?![*\w])", body)
    labels = {label.strip() for text in named for label in text.split(SEPARATOR) if label.strip()}
    short = {text.partition(" (")[0] for text in texts} | {text.partition(": ")[0] for text in texts}
    unknown = sorted(labels - texts - short - LABELS_OF_QGIS)
    assert [label for label in unknown if not is_shown(label.replace("…", "9"), templates)] == []
