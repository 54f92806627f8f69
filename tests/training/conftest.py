"""Run training in a Python with torch, if there is one."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def training_python() -> Path:
    """Return the Python of .venv-train or of SEMREF_TRAINING_PYTHON; skip if it is missing."""
    python = Path(os.environ.get("SEMREF_TRAINING_PYTHON") or ROOT / ".venv-train" / "bin" / "python")
    if not python.exists():
        pytest.skip("no Python with torch: run bash tools/training/setup_training.sh")
    return python
