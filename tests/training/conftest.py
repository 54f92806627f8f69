"""Training in the Python that has torch, where there is one."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def training_python() -> Path:
    """The Python of .venv-train, or the one that SEMREF_TRAINING_PYTHON names; skips where there is none."""
    python = Path(os.environ.get("SEMREF_TRAINING_PYTHON") or ROOT / ".venv-train" / "bin" / "python")
    if not python.exists():
        pytest.skip("no Python with torch: run bash tools/training/setup_training.sh")
    return python
