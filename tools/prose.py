"""Check the English of docs, screen texts, docstrings and commit subjects: ``python3 tools/prose.py [PATH …]``.

Without paths, check everything; fail if a kind of text (except commits) exceeds its limits. With paths, list findings.
"""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tools" / "release"))
from update_translations import all_texts, texts_of  # noqa: E402

MARKERS = re.compile(
    r"\b(?:(?i:tells?|telling|told|lies?|lying|stands?|stood|anew|whoever|whose|of which|look-alikes?|at hand"
    r"|(?:is|are|was) said|mend(?:s|ed|ing)?|heed(?:s|ed|ing)?|reckon(?:s|ed|ing)?)|none)\b"
)
"""Words that earlier texts used in odd senses. Code in backquotes does not count."""

MARKERS_PER_1000, WORDS_PER_SENTENCE, LONGEST_SENTENCE, LONGEST_HEADING, LONGEST_SUBJECT = 0.5, 20, 40, 12, 72
_NOT_PROSE = re.compile(r"```.*?```|``.*?``|`[^`]*`|<!--.*?-->|\]\([^)]*\)|https?://\S+|<[^>]+>", re.DOTALL)


def sentences(text: str) -> list[str]:
    """Return the sentences of a Markdown or plain text; a heading, list item or table cell ends one."""
    text = re.sub(r"\n(?=\s*(?:[-*#|>]|\d+\. ))|\n\s*\n|\|", "\0", _NOT_PROSE.sub(" x ", text))
    parts = re.split(r"\0|(?<=[.!?:])\s+(?=[A-Z*\[(“\"])", text)
    return [" ".join(part.split()) for part in parts if re.search(r"[A-Za-z]{2}", part)]


def words(text: str) -> int:
    return len(re.findall(r"[A-Za-z’'-]*[A-Za-z]{2}[A-Za-z’'-]*", text))


def docstrings(path: Path) -> list[str]:
    """Return the docstrings of a Python file."""
    owners = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    nodes = [node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, owners)]
    return [text for node in nodes if (text := ast.get_docstring(node))]


def commit_subjects() -> list[str]:
    command = ["git", "-C", str(ROOT), "log", "-20", "--no-merges", "--format=%s"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.splitlines()


def tracked(*patterns: str) -> list[Path]:
    command = ["git", "-C", str(ROOT), "ls-files", *patterns]
    names = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    return [ROOT / name for name in names if (ROOT / name).exists()]


def texts_in(path: Path) -> Iterator[str]:
    source = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        yield from docstrings(path)
        yield from texts_of(source)
    else:
        yield source


def report(kind: str, texts: list[str], listed: bool) -> bool:
    """Print the figures of a kind of text; return whether they are within the limits."""
    found = [(sentence, words(sentence)) for text in texts for sentence in sentences(text)]
    total = max(1, sum(length for _, length in found))
    full = [length for _, length in found if length > 3] or [0]
    faults = [f"{', '.join(MARKERS.findall(text))}: {text}" for text, _ in found if MARKERS.search(text)]
    rate, mean = 1000 * len(faults) / total, sum(full) / len(full)
    long = [f"{length} words: {text}" for text, length in found if length > LONGEST_SENTENCE]
    long += [f"heading: {text}" for text, length in found if text.startswith("#") and length > LONGEST_HEADING]
    print(f"{kind}: {total} words, {rate:.2f} markers per 1,000, {mean:.1f} words a sentence, {len(long)} too long")
    good = rate <= MARKERS_PER_1000 and mean <= WORDS_PER_SENTENCE and not long
    for fault in faults + long if listed or not good else []:
        print(f"  {fault}")
    return good


def main() -> int:
    if paths := [Path(name) for name in sys.argv[1:]]:
        files = [file for path in paths for file in ([path] if path.is_file() else sorted(path.rglob("*.[pm][yd]")))]
        within = [report(str(file), list(texts_in(file)), listed=True) for file in files]
        return not all(within)
    kinds = {
        "docs": [path.read_text(encoding="utf-8") for path in tracked("*.md")],
        "screen": all_texts(),
        "docstrings": [text for path in tracked("*.py") for text in docstrings(path)],
        "commits": commit_subjects(),
    }
    good = {kind: report(kind, texts, listed=False) for kind, texts in kinds.items()}
    long = [subject for subject in kinds["commits"] if len(subject) > LONGEST_SUBJECT]
    print("".join(f"  over {LONGEST_SUBJECT} characters: {subject}\n" for subject in long), end="")
    return not all(good[kind] for kind in good if kind != "commits")  # commits can't be changed later


if __name__ == "__main__":
    sys.exit(main())
