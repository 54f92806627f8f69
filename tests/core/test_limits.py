"""Every limit of core/limits.py has a reason and a use."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = (ROOT / "core" / "limits.py").read_text(encoding="utf-8")


def test_every_limit_has_a_reason_and_a_use():
    names = set(re.findall(r"^([A-Z]\w+) = ", TABLE, flags=re.MULTILINE))
    assert names == set(re.findall(r"^([A-Z]\w+) = .+  # [^#]+\.$", TABLE, flags=re.MULTILINE)) != set()
    rooms = ("core", "storage", "processing")
    files = [path for room in rooms for path in (ROOT / room).rglob("*.py") if path.name != "limits.py"]
    used = {name for path in files for name in re.findall(r"\blimits\.([A-Z]\w+)", path.read_text(encoding="utf-8"))}
    assert names == used
