"""Benchmarks of localization from database file to table, as `tools/bench` runs them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("git") is None, reason="a benchmark tells its commit, and git is not here"),
]


def quick(repository, tmp_path, *names, data):
    """What `tools/bench NAMES --quick` prints, each case tried once."""
    options = ["--quick", "--count", "1", "--work", str(tmp_path), "--data", str(data)]
    command = [sys.executable, str(repository / "tools" / "bench"), *names, *options]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "DISPLAY": ""}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


NAMES = ("localization", "two_dates", "elsewhere", "catalogue_sizes", "astroalign", "correlation", "automatic")


def test_localization_goes_from_the_database_file_to_the_table(repository, tmp_path):
    shown = quick(repository, tmp_path, *NAMES, "assessment", "dock", data=tmp_path / "nothing")
    # Of correlation and of the dock there are two sections each.
    assert shown.count("\n## ") == 11 and shown.count("Not measured") == 10
    assert "| 20 % missed, 20 % spurious, 5 % mislabeled | ≥ 99 %, wrong ≤ 0.1 % | 1/1" in shown


def test_tilted_cameras_photos_and_onboard_files_are_measured_on_the_sample_area_too(repository, tmp_path):
    shown = quick(repository, tmp_path, "attitude", "photos", "onboard", data=tmp_path / "nothing")
    assert "Not measured" not in shown
    assert "| 10°, leveled |" in shown and "| constellation |" in shown and "1 images, 1 fixes by the plugin" in shown


def test_cases_can_be_chosen_by_parts_of_their_names(repository, tmp_path):
    shown = quick(repository, tmp_path, "localization", "--only", "Tilted 5,rotation 30", data=tmp_path / "nothing")
    rows = [line.split("|")[1].strip() for line in shown.splitlines() if line.startswith("| 20")]
    assert rows == [f"20 / 20 / 5 %, {case}" for case in ("camera tilted 5°", "rotation 30°", "rotation 300°")]


def test_real_data_is_tried_where_it_is(repository, tmp_path, real_data):
    folder = real_data("lcdb5_christchurch/lcdb5_christchurch.gpkg").parents[1]
    shown = quick(repository, tmp_path, "two_dates", "elsewhere", data=folder)
    assert "Not measured" not in shown and ", topology vector |" in shown and "| all | 0/6" in shown
