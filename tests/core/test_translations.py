import re
import string
import sys
from pathlib import Path
from xml.etree import ElementTree

from source_trees import for_each

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools" / "release"))

import update_translations  # noqa: E402

FILES = sorted((ROOT / "i18n").glob("semref_*.ts"))
each_file = for_each(FILES)
TEXTS = update_translations.all_texts()


def placeholders(text: str) -> set[tuple[str, str]]:
    """Return placeholders with their format, such as ``{share:.1%}``, and numbers of a progress bar, such as ``%v``."""
    named = {(name, form) for _, name, form, _ in string.Formatter().parse(text) if name is not None}
    return named | {(number, "") for number in re.findall("%[vmp]", text)}


def pairs(path: Path) -> list[tuple[str, str]]:
    messages = ElementTree.parse(path).iter("message")
    return [(message.findtext("source", ""), message.findtext("translation", "")) for message in messages]


@each_file
def test_the_file_has_the_texts_of_the_code_once_each_and_no_others(path):
    assert [source for source, _ in pairs(path)] == TEXTS, "run tools/release/update_translations.py"


@each_file
def test_no_translation_is_unfinished(path):
    translated = update_translations.translations_in(path)
    assert [source for source, _ in pairs(path) if not translated.get(source, "").strip()] == []


@each_file
def test_placeholders_full_stops_and_paragraphs_are_those_of_the_source(path):
    assert [pair for pair in pairs(path) if placeholders(pair[0]) != placeholders(pair[1])] == []
    assert [pair for pair in pairs(path) if pair[0].endswith(".") != pair[1].endswith((".", "。"))] == []
    assert [pair for pair in pairs(path) if pair[0].count("\n") != pair[1].count("\n")] == []


@each_file
def test_names_that_a_text_cites_are_those_shown_elsewhere(path):
    translated = dict(pairs(path))
    cited = [(text, name) for text in translated for name in re.findall("“(.+?)”", text) if name in translated]
    assert cited
    assert [pair for pair in cited if translated[pair[1]] not in translated[pair[0]]] == []
