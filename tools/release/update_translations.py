"""Update i18n/*.ts from the texts in the code: ``python tools/release/update_translations.py``.

Qt's pylupdate gives each text the context of its class; SemRef has one context for all texts. The script keeps
translations, removes old texts, and marks new texts as unfinished. Packaging compiles the files to .qm.
"""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parents[2]
CONTEXT = "SemRef"
ROOMS = ("core", "storage", "cluster", "training", "processing", "ui")
STYLE_TITLES = {"alias": "name", "attributeEditorContainer": "name", "category": "label", "rule": "label"}


def name_of(function: ast.expr) -> str:
    """Return the name of a called function."""
    return getattr(function, "id", getattr(function, "attr", ""))


def makers() -> frozenset[str]:
    """Return the names of the classes with a template: ``Sentence``, ``SemRefError`` and its subclasses."""
    found, before = {"Sentence", "SemRefError"}, set()
    trees = [ast.parse(path.read_text(encoding="utf-8")) for room in ROOMS for path in (ROOT / room).rglob("*.py")]
    classes = [node for tree in trees for node in tree.body if isinstance(node, ast.ClassDef)]
    while before != found:
        before = set(found)
        found |= {made.name for made in classes if any(name_of(base) in found for base in made.bases)}
    return frozenset(found)


MAKERS = makers()
DECLARED = ("QgsProcessingParameter", "QgsProcessingOutput", "RouteParameter", "with_help")
HELPED = ("risk_parameter", "footprints_parameter")
"""Functions that pass a help to ``with_help``, like all of ``parameters``."""


def literals(node: ast.expr) -> list[str]:
    """Return a text literal, both of ``"…" if … else "…"``, or an empty list for a variable."""
    if isinstance(node, ast.IfExp):
        return literals(node.body) + literals(node.orelse)
    return [node.value] if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value else []


def templates_of(call: ast.Call) -> list[str]:
    """Return the template literals of a call."""
    return literals(call.args[0]) if call.args else []


def calls_in(source: str) -> Iterator[ast.Call]:
    """Yield all calls of a source text."""
    return (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call))


def texts_of_call(call: ast.Call) -> list[str]:
    """Return the literals of ``tr("…")``, of a sentence or an error, and titles and helps of parameters."""
    name, owner = name_of(call.func), name_of(getattr(call.func, "value", call.func))
    if name.startswith(DECLARED) and len(call.args) > 1:
        return literals(call.args[1])
    is_tr = name == "tr" and len(call.args) == 1
    return templates_of(call) if is_tr or name in MAKERS or name in HELPED or owner == "parameters" else []


def texts_of(source: str) -> list[str]:
    """Return all texts of a module: those of calls, steps (``yield "text", share``), and TITLE and SUMMARY."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            found += texts_of_call(node)
        elif isinstance(node, ast.Yield) and isinstance(node.value, ast.Tuple):
            found += literals(node.value.elts[0])
        elif isinstance(node, ast.Assign) and name_of(node.targets[0]) in ("TITLE", "SUMMARY"):
            found += literals(node.value)
    return [text for text in found if not re.fullmatch(r"\{\w+\}", text)]


def style_texts(source: str) -> list[str]:
    """Return the texts of a style file that ``processing/layers/styles.py`` translates."""
    root = ElementTree.fromstring(source)
    found = [element.get(name, "") for tag, name in STYLE_TITLES.items() for element in root.iter(tag)]
    expressions = root.findtext("previewExpression", "") + root.findtext("mapTip", "")
    return found + re.findall(r"_\('([^']+)'\)", expressions)


def model_texts(source: str) -> list[str]:
    """Return the texts of a model file that ``processing/base/shipped_models.py`` translates."""
    options = list(ElementTree.fromstring(source).iter("Option"))
    helps = next(option for option in options if option.get("name") == "help" and len(option))
    titles = (option for option in options if option.get("name") == "description")
    return [option.get("value", "") for option in (*helps, *titles) if option.get("name") != "ALG_VERSION"]


def all_texts() -> list[str]:
    """Return all texts that a user can read, sorted, without repetition."""
    found = []
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*.py")):
            found += texts_of(path.read_text(encoding="utf-8"))
    for path in sorted((ROOT / "resources" / "styles").glob("*.qml")):
        found += style_texts(path.read_text(encoding="utf-8"))
    for path in sorted((ROOT / "models").glob("*.model3")):
        found += model_texts(path.read_text(encoding="utf-8"))
    return sorted(set(found))


def translations_in(path: Path) -> dict[str, str]:
    """Return the finished translations by source text."""
    if not path.exists():
        return {}
    known = {}
    for message in ElementTree.parse(path).iter("message"):
        translation = message.find("translation")
        if translation is not None and translation.text and translation.get("type") != "unfinished":
            known[message.findtext("source", "")] = translation.text
    return known


def write(path: Path, texts: list[str], known: dict[str, str]) -> int:
    """Write the .ts file and return the number of texts without a translation."""
    language = path.stem.split("_", 1)[1]
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    for text in texts:
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        if text in known:
            translation.text = known[text]
        else:
            translation.set("type", "unfinished")
    ElementTree.indent(root, " ")
    body = ElementTree.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', encoding="utf-8")
    return sum(text not in known for text in texts)


def main() -> None:
    texts = all_texts()
    for path in sorted((ROOT / "i18n").glob("semref_*.ts")):
        missing = write(path, texts, translations_in(path))
        print(f"{path.name}: {len(texts)} texts, {missing} without translation")
    if not texts:
        sys.exit("No text was found. Run the script in the repository.")


if __name__ == "__main__":
    main()
