"""core/limits.py: every limit has a reason, and something is held to it."""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BODY = ast.parse((ROOT / "core" / "limits.py").read_text(encoding="utf-8")).body


def test_every_limit_has_a_reason_and_a_use():
    names = {node.targets[0].id for node in BODY if isinstance(node, ast.Assign)}
    reasons = [after for node, after in zip(BODY, BODY[1:]) if isinstance(node, ast.Assign)]
    assert len(names) == len(reasons) > 50
    assert all(isinstance(reason, ast.Expr) and reason.value.value.endswith(".") for reason in reasons)
    rooms = ("core", "storage", "processing")
    files = [path for room in rooms for path in (ROOT / room).rglob("*.py") if path.name != "limits.py"]
    used = {name for path in files for name in _limits_in(path)}
    assert names - used == set() == used - names


def _limits_in(path: Path) -> list[str]:
    return re.findall(r"\blimits\.([A-Z][A-Z0-9_]*)\b", path.read_text(encoding="utf-8"))
