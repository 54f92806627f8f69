"""Writes the generated reference pages into docs/reference/, where git ignores them:

    .venv/bin/python tools/docs/reference_pages.py

Needs QGIS, as the algorithms describe themselves. The site build runs it.
"""

import sys
from pathlib import Path

import list_algorithms
import list_commands
import list_messages
import list_settings

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "reference"
NAMES = ("algorithms.md", "messages.md", "command_line.md", "settings.md")


def main() -> None:
    sys.path.append(str(ROOT / "tools"))
    from qgis_session import qgis_session

    with qgis_session() as provider:
        texts = (list_algorithms.page(provider), list_messages.page(), list_commands.page(), list_settings.page())
    FOLDER.mkdir(exist_ok=True)
    for name, text in zip(NAMES, texts):
        (FOLDER / name).write_text(text, encoding="utf-8")
    print(f"{FOLDER}: {', '.join(NAMES)}")


if __name__ == "__main__":
    main()
