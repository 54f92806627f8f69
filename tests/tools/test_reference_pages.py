"""The generated reference pages have every message, command and setting; tests/qgis checks the algorithms."""

import re
import sys
from dataclasses import fields
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "docs"))

import example_calls  # noqa: E402
import list_algorithms  # noqa: E402
import list_commands  # noqa: E402
import list_messages  # noqa: E402
import list_settings  # noqa: E402
import reference_pages  # noqa: E402


def test_the_page_of_messages_has_every_message_and_notes_of_all_reasons():
    sentences = list_messages.sentences()
    page, notes = list_messages.page(sentences), set(list_messages.notes())
    assert [template for template in sentences if list_messages.shown(template) not in page] == []
    assert notes <= set(sentences) and list_messages.reasons() <= notes


def test_messages_of_an_unknown_folder_come_last_with_names_of_values_in_italics():
    page = list_messages.page({"Something new.": "novel/x.py", "{path} has {size_mb:.1f} MB.": "storage/x.py"})
    assert page.index(f"## {list_messages.OTHERS}") < page.index("- Something new.")
    assert "- *path* has *size mb* MB.\n" in page


def test_the_page_of_commands_has_every_option():
    page = list_commands.page()
    assert page.count("\n## semref ") == 3
    for option in ("--database", "--require-signature KEYFILE", "--near X Y RADIUS", "--mavlink WHERE"):
        assert f"| `{option}` |" in page
    assert "## Exit codes" in page


def test_the_page_of_settings_has_every_class_and_field():
    page, found = list_settings.page(), list_settings.classes()
    assert {"LocalizerSettings", "SearchLimits", "FlightSettings"} <= {one.__name__ for one in found}
    assert max(len(fields(one)) for one in found) <= 25
    for one in found:
        rows = list_settings.rows_of(one)
        assert [row[0].strip("`") for row in rows] == [field.name for field in fields(one)]
        assert [row for row in rows if f"| {' | '.join(row)} |" not in page] == []


def test_git_ignores_the_generated_pages():
    ignored = (ROOT / ".gitignore").read_text(encoding="utf-8").splitlines()
    assert {f"/docs/reference/{name}" for name in reference_pages.NAMES} <= set(ignored)


def test_links_of_the_generated_pages_lead_to_files():
    texts = [list_messages.page(), list_commands.page(), list_settings.page(), list_algorithms.HEAD]
    texts += example_calls.ELSEWHERE.values()
    targets = {target for text in texts for target in re.findall(r"\]\(([^)#\s]+)", text) if "://" not in target}
    generated = {reference_pages.FOLDER / name for name in reference_pages.NAMES}
    linked = {(reference_pages.FOLDER / target).resolve() for target in targets}
    assert [path for path in linked - generated if not path.is_file()] == []
