"""Noise settings: impossible values are refused, and lengths are converted to pixels."""

import math

import pytest

from semref.core.errors import ParameterError
from semref.core.simulation.noise import USUAL, LabelNoise


@pytest.mark.parametrize("wrong", [{"jitter": -1.0}, {"leaning": 1.5}, {"missed": math.nan}, {"jitter": math.inf}])
def test_impossible_noise_is_refused_by_name(wrong):
    with pytest.raises(ParameterError, match=next(iter(wrong))):
        LabelNoise(**wrong)


def test_lengths_and_areas_are_converted_to_pixels():
    noise = LabelNoise(missed=0.2, jitter=3.0, jitter_length=9.0, missed_below=200.0).in_pixels(0.5)
    assert (noise.missed, noise.jitter, noise.jitter_length) == (0.2, 6.0, 18.0)
    assert noise.missed_below == 800.0
    assert USUAL.in_pixels(0.5).jitter_length is None and USUAL.in_pixels(0.5).missed_below == math.inf


def test_shared_errors_are_converted_to_pixels_too():
    noise = LabelNoise(displaced=1.0, displaced_kernels=((10.0, 1.0),), class_shifts=((3, 1.0, -2.0),)).in_pixels(0.5)
    assert (noise.displaced, noise.displaced_kernels, noise.class_shifts) == (2.0, ((20.0, 1.0),), ((3, 2.0, -4.0),))
