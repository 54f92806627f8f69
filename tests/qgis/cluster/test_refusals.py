"""What is wrong is said in one sentence with an exit code, never with a traceback."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from clustered import SETTINGS
from made_inputs import write_raster

CLASSES = ["--reference-classes", "building"]
ROOT = Path(__file__).resolve().parents[3]


def refused(result, code, *parts):
    lines = result.stderr.strip().splitlines()
    assert result.returncode == code, result.stderr
    assert "Traceback" not in result.stderr and result.stdout == ""
    assert lines[-1].startswith("cluster: ") and lines[-1].endswith(".")
    assert all(part in lines[-1] for part in parts), lines[-1]


def test_a_map_that_is_missing(cluster, tmp_path):
    result = cluster("build", tmp_path / "none.tif", "--database", tmp_path / "a.gpkg", "--local", 1)
    refused(result, 3, "none.tif", "can't be read")


def test_a_scheduler_that_is_not_there(cluster, label_map, tmp_path):
    result = cluster(
        "build", label_map, "--database", tmp_path / "a.gpkg", *CLASSES, "--scheduler", "tcp://127.0.0.1:1"
    )
    refused(result, 3, "tcp://127.0.0.1:1")


def test_a_map_without_landmarks_fails_after_work_and_leaves_nothing(cluster, tmp_path):
    label_map = write_raster(
        tmp_path / "empty.tif", np.full((400, 400), 4, np.uint8), names=["", "a", "b", "c", "field"]
    )
    target = tmp_path / "a.gpkg"
    result = cluster("build", label_map, "--database", target, "--reference-classes", "a", *SETTINGS, "--local", 1)
    refused(result, 3, "a")
    assert not target.exists()


@pytest.mark.parametrize(
    "extra, part",
    [
        (["--stride", "2000"], "2000"),
        (["--levels", "1;much"], "much"),
    ],
)
def test_values_that_can_t_be_used(cluster, label_map, tmp_path, extra, part):
    result = cluster("build", label_map, "--database", tmp_path / "a.gpkg", *extra, "--local", 1)
    refused(result, 2, part)


@pytest.mark.parametrize(
    "option",
    [("--map-accuracy", "nan"), ("--map-accuracy", "-1"), ("--references-per-vector", "1001"), ("--local", "0")],
)
def test_values_out_of_range_are_refused_before_any_work(cluster, label_map, tmp_path, option):
    workers = [] if option[0] == "--local" else ["--local", 1]
    result = cluster("build", label_map, "--database", tmp_path / "a.gpkg", *CLASSES, *workers, *option)
    assert result.returncode == 2 and result.stdout == ""
    last = result.stderr.splitlines()[-1]
    assert f"argument {option[0]}: " in last and " from " in last and last.endswith(f"'{option[1]}'")
    assert not (tmp_path / "a.gpkg").exists()


def test_the_map_is_not_replaced_by_its_database(cluster, label_map):
    refused(cluster("build", label_map, "--database", label_map, "--local", 1), 2, "labels.tif")


def test_a_command_line_without_workers_is_refused(cluster, label_map, tmp_path):
    result = cluster("build", label_map, "--database", tmp_path / "a.gpkg")
    assert result.returncode == 2 and "--local" in result.stderr


def test_help_reads_without_any_package():
    result = subprocess.run(
        [sys.executable, "-S", "-m", "cluster", "--help"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0 and "build" in result.stdout, result.stderr


def test_a_python_without_the_packages_is_told_what_it_lacks(tmp_path):
    result = subprocess.run(
        [
            sys.executable,
            "-S",
            "-m",
            "cluster",
            "build",
            "a.tif",
            "--database",
            str(tmp_path / "a.gpkg"),
            "--local",
            "1",
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    refused(result, 3, "numpy", "requirements.txt")


def test_a_gdal_that_was_made_for_another_numpy_is_told(monkeypatch, capfd):
    """As pip brings about where it takes the newest numpy beside a distribution's GDAL."""
    from semref.cluster import command_line
    from semref.core.errors import SemRefError

    monkeypatch.setitem(sys.modules, "osgeo.gdal_array", None)
    monkeypatch.setattr(command_line, "NEEDED", command_line.NEEDED[:3])
    with pytest.raises(SemRefError) as caught:
        command_line.require_packages()
    assert caught.value.sentence.code == "cluster.unfit_numpy"
    assert dict(caught.value.sentence.values)["version"] == np.__version__
    assert capfd.readouterr().err == ""
