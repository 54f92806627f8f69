"""Frames from the screen become one small picture that moves."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools" / "docs"))
Image = pytest.importorskip("PIL.Image")

import moving_webp  # noqa: E402


@pytest.fixture
def frames(tmp_path):
    """Three frames of another color each, shown 100, 200 and 300 ms; written out of order, beside another picture."""
    for number in (2, 0, 1):
        color = [0, 0, 0]
        color[number] = 255
        name = moving_webp.frame_name("film", number, 100 * (number + 1))
        Image.new("RGB", (40, 30), tuple(color)).save(tmp_path / name)
    Image.new("RGB", (40, 30)).save(tmp_path / "other.png")
    return list(tmp_path.iterdir())


def test_frames_are_found_by_their_names_in_order(frames):
    films = moving_webp.films(frames)
    assert [path.name for path in films["film"]] == ["film.000.100.png", "film.001.200.png", "film.002.300.png"]
    assert set(films) == {"film"}


def test_the_picture_has_all_frames_for_their_times(frames, tmp_path):
    target = tmp_path / "film.webp"
    moving_webp.join(moving_webp.films(frames)["film"], target, 100_000)
    film = Image.open(target)
    seen = []
    for number in range(film.n_frames):
        film.seek(number)
        film.load()
        color = film.convert("RGB").getpixel((20, 15))
        seen.append((color.index(max(color)), film.info["duration"]))
    assert seen == [(0, 100), (1, 200), (2, 300)]


def test_frames_of_a_window_that_grew_are_cut_to_the_first_one(frames, tmp_path):
    first, *others = moving_webp.films(frames)["film"]
    Image.new("RGB", (44, 30)).save(others[0])
    target = tmp_path / "film.webp"
    moving_webp.join([first, *others], target, 100_000)
    assert Image.open(target).size == (40, 30)


def test_a_picture_that_does_not_get_small_enough_is_told(frames, tmp_path, capsys):
    moving_webp.join(moving_webp.films(frames)["film"], tmp_path / "film.webp", 10)
    assert "more than" in capsys.readouterr().err
