"""Custom widgets of ui/ are painted with Qt 6 if PyQt6 is installed; QGIS is not needed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from qt6_here import needs_pyqt6

PROGRAM = Path(__file__).resolve().parents[1] / "data" / "qt6_widgets.py"
PAINTED = {
    "vector_plot": 5000,
    "empty_plot": 200,
    "status_line": 500,
    "image_view": 50_000,
    "results_list": 10_000,
    "empty_list": 500,
    "details": 1000,
    "components_page": 20_000,
    "missing_notice": 1000,
    "row_of_buttons": 350,
}
"""Least number of pixels that differ from the background: about a third of those with one style and font."""


@pytest.fixture(scope="module")
def painted(tmp_path_factory):
    profile = tmp_path_factory.mktemp("profile")
    surroundings = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONWARNINGS": "default"}
    command = [sys.executable, str(PROGRAM), str(profile)]
    return subprocess.run(command, capture_output=True, text=True, env=surroundings, timeout=300, check=False)


@needs_pyqt6
def test_the_widgets_are_made_shown_and_used_without_an_error(painted):
    assert painted.returncode == 0, painted.stderr
    assert "Traceback" not in painted.stderr and "QPainter" not in painted.stderr


@needs_pyqt6
@pytest.mark.parametrize("widget", PAINTED)
def test_the_picture_of_a_widget_is_not_empty(painted, widget):
    seen = json.loads(painted.stdout.splitlines()[-1])
    assert set(seen) == set(PAINTED)
    assert seen[widget]["pixels"] >= PAINTED[widget] and seen[widget]["colors"] > 10
