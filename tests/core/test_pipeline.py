from dataclasses import replace

import numpy as np
import pytest

from semref.core.geometry.camera import Camera, Lens
from semref.core.geometry.error_settings import KnownBiases
from semref.core.geometry.leveling import Attitude
from semref.core.labels.class_shares import SeenLabels
from semref.core.localization import Localization, Matches, Method, Place, Prior, Status
from semref.core.localizer.combined import show_likely
from semref.core.localizer.search import Search
from semref.core.pipeline import Pipeline, localize_labels
from semref.core.sentences import Sentence

LABELS = np.zeros((40, 60), np.uint8)
FIX = Localization(Status.FIX, Method.CONSTELLATION, best=Place((1.0, 2.0), heading_deg=30.0, pixel_size_m=0.5))


class Localizer:
    landmark_classes = ("building",)

    def __init__(self):
        self.asked, self.view = [], None

    def with_view(self, view):
        self.view = view
        return self

    def pixel_sizes(self, shape_hw, scales):
        return tuple(scale * 100 / min(shape_hw) for scale in scales)

    def localize(self, labels_hw, method, prior, with_matches, shares, biases, earlier=None):
        self.asked.append((labels_hw.shape, method, prior, with_matches, shares, biases))
        reason = Sentence("No place on the map has triangles of landmarks like the image's.")
        return Localization(Status.NO_MATCH, method, reason=reason)


def test_scales_become_pixel_sizes_of_the_image_s_shorter_edge():
    localizer = Localizer()
    search = Search(Method.CONSTELLATION, Prior((1.0, 2.0), 30.0), (0.5, 2.0), True)
    seen = SeenLabels(LABELS, biases=KnownBiases(class_spread=0.5))
    result = localize_labels(localizer, search, seen, Camera())
    shape, method, prior, with_matches, shares, biases = localizer.asked[0]
    assert (shape, method, with_matches, shares) == ((40, 60), Method.CONSTELLATION, True, None)
    assert biases.class_spread == 0.5 and result.shape_hw == (40, 60) and result.prior == prior
    assert prior == Prior((1.0, 2.0), 30.0, pixel_size_range=(1.25, 5.0))


def test_camera_data_count_if_no_value_is_given():
    camera = Camera(heading_deg=70.0)
    assert Search(Method.CONSTELLATION).prior_of(Localizer(), camera, (40, 60)).heading_deg == 70.0
    told = Search(Method.CONSTELLATION, Prior(heading_deg=10.0))
    assert told.prior_of(Localizer(), camera, (40, 60)).heading_deg == 10.0


def test_a_tilted_image_is_leveled_first():
    localizer, camera = Localizer(), Camera(Attitude(10.0, 5.0), Lens("field_of_view", 60.0))
    result = localize_labels(localizer, Search(Method.CONSTELLATION), SeenLabels(LABELS), camera)
    height, width = result.seen.labels_hw.shape
    assert localizer.asked[0][0] == (height, width) != LABELS.shape == result.shape_hw
    # What the photo shows of the leveled image reaches its four sides.
    assert np.allclose([localizer.view.real.max(), -localizer.view.real.min()], width / 2, atol=1)
    assert np.allclose([localizer.view.imag.max(), -localizer.view.imag.min()], height / 2, atol=1)


def test_a_photo_that_is_not_found_names_its_network():
    seen = SeenLabels(LABELS, None, ("Banepa",))
    pipeline = Pipeline(Localizer(), Search(Method.CONSTELLATION), lambda path, camera, with_pixels: seen)
    assert "trained on" in str(pipeline.run("a.jpg", Camera()).localization.reason)


def test_a_fix_has_the_position_of_the_image_and_its_orientation_if_both_parts_are_known():
    assert (FIX.is_fix, FIX.position, FIX.heading_deg, FIX.pixel_size_m) == (True, (1.0, 2.0), 30.0, 0.5)
    assert Place((0.0, 0.0), 30.0, 0.5).oriented == (30.0, 0.5)
    for place in (Place((0.0, 0.0), heading_deg=30.0), Place((0.0, 0.0), pixel_size_m=0.5)):
        with pytest.raises(ValueError, match="no heading and pixel size"):
            _ = place.oriented


