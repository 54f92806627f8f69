"""The numbers that workers evaluate together are those of the algorithm, byte by byte."""

from __future__ import annotations

import json

import pytest
from built_database import NAMES
from clustered import require_nothing_after
from made_inputs import scattered_objects, write_raster

SIZE = 160
LABELS = scattered_objects(420, 480, 300, seed=21, background=0)


@pytest.fixture(scope="module")
def area(build_area, tmp_path_factory):
    """Paths of a database and of a label map."""
    path = tmp_path_factory.mktemp("map") / "labels.tif"
    return build_area(LABELS, NAMES, SIZE, 40), str(write_raster(path, LABELS, names=NAMES))


@pytest.fixture(scope="module")
def told(run_algorithm, area, tmp_path_factory):
    """What the algorithm writes, its images tried by a worker."""
    pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
    target = tmp_path_factory.mktemp("told") / "numbers.json"
    asked = {"DATABASE": area[0], "LABELS": area[1], "TRIALS": 12, "SCHEDULER": "local:1", "JSON": str(target)}
    run_algorithm("semref:evaluatelocalization", {**asked, "OUTPUT": "TEMPORARY_OUTPUT"})
    return target.read_bytes()


@pytest.mark.parametrize("workers", [pytest.param(1, marks=pytest.mark.slow), 2])
def test_it_is_the_algorithm_s_file_whatever_the_number_of_workers(cluster, area, told, tmp_path, workers):
    target = tmp_path / "numbers.json"
    result = cluster("evaluate", *area, "--output", target, "--trials", 12, "--local", workers)
    assert result.returncode == 0, result.stderr
    assert target.read_bytes() == told
    assert 0 < json.loads(told)["methods"]["automatic"]["right"]["share"] <= 1
    assert "success_rate: " in result.stdout and "method: automatic" in result.stdout


def test_an_interrupt_leaves_nothing(cluster, area, tmp_path):
    running = cluster.start("evaluate", *area, "--output", tmp_path / "never.json", "--local", 1)
    require_nothing_after("SIGINT", running, "Localizing", tmp_path)


@pytest.mark.parametrize(
    ("options", "code", "part"),
    [
        (["--methods", "magic"], 2, "“magic” is no method"),
        (["--methods", ";"], 2, "is no method"),
        (["--missed", "20"], 2, "--missed is “20”"),
        (["--scale", "2,1"], 2, "scale"),
        (["--minimum-references", "9999"], 2, "9999"),
    ],
)
def test_what_can_t_be_meant_is_said_in_one_sentence(cluster, area, tmp_path, options, code, part):
    result = cluster("evaluate", *area, "--output", tmp_path / "never.json", *options, "--local", 1)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == code and part in last and last.endswith("."), result.stderr
    assert "Traceback" not in result.stderr and list(tmp_path.iterdir()) == []


def test_a_map_in_another_crs_or_with_other_classes_is_refused(cluster, area, tmp_path):
    elsewhere = write_raster(tmp_path / "elsewhere.tif", LABELS, names=NAMES, crs=32633)
    otherwise = write_raster(tmp_path / "otherwise.tif", LABELS, names=["", "house", "water", "bare_land"])
    for path, part in ((elsewhere, "warp the label map"), (otherwise, "“house”")):
        result = cluster("evaluate", area[0], path, "--output", tmp_path / "never.json", "--local", 1)
        assert result.returncode == 3 and part in result.stderr and "Traceback" not in result.stderr
    assert not (tmp_path / "never.json").exists()
