"""What an aircraft takes along is closed: nothing in it needs what stays at home."""

from __future__ import annotations

import importlib
import subprocess
import sys

from semref.core.onboard.aircraft import AIRCRAFT_ROOMS


def modules_of(core):
    for name in AIRCRAFT_ROOMS:
        paths = (core / name).rglob("*.py") if (core / name).is_dir() else [core / name]
        for path in paths:
            parts = path.relative_to(core.parent).with_suffix("").parts
            if parts[-1] not in ("__init__", "__main__"):
                yield ".".join(parts)


def test_every_room_is_there_and_imports_no_other(repository):
    """In a process of its own, so that modules that another test has loaded do not hide an import."""
    modules = list(modules_of(repository / "core"))
    assert len(modules) > 50
    for name in modules:
        assert importlib.util.find_spec(f"semref.{name}") is not None
    program = (
        "import importlib, sys\n"
        "sys.path.insert(0, '')\n"
        f"for name in {modules!r}:\n"
        "    importlib.import_module(name)\n"
        "print(*{name.split('.')[1] for name in sys.modules if name.startswith('core.')})\n"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=repository, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert set(done.stdout.split()) <= {name.partition(".")[0] for name in AIRCRAFT_ROOMS}


def test_the_documentation_names_the_rooms(repository):
    text = (repository / "docs" / "file-formats.md").read_text(encoding="utf-8")
    assert [name for name in AIRCRAFT_ROOMS if f"`{name}`" not in text] == []