@pytest.mark.parametrize("status", [status for status in Status if status not in (Status.FIX, Status.LIKELY)])
def test_the_best_place_is_kept_without_a_fix_but_is_no_position(status):
    found = replace(FIX, status=status)
    assert found.best == FIX.best
    assert (found.is_fix, found.place, found.position, found.heading_deg, found.pixel_size_m) == (False, *[None] * 4)


def test_methods_and_states_are_their_keys_and_methods_keep_their_numbers():
    assert [f"{method}" for method in Method] == ["automatic", "topology vector", "constellation", "map correlation"]
    assert [method.number for method in Method] == [0, 1, 2, 3]
    assert Status("no_match") is Status.NO_MATCH == "no_match"


def test_what_explains_a_result_is_no_part_of_a_comparison():
    matches = Matches(np.arange(3), np.zeros((3, 2)), np.zeros((3, 2)), np.zeros(3))
    explained = replace(FIX, matches=matches, footprint=np.zeros((4, 2)))
    assert (len(matches), explained == FIX) == (3, True)
    assert replace(FIX, references=1) != FIX


@pytest.mark.parametrize(("risk", "expected"), [(0.19, Status.LIKELY), (0.21, Status.NO_MATCH)])
def test_a_doubted_candidate_is_a_likely_position_up_to_a_fifth(risk: float, expected: Status) -> None:
    doubted = Localization(Status.NO_MATCH, Method.CONSTELLATION, best=Place((1.0, 2.0)), risk=risk, is_doubted=True)
    found = show_likely(doubted)
    assert found.status is expected
    assert (found.position == (1.0, 2.0)) == found.is_likely
    assert found.fix is None


def test_an_inaccurate_candidate_is_no_likely_position() -> None:
    flawed = Localization(Status.AMBIGUOUS, Method.CONSTELLATION, best=Place((1.0, 2.0)), risk=0.01)
    assert show_likely(flawed) == flawed


class Photographed:
    """Reader of a photo that is found only from its second labels, and of one that is found at once."""

    def __init__(self):
        self.looks = 0

    def __call__(self, path, camera, with_pixels):
        return SeenLabels(LABELS + (path == "found.jpg"), look_again=self.again)

    def again(self):
        self.looks += 1
        return SeenLabels(LABELS + 1)


class Finder(Localizer):
    """Localizer that finds labels of 1."""

    def localize(self, labels_hw, method, *known):
        self.earlier = known[-1]
        return FIX if labels_hw.all() else super().localize(labels_hw, method, *known)


@pytest.mark.parametrize(
    ("name", "method", "looks"),
    [
        ("found.jpg", Method.AUTOMATIC, 0),
        ("other.jpg", Method.AUTOMATIC, 1),
        # The published method takes the network's labels as they are.
        ("other.jpg", Method.TOPOLOGY_VECTOR, 0),
    ],
)
def test_a_photo_without_a_position_is_labeled_again(name, method, looks):
    reader = Photographed()
    finder = Finder()
    result = Pipeline(finder, Search(method), reader).run(name, Camera())
    assert reader.looks == looks
    # The second look knows the result of the first.
    assert (finder.earlier is not None) == (looks == 1)
    assert result.localization.is_fix == bool(result.labels_hw.all()) == (method is Method.AUTOMATIC)
    # The photo itself is not kept.
    assert result.seen.look_again is None


def test_images_of_a_flight_are_labeled_once():
    reader = Photographed()
    result = Pipeline(Finder(), Search(Method.AUTOMATIC), reader, looks_again=False).run("other.jpg", Camera())
    assert (reader.looks, result.localization.is_fix, result.seen.look_again) == (0, False, None)
