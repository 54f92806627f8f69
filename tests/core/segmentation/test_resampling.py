import cv2
import numpy as np
import pytest

from semref.core.errors import ImageError
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.resampling import ResampledImage, at_resolution, resized_transform

PHOTO = np.random.default_rng(4).integers(0, 256, (61, 97, 3)).astype(np.uint8)


def whole(image):
    return image.read(0, 0, *image.shape_hw[::-1])


@pytest.mark.parametrize(
    ("pixel_size_m", "resolution_m"), [(None, 0.5), ((0.1, 0.1), None), ((0.5, 0.52), 0.5), ((0.1, 0.1), 0)]
)
def test_an_image_stays_as_it_is_where_a_resolution_is_unknown_or_both_are_the_same(pixel_size_m, resolution_m):
    image = ArrayImage(PHOTO)
    assert at_resolution(image, pixel_size_m, resolution_m) is image


@pytest.mark.parametrize("turn", [1, np.exp(0.3j)])
def test_pixels_of_a_whole_number_stay_squares_around_the_middle(turn):
    columns, rows = 5 * turn, -5j * turn
    before = 500_000.0, columns.real, rows.real, 5_000_000.0, columns.imag, rows.imag
    x, x_column, x_row, y, y_column, y_row = resized_transform(before, (723, 934), (1004, 1297))
    made_columns, made_rows = complex(x_column, y_column), complex(x_row, y_row)
    assert abs(made_columns) == pytest.approx(abs(made_rows), rel=1e-12)
    assert abs(made_columns / columns - 934 / 1297) < 0.5 / 1297
    corners = [(0, 0), (1297, 0), (0, 1004), (1297, 1004)]
    shift = complex(x, y) - (500_000 + 5_000_000j)
    moved = [
        shift + c * (made_columns - 934 / 1297 * columns) + r * (made_rows - 723 / 1004 * rows) for c, r in corners
    ]
    assert max(map(abs, moved)) < abs(made_columns) / 2
    assert sum(moved) == pytest.approx(0, abs=1e-6)


def test_pixels_that_are_no_squares_stay_so_and_what_is_not_resized_as_it_is():
    degrees = 8.0, 1e-5, 0.0, 60.0, 0.0, -1e-5
    assert resized_transform(degrees, (100, 200), (100, 100)) == pytest.approx((8.0, 2e-5, 0.0, 60.0, 0.0, -1e-5))
    assert resized_transform(degrees, (100, 200), (100, 200)) is degrees
    assert resized_transform(None, (100, 200), (50, 100)) is None


def test_an_image_of_which_nothing_is_left_is_refused():
    with pytest.raises(ImageError, match="no pixel left"):
        at_resolution(ArrayImage(PHOTO), (0.01, 0.01), 100)


@pytest.mark.slow
@pytest.mark.parametrize("shape_hw", [(30, 48), (61, 50), (20, 96), (7, 5), (1, 1)])
def test_a_smaller_image_has_the_means_of_the_area_that_each_pixel_covers(shape_hw):
    fine = np.repeat(np.repeat(PHOTO.astype(float), shape_hw[0], 0), shape_hw[1], 1)
    means = fine.reshape(shape_hw[0], 61, shape_hw[1], 97, 3).mean(axis=(1, 3))
    found, has_data = whole(ResampledImage(ArrayImage(PHOTO), shape_hw))
    assert has_data is None
    # Rounding allows half a level; ties may be rounded either way in floating point.
    assert np.abs(found - means).max() <= 0.5 + 1e-9


@pytest.mark.parametrize("shape_hw", [(61, 97), (122, 194), (100, 110), (62, 500)])
def test_a_larger_image_is_interpolated_as_opencv_does(shape_hw):
    wanted = cv2.resize(PHOTO.astype(np.float32), shape_hw[::-1], interpolation=cv2.INTER_LINEAR)
    found, _ = whole(ResampledImage(ArrayImage(PHOTO), shape_hw))
    assert np.abs(found - wanted).max() <= 0.51


@pytest.mark.parametrize("shape_hw", [(33, 40), (55, 90), (80, 130)])
def test_a_piece_is_cut_from_the_whole_bit_for_bit(shape_hw):
    has_data = np.random.default_rng(5).random(PHOTO.shape[:2]) > 0.6
    for image in (ArrayImage(PHOTO), ArrayImage(PHOTO * has_data[..., None], has_data)):
        image = ResampledImage(image, shape_hw)
        pixels, data = whole(image)
        for column, row, width, height in ((0, 0, 9, 31), (5, 7, 20, 3), (shape_hw[1] - 1, shape_hw[0] - 1, 1, 1)):
            place = slice(row, row + height), slice(column, column + width)
            piece, piece_data = image.read(column, row, width, height)
            np.testing.assert_array_equal(piece, pixels[place])
            if data is not None:
                np.testing.assert_array_equal(True if piece_data is None else piece_data, data[place])


@pytest.mark.parametrize("shape_hw", [(20, 32), (61, 97), (90, 140)])
def test_pixels_without_data_do_not_darken_their_neighbors(shape_hw):
    has_data = np.zeros(PHOTO.shape[:2], bool)
    has_data[:, 40:] = True
    photo = np.where(has_data[..., None], np.uint8(200), np.uint8(0)) * np.ones(3, np.uint8)
    found, data = whole(ResampledImage(ArrayImage(photo, has_data), shape_hw))
    assert set(np.unique(found[data])) == {200} and not found[~data].any()
    assert data.mean() == pytest.approx(57 / 97, abs=0.03)
