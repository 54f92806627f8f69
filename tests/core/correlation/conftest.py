"""A made map of patches, and images cut from it."""

import cv2
import made_labels
import numpy as np
import pytest
from made_patches import FRAME, made_map

from semref.core.correlation.class_pyramid import MapPyramid, evidence_level
from semref.core.geometry.frame import MapFrame
from semref.core.labels.overview import most_frequent_labels


@pytest.fixture(scope="package")
def patches():
    """Return (300, 360) uint8 patches of classes 1 to 5; pixels are 4 m."""
    return made_labels.patches(21, (300, 360), 400)


@pytest.fixture(scope="package")
def patch_pyramid(patches):
    return MapPyramid(patches, MapFrame.at((500_000.0, 5_200_000.0), 4.0))


@pytest.fixture(scope="package")
def labels():
    return made_map(1)


@pytest.fixture(scope="package")
def pyramid(labels):
    return MapPyramid(most_frequent_labels(labels), FRAME)


@pytest.fixture(scope="package")
def image_at(patches, patch_pyramid):
    """Return edge × edge pixels of evidence of an image 500 pixels wide; places are meters from the corner."""

    def at(x, y, heading_deg, pixel_m, edge=64):
        turn = np.radians(heading_deg)
        matrix = pixel_m / 4 * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        offset = np.array([x, y]) / 4 - 0.5 - matrix @ np.array([249.5, 249.5])
        flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
        labels = cv2.warpAffine(patches, np.column_stack([matrix, offset]), (500, 500), flags=flags)
        return evidence_level(labels, patch_pyramid.space, (edge, edge))

    return at
