"""Screenshots become small files without looking different."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import cv2
import numpy as np
import pytest

TOOL = Path(__file__).resolve().parents[2] / "tools" / "docs" / "palette_png.py"
spec = importlib.util.spec_from_file_location("palette_png", TOOL)
palette_png = importlib.util.module_from_spec(spec)
spec.loader.exec_module(palette_png)

PLENTY = 10_000_000


@pytest.fixture
def shrunk(tmp_path):
    """`shrunk(picture, largest_bytes)` gives the picture that is left, RGB, and its size in bytes."""

    def shrink(picture: np.ndarray, largest_bytes: int = PLENTY):
        source, target = tmp_path / "source.png", tmp_path / "target.png"
        cv2.imwrite(str(source), cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
        palette_png.shrink(source, target, largest_bytes)
        return cv2.cvtColor(cv2.imread(str(target)), cv2.COLOR_BGR2RGB), target.stat().st_size

    return shrink


def noise(seed: int = 7) -> np.ndarray:
    return np.random.default_rng(seed).integers(0, 256, (90, 120, 3)).astype(np.uint8)


def test_a_picture_of_few_colors_stays_what_it_is_inside_its_frame(shrunk):
    picture = np.zeros((40, 60, 3), np.uint8)
    picture[10:20, 5:50] = 200, 30, 60
    found, _ = shrunk(picture)
    assert (found[1:-1, 1:-1] == picture[1:-1, 1:-1]).all()
    assert (found[[0, -1]] == palette_png.FRAME_GRAY).all() and (found[:, [0, -1]] == palette_png.FRAME_GRAY).all()


def test_colors_of_a_busy_picture_are_near_their_own(shrunk):
    ramp = np.zeros((256, 256, 3), np.uint8)
    ramp[..., 0], ramp[..., 1] = np.arange(256), np.arange(256)[:, None]
    found, _ = shrunk(ramp)
    assert np.abs(found[1:-1, 1:-1].astype(int) - ramp[1:-1, 1:-1]).mean() < 6


def test_swatches_of_a_legend_keep_their_colors_beside_a_busy_map(shrunk):
    rng = np.random.default_rng(3)
    picture = rng.normal((150, 140, 70), 25, (300, 400, 3)).clip(0, 255).astype(np.uint8)
    swatches = [(25, 110, 45), (70, 150, 220), (160, 30, 120), (250, 250, 60)]
    for n, color in enumerate(swatches):
        picture[20 + 40 * n : 31 + 40 * n, 10:21] = color
    found, _ = shrunk(picture)
    for n, color in enumerate(swatches):
        assert np.abs(found[25 + 40 * n, 15].astype(int) - color).max() <= palette_png.NEAR


def test_a_large_file_gets_fewer_colors(shrunk):
    _, whole = shrunk(noise())
    found, smaller = shrunk(noise(), whole - 1)
    assert smaller < whole
    assert len(np.unique(found.reshape(-1, 3), axis=0)) <= palette_png.COLOR_COUNTS[1] + 1


def test_a_file_that_stays_too_large_is_written_and_said(shrunk, capsys):
    shrunk(noise(), 10)
    assert "more than" in capsys.readouterr().err


def test_the_same_picture_gives_the_same_file(shrunk):
    assert (shrunk(noise())[0] == shrunk(noise())[0]).all()
