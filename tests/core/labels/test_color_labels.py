import colorsys

import cv2
import numpy as np
import pytest

from semref.core.errors import ClassTableError
from semref.core.labels.class_table import ClassTable, LandCoverClass, class_table_from_values
from semref.core.labels.color_labels import decode_by_hsv, decode_by_nearest_color

RED = LandCoverClass(1, "building", "#ff0000", hsv_min=(170, 100, 100), hsv_max=(10, 255, 255))
BLUE = LandCoverClass(2, "water", "#0000ff", hsv_min=(110, 100, 100), hsv_max=(130, 255, 255))
BLUISH = LandCoverClass(5, "ice", "#8888ff", hsv_min=(90, 50, 50), hsv_max=(150, 255, 255))
GREEN = LandCoverClass(3, "forest", "#00ff00")


def image_of(*colors_rgb):
    return np.array([[color[::-1] for color in colors_rgb]], np.uint8).reshape(1, -1, 3)


@pytest.mark.parametrize(
    ("degrees", "label"), [(0, 1), (18, 1), (22, 0), (338, 0), (342, 1), (358, 1), (120, 0), (240, 2)]
)
def test_a_hue_range_may_wrap_around_red(degrees, label):
    hue = [round(255 * part) for part in colorsys.hsv_to_rgb(degrees / 360, 1, 1)]
    assert decode_by_hsv(image_of(hue), ClassTable((RED, BLUE))).tolist() == [[label]]


@pytest.mark.parametrize("color", [(70, 0, 0), (255, 200, 200), (40, 10, 10)])
def test_saturation_and_value_count_on_both_sides_of_the_wrap(color):
    assert decode_by_hsv(image_of(color), ClassTable((RED,))).tolist() == [[0]]


def test_where_ranges_overlap_the_first_class_by_value_wins():
    image = image_of((0, 0, 255), (128, 128, 255))
    assert decode_by_hsv(image, ClassTable((BLUISH, BLUE))).tolist() == [[2, 2]]
    renumbered = LandCoverClass(1, "ice", "#8888ff", hsv_min=BLUISH.hsv_min, hsv_max=BLUISH.hsv_max)
    assert decode_by_hsv(image, ClassTable((renumbered, BLUE))).tolist() == [[1, 1]]


def test_decoding_by_hsv_without_any_range_is_refused():
    with pytest.raises(
        ClassTableError,
        match="^No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color.$",
    ):
        decode_by_hsv(image_of((0, 0, 0)), ClassTable((GREEN,)))


def test_a_black_class_keeps_its_pixels_and_equally_near_colors_go_to_the_smaller_value():
    table = ClassTable((RED, LandCoverClass(9, "coal", "#000000")))
    assert decode_by_nearest_color(image_of((0, 0, 0), (9, 9, 9)), table).tolist() == [[9, 9]]
    table = ClassTable((LandCoverClass(4, "a", "#640000"), LandCoverClass(8, "b", "#840000")))
    assert decode_by_nearest_color(image_of((0x74, 0, 0)), table).tolist() == [[4]]


@pytest.mark.parametrize(
    ("decode", "table"),
    [
        *((decode_by_nearest_color, class_table_from_values(values)) for values in ([1], [1, 2, 3, 7], range(1, 256))),
        (decode_by_hsv, ClassTable((RED, BLUE))),
    ],
    ids=["one class", "four", "255", "by HSV"],
)
def test_decoding_exactly_inverts_painting(decode, table):
    labels = np.random.default_rng(0).choice(np.array([0, *(c.value for c in table)], np.uint8), (40, 60))
    image = np.zeros((*labels.shape, 3), np.uint8)
    for c in table:
        image[labels == c.value] = c.rgb[::-1]
    assert (decode(image, table) == labels).all()


@pytest.mark.parametrize("decode", [decode_by_hsv, decode_by_nearest_color])
def test_a_view_of_a_larger_image_decodes_like_a_copy_and_stays_as_it_was(decode):
    image = np.random.default_rng(2).integers(0, 256, (30, 40, 3), dtype=np.uint8)
    view, before = image[5:20, 3:33], image.copy()
    table = ClassTable((RED, BLUE, BLUISH))
    assert (decode(view, table) == decode(view.copy(), table)).all()
    assert (decode(image[..., ::-1], table) == decode(cv2.cvtColor(image, cv2.COLOR_BGR2RGB), table)).all()
    assert (image == before).all()
