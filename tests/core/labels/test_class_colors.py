"""Colors that classes are known by."""

from __future__ import annotations

import colorsys

import pytest

from semref.core.labels.class_colors import is_usual_landmark, known_color, shades


def hue_and_lightness(color: str) -> tuple[float, float]:
    red, green, blue = (int(color[n : n + 2], 16) / 255 for n in (1, 3, 5))
    hue, lightness, _ = colorsys.rgb_to_hls(red, green, blue)
    return 360 * hue, lightness


@pytest.mark.parametrize("name", ["water", "Lake or Pond", "Gewässer", "río", "511 Water courses", "RIVER"])
def test_water_is_blue(name):
    hue, _ = hue_and_lightness(known_color(name))
    assert 190 < hue < 230


@pytest.mark.parametrize("name", ["7", "", "Klasse A", "xyz", "waterproofing"])
def test_a_name_that_tells_nothing_has_no_color(name):
    assert known_color(name) is None
    assert not is_usual_landmark(name)


def test_what_stays_where_it_is_is_a_usual_landmark():
    names = ("building", "water", "bare_land", "forest", "cultivated", "grass_scrub", "built_up")
    assert [name for name in names if is_usual_landmark(name)] == ["building", "water", "bare_land"]


def test_a_color_that_comes_again_is_another_shade_each_time():
    found = shades(["#1f7a3a"] * 6 + ["#3a87c8"])
    assert found[0] == "#1f7a3a" and found[-1] == "#3a87c8"
    assert len(set(found)) == 7
    lightness = [hue_and_lightness(color)[1] for color in found[:4]]
    assert lightness[1] > lightness[0] > lightness[2] and lightness[3] > lightness[1]
