import functools

import cv2
import numpy as np
import pytest

from semref.core.flight.pixel_features import label_features, photo_features
from semref.core.flight.pixel_fit import fit_mapping
from semref.core.flight.pixel_links import PixelLinks
from semref.core.flight.pixel_motion import CHANCE, LEAST_EVIDENCE, evidence, motion_between, unmeasured_covariance
from semref.core.simulation.views import View, image_coordinates, map_coordinates

EDGE = 320


@functools.cache
def scene(seed, size=1100):
    """Return a (size, size) gray scene: smooth ground with sharp rectangles like fields and roofs."""
    rng = np.random.default_rng(seed)
    ground = sum(
        weight * cv2.resize(rng.normal(0, 1, (n, n)).astype(np.float32), (size, size), interpolation=cv2.INTER_CUBIC)
        for n, weight in ((12, 25), (60, 14), (250, 8))
    )
    picture = np.clip(120 + ground, 0, 255).astype(np.uint8)
    for _ in range(260):
        middle = tuple(rng.uniform(0, size, 2).tolist())
        box = cv2.boxPoints((middle, tuple(rng.uniform(12, 60, 2).tolist()), float(rng.uniform(0, 90))))
        cv2.fillPoly(picture, [box.astype(np.int32)], int(rng.integers(0, 255)))
    return picture


@functools.cache
def class_map(seed, size=1100):
    levels = np.digitize(cv2.GaussianBlur(scene(seed, size), (0, 0), 3), [80, 120, 160])
    return (levels + 1).astype(np.uint8)


def cut(picture, center, turn_deg, scale, nearest=False):
    """Return (EDGE, EDGE) pixels around a center, turned clockwise, each ``scale`` scene pixels wide."""
    angle, half = np.radians(turn_deg), (EDGE - 1) / 2
    right = scale * np.array([np.cos(angle), np.sin(angle)])
    down = np.array([-right[1], right[0]])
    matrix = np.column_stack([right, down, np.array(center) - half * (right + down)])
    flags = cv2.WARP_INVERSE_MAP | (cv2.INTER_NEAREST if nearest else cv2.INTER_LINEAR)
    return cv2.warpAffine(picture, matrix, (EDGE, EDGE), flags=flags)


def truth(first, second):
    """Return the (4,) pose of the second (center, turn, scale) in the first: right, down, radians, log scale."""
    (x, y), turn, scale = first
    apart = complex(second[0][0] - x, second[0][1] - y) / (scale * np.exp(1j * np.radians(turn)))
    turned = np.radians(second[1] - turn)
    return np.array([apart.real, apart.imag, (turned + np.pi) % (2 * np.pi) - np.pi, np.log(second[2] / scale)])


def found(link):
    return np.array([*link.translation, link.turn, link.log_scale])


VIEWS = [
    (((500, 500), 0, 1.0), ((596, 500), 0, 1.0)),
    (((500, 560), 30, 1.0), ((560, 480), 200, 1.08)),
    (((480, 500), 250, 1.1), ((640, 560), 100, 1.0)),
    (((500, 500), 10, 1.0), ((520, 700), 355, 0.92)),
]


@pytest.mark.parametrize(("first", "second"), VIEWS)
def test_a_photo_is_found_in_the_one_before_it_through_turn_scale_exposure_and_blur(first, second):
    picture = scene(1)
    earlier, later = cut(picture, *first), cut(picture, *second)
    later = cv2.GaussianBlur(np.clip(1.25 * later.astype(np.float32) - 20, 0, 255).astype(np.uint8), (0, 0), 1.0)
    motion = motion_between(photo_features(earlier), photo_features(later), (3, 7))
    assert (motion.reason, motion.link.first, motion.link.second) == (None, 3, 7)
    off = found(motion.link) - truth(first, second)
    assert np.abs(off[:2]).max() < 0.5 and np.abs(off[2:]).max() < 0.002
    assert (np.abs(off) < 4 * np.sqrt(np.diag(motion.link.covariance))).all()


@pytest.mark.parametrize(("first", "second"), VIEWS)
def test_a_label_image_is_found_by_its_boundaries(first, second):
    labels = class_map(2)
    images = (label_features(cut(labels, *view, nearest=True)) for view in (first, second))
    off = found(motion_between(*images).link) - truth(first, second)
    assert np.abs(off[:2]).max() < 1.0 and np.abs(off[2:]).max() < 0.01


def test_color_photos_and_links_in_pixels_of_another_size():
    first, second = VIEWS[0]
    pictures = [cv2.cvtColor(cut(scene(1), *view), cv2.COLOR_GRAY2RGB) for view in (first, second)]
    link = motion_between(photo_features(pictures[0], width=640), photo_features(pictures[1], width=160)).link
    assert link.translation == pytest.approx((192, 0), abs=1)
    assert link.log_scale == pytest.approx(np.log(2 / 0.5), abs=0.005)


def test_motion_of_a_large_photo_is_in_its_own_pixels():
    picture = cv2.resize(scene(4, 1100), (3300, 3300), interpolation=cv2.INTER_CUBIC)
    images = (photo_features(picture[y : y + 1500, x : x + 1800]) for x, y in ((100, 100), (700, 300)))
    assert motion_between(*images).link.translation == pytest.approx((600, 200), abs=1.5)


