"""Benchmarks of localization from database file to table, as `tools/bench` runs them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(shutil.which("git") is None, reason="a benchmark tells its commit, and git is not here")


def quick(repository, tmp_path, *names, data):
    """What `tools/bench NAMES --quick` prints, each case tried once."""
    options = ["--quick", "--count", "1", "--work", str(tmp_path), "--data", str(data)]
    command = [sys.executable, str(repository / "tools" / "bench"), *names, *options]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_localization_goes_from_the_database_file_to_the_table(repository, tmp_path):
    names = ("localization", "two_dates", "elsewhere", "catalogue_sizes", "correlation_times", "astroalign")
    shown = quick(repository, tmp_path, *names, data=tmp_path / "nothing")
    assert shown.count("\n## ") == len(names) and shown.count("Not measured") == 5
    assert "| 20 % missed, 20 % invented, 5 % misnamed | ≥ 99 %, wrong ≤ 0.1 % | 1/1" in shown


def test_real_data_is_tried_where_it_is(repository, tmp_path, real_data):
    folder = real_data("lcdb5_christchurch/lcdb5_christchurch.gpkg").parents[1]
    shown = quick(repository, tmp_path, "two_dates", "elsewhere", data=folder)
    assert "Not measured" not in shown and "| topology vector |" in shown and "| all | 0/5" in shown
