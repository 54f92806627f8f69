"""Whether the running Python has PyQt6, for tests that start it in another process."""

import sys
from pathlib import Path

import pytest

needs_pyqt6 = pytest.mark.skipif(
    not any((Path(entry or ".") / "PyQt6" / "QtCore.pyi").exists() for entry in sys.path),
    reason="PyQt6 is not installed (tools/test_newest.sh installs it)",
)