def test_a_homography_gives_the_tilt_and_the_similarity_at_the_center():
    picture = scene(5)
    earlier = cut(picture, (500, 500), 0, 1.0)
    plane = np.array([[1, 0, 40], [0, 1, 10], [2.5e-4, -1e-4, 1.0]])
    half = np.array([[1, 0, (EDGE - 1) / 2], [0, 1, (EDGE - 1) / 2], [0, 0, 1]])
    matrix = half @ plane @ np.linalg.inv(half)
    shift = np.array([[1, 0, 500 - (EDGE - 1) / 2], [0, 1, 500 - (EDGE - 1) / 2], [0, 0, 1]])
    later = cv2.warpPerspective(picture, shift @ matrix, (EDGE, EDGE), flags=cv2.WARP_INVERSE_MAP)
    link = motion_between(photo_features(earlier), photo_features(later)).link
    assert link.translation == pytest.approx((40, 10), abs=0.3)
    # At the center the derivative of the plane is [[1 − 40 g, …], …] with the tilt g.
    assert link.log_scale == pytest.approx(np.log(1 - 0.5 * (40 * 2.5e-4 - 10 * 1e-4)), abs=0.002)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["photos", "labels"])
def test_images_of_different_ground_have_no_link_and_a_reason(kind):
    for seed in range(6):
        view = ((500, 500), 40 * seed, 1.0)
        if kind == "photos":
            images = [photo_features(cut(scene(number), *view)) for number in (10 + seed, 30 + seed)]
        else:
            images = [label_features(cut(class_map(number), *view, nearest=True)) for number in (10 + seed, 30 + seed)]
        motion = motion_between(*images)
        assert motion.link is None and motion.reason is not None


def test_a_mirrored_image_has_no_link():
    picture = cut(scene(1), *VIEWS[0][0])
    assert motion_between(photo_features(picture), photo_features(picture[:, ::-1].copy())).link is None


@pytest.mark.parametrize("shape", [(1, 1), (5, 300), (200, 200)])
def test_an_image_without_texture_has_no_link(shape):
    blank = photo_features(np.full(shape, 90, np.uint8))
    motion = motion_between(blank, photo_features(cut(scene(1), *VIEWS[0][0])))
    assert "has too little texture" in str(motion.reason)


def test_ground_that_an_image_does_not_show_is_left_out():
    first, second = VIEWS[0]
    earlier, later = cut(scene(1), *first), cut(scene(1), *second)
    has_data = np.ones(earlier.shape, bool)
    has_data[:, 260:] = False
    whole = motion_between(photo_features(earlier), photo_features(later))
    masked = np.where(has_data, earlier, 0).astype(np.uint8)
    part = motion_between(photo_features(masked, has_data), photo_features(later))
    assert part.link.translation == pytest.approx(whole.link.translation, abs=0.1)


def test_the_spread_includes_an_unknown_tilt():
    """The spread is along the motion and in scale together, and small across it."""

    def known(shift):
        views = ((500, 500), 0, 1.0), ((500 + shift, 500), 0, 1.0)
        return np.array(motion_between(*(photo_features(cut(scene(1), *view)) for view in views)).link.covariance)

    near, far = (np.sqrt(np.diag(known(shift))) for shift in (20, 160))
    assert far[0] > 6 * near[0] and far[0] > 4 * far[1]
    assert far[[0, 2, 3]] == pytest.approx([EDGE * 0.0165 / 4, 0.0165 / 4, 1.5 * 0.0165 / 2], rel=0.1)
    assert known(160)[0, 3] > 0.9 * far[0] * far[3]


@pytest.mark.parametrize("direction", [0, 60, 200])
def test_the_spread_covers_tilted_views(direction):
    """Pixels of a level second image, placed in a first image that was tilted by 2°."""
    tilted = View(0, 0, 20, 1.0, 512, 512, tilt_deg=2.0, tilt_direction_deg=direction)
    level = View(180, 100, 50, 1.05, 512, 512)
    at_first = np.array(np.meshgrid(np.arange(16.0, 512, 32), np.arange(16.0, 512, 32))).reshape(2, -1).T
    at_second = image_coordinates(level, np.column_stack(map_coordinates(tilted, *at_first.T)))
    is_shared = ((at_second > 0) & (at_second < 512)).all(axis=1)
    pose, _ = fit_mapping(at_second[is_shared] - 256, at_first[is_shared] - 256, 2.5).pose()
    apart = complex(180, 100) * np.exp(1j * np.radians(20))
    off = pose - [apart.real, -apart.imag, np.radians(30), np.log(1.05)]
    spread = unmeasured_covariance(np.array([apart.real, -apart.imag]), 512, 1.0) + np.diag([0.2, 0.2, 1e-3, 1e-3]) ** 2
    assert off @ np.linalg.solve(spread, off) < 16


def test_evidence_is_what_speaks_against_chance():
    assert evidence(0, 50) == evidence(1, 50) == 0
    assert evidence(7, 7) == pytest.approx(-7 * np.log(CHANCE))
    assert evidence(10, 100) < LEAST_EVIDENCE < evidence(14, 100)


def test_links_lead_over_a_blurred_image_but_not_over_other_ground():
    here = [cut(scene(1), (500 + 40 * step, 500), 0, 1.0) for step in range(3)]
    images = [here[0], cv2.GaussianBlur(here[1], (0, 0), 30), here[2], cut(scene(2), (500, 500), 0, 1.0), here[0]]
    links = PixelLinks()
    is_apart = [links.add(photo_features(image)) for image in images]
    assert [(link.first, link.second) for link in links.links] == [(0, 2)]
    assert not is_apart[0] and not is_apart[2] and is_apart[3:] == [True, True]
    assert [number for number, _ in links.unlinked] == [1, 2, 3, 4]
