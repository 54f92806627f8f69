"""Two commits taking turns."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def against():
    path = list(sys.path)
    sys.path.insert(0, str(ROOT / "tools"))
    spec = importlib.util.spec_from_file_location("against", ROOT / "tools" / "against.py")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path[:] = path
    return module


def test_a_command_names_the_working_tree_it_runs_in(against):
    command = against.in_tree(["{root}/a", "import {name}", "{folder}"], Path("/x/then"))
    assert command == ["/x/then/a", "import then", "/x"]


def test_only_the_time_of_the_processor_counts(against, tmp_path):
    program = "import time; time.sleep(0.4)"
    assert against.processor_seconds([sys.executable, "-S", "-c", program], tmp_path) < 0.3
    busy = "import time\nend = time.process_time() + 0.5\nwhile time.process_time() < end: pass"
    assert against.processor_seconds([sys.executable, "-S", "-c", busy], tmp_path) > 0.4


def test_a_command_that_fails_is_told(against, tmp_path):
    with pytest.raises(SystemExit, match="exit status 3"):
        against.processor_seconds([sys.executable, "-S", "-c", "raise SystemExit(3)"], tmp_path)
