"""A label map that workers see together is that of the algorithm, byte by byte."""

from __future__ import annotations

import numpy as np
import pytest
from clustered import lose_a_worker, require_nothing_after
from made_inputs import NORTH, WEST, scattered_objects, write_raster
from made_models import painted, write_model

SIZE = 1150, 930


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    return write_model(tmp_path_factory.mktemp("model") / "colors.onnx")


@pytest.fixture(scope="module")
def photo(tmp_path_factory):
    """Some blocks of tiles, a part of them without data."""
    pixels = np.moveaxis(painted(scattered_objects(*SIZE, 900, seed=3, background=0)), 2, 0).copy()
    noise = np.random.default_rng(1).integers(0, 60, pixels.shape).astype(np.uint8)
    pixels = np.where(pixels > 128, pixels - noise, pixels + noise)
    pixels[:, 300:520, 100:460] = 0
    path = tmp_path_factory.mktemp("photo") / "photo.tif"
    return write_raster(path, pixels, transform=(WEST, 0.5, 0, NORTH, 0, -0.5), crs=25832, nodata=0)


@pytest.fixture(scope="module")
def seen(photo, model, run_algorithm, tmp_path_factory):
    """What the algorithm writes: path, and how sure the network is."""
    target = tmp_path_factory.mktemp("seen") / "labels.tif"
    found = run_algorithm("semref:segmentimage", {"INPUT": str(photo), "MODEL": str(model), "OUTPUT": str(target)})
    return target, found.get("CERTAINTY")


def segment(cluster, photo, model, target, *options):
    return cluster("segment", photo, "--model", model, "--labels", target, *options)


@pytest.mark.parametrize("workers", [pytest.param(1, marks=pytest.mark.slow), 2])
def test_it_is_the_algorithm_s_file_whatever_the_number_of_workers(cluster, photo, model, seen, tmp_path, workers):
    result = segment(cluster, photo, model, tmp_path / "labels.tif", "--local", workers)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "labels.tif").read_bytes() == seen[0].read_bytes()
    told = dict(line.split(": ") for line in result.stdout.splitlines())
    assert 100 * float(told["certainty"]) == pytest.approx(seen[1])


@pytest.mark.slow
def test_a_worker_that_is_killed_changes_nothing(cluster, photo, model, seen, tmp_path):
    target = tmp_path / "labels.tif"
    running = cluster.start("segment", photo, "--model", model, "--labels", target, "--local", 2)
    lose_a_worker(running, "Segmenting")
    assert target.read_bytes() == seen[0].read_bytes()


def test_an_interrupt_leaves_nothing(cluster, photo, model, tmp_path):
    running = cluster.start("segment", photo, "--model", model, "--labels", tmp_path / "never.tif", "--local", 1)
    require_nothing_after("SIGINT", running, "Segmenting", tmp_path)


@pytest.mark.parametrize(
    ("image", "network", "part"),
    [("none.tif", None, "none.tif"), (None, "none.onnx", "none.onnx"), ("small.tif", None, "3 × 3")],
)
def test_what_can_t_be_used_is_said_in_one_sentence(cluster, photo, model, tmp_path, image, network, part):
    write_raster(tmp_path / "small.tif", np.zeros((3, 3, 3), np.uint8), transform=None)
    image, network = (tmp_path / image if image else photo), (tmp_path / network if network else model)
    result = segment(cluster, image, network, tmp_path / "labels.tif", "--local", 1)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == 3 and last.startswith("cluster: ") and last.endswith("."), result.stderr
    assert part in last and "Traceback" not in result.stderr and not (tmp_path / "labels.tif").exists()


def test_the_photo_is_not_replaced_by_its_labels(cluster, photo, model):
    before = photo.read_bytes()
    result = segment(cluster, photo, model, photo, "--local", 1)
    assert result.returncode == 2 and "would replace" in result.stderr and photo.read_bytes() == before
