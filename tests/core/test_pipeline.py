"""The pipeline passes common values and each image's camera to the localizer."""

import numpy as np

from semref.core.geometry.camera import Camera, Lens
from semref.core.geometry.error_settings import KnownBiases
from semref.core.geometry.leveling import Attitude
from semref.core.labels.class_shares import SeenLabels
from semref.core.localization import Localization, Method, Prior, Status
from semref.core.localizer.search import Search
from semref.core.pipeline import Pipeline, localize_labels
from semref.core.sentences import Sentence

LABELS = np.zeros((40, 60), np.uint8)


class Localizer:
    """Localizer that records its input."""

    landmark_classes = ("building",)

    def __init__(self):
        self.asked, self.view = [], None

    def with_view(self, view):
        self.view = view
        return self

    def pixel_sizes(self, shape_hw, scales):
        return tuple(scale * 100 / min(shape_hw) for scale in scales)

    def localize(self, labels_hw, method, prior, with_matches, shares, biases):
        self.asked.append((labels_hw.shape, method, prior, with_matches, shares, biases))
        return Localization(
            Status.NO_MATCH, method, reason=Sentence("No place on the map has triangles of landmarks like the image's.")
        )


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
