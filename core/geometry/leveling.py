"""Leveling: from roll, pitch and focal length to the image that a level camera would have taken.

Conventions. The camera's frame is (right, top, axis): right and top of its image, and the optical axis. Roll and pitch
of 0 look straight down. Pitch > 0 tilts the axis towards the image's top, then roll > 0 towards its right, so that
straight down is (−sin roll · cos pitch, −sin pitch, cos roll · cos pitch) in that frame. The heading is not needed.
The ground is assumed to be level, and the lens to be free of distortion with its axis at the image's center, unless its
calibration is given.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from .. import limits
from ..errors import LabelMapError, ParameterError
from .lens_distortion import LensDistortion, border

STEEPEST_VIEW_DEG = 75.0
"""Largest angle of a corner of the image from straight down. There the same solid angle covers 1/cos³ 75° = 58 times
the ground that it covers straight below; 90° is the horizon. A tilt of 35° at a field of view of 60° reaches it."""

STRIP_ROWS = 256
"""Rows of a level image that are resampled at a time if the lens has distortion."""

DIAGONAL_OF_35MM_FILM = float(np.hypot(36, 24))
"""Diagonal of a 36 × 24 mm picture: a “focal length in 35 mm film” keeps the angle across it (CIPA DCG-001)."""


@dataclass(frozen=True)
class Attitude:
    """Attitude of a camera, in the conventions of this module.

    Attributes:
        roll_deg: Below 90° to either side.
        pitch_deg: Below 90° to either side.

    Raises:
        ParameterError: The camera does not look at the ground.
    """

    roll_deg: float
    pitch_deg: float

    def __post_init__(self) -> None:
        """Refuse angles of 90° and more."""
        for name, value in (("roll", self.roll_deg), ("pitch", self.pitch_deg)):
            if not abs(value) < 90:
                raise ParameterError(
                    "A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.",
                    name=name,
                    value=value,
                )

    @property
    def down(self) -> np.ndarray:
        """(3,) unit vector straight down in the camera's frame (right, top, axis)."""
        roll, pitch = np.radians((self.roll_deg, self.pitch_deg))
        return np.array([-np.sin(roll) * np.cos(pitch), -np.sin(pitch), np.cos(roll) * np.cos(pitch)])


def attitude_from_gimbal(roll_deg: float, pitch_deg: float) -> Attitude:
    """Return the attitude of a camera on a gimbal that pitches first and rolls second, as DJI's do.

    Args:
        roll_deg: About the optical axis, clockwise seen from behind the camera.
        pitch_deg: −90° is straight down, 0° the horizon.

    Raises:
        ParameterError: The camera looks at the horizon or above it.
    """
    roll, pitch = np.radians((roll_deg, pitch_deg))
    right, top, axis = np.sin(roll) * np.cos(pitch), -np.cos(roll) * np.cos(pitch), -np.sin(pitch)
    if axis <= 0:
        raise ParameterError(
            "A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.", pitch_deg=pitch_deg
        )
    return Attitude(float(np.degrees(np.arctan2(-right, axis))), float(np.degrees(np.arcsin(-top))))


def focal_length_from_35mm(focal_length_mm: float, shape_hw: tuple[int, int]) -> float:
    """Return the focal length in pixels from the “focal length in 35 mm film”, which keeps the diagonal angle.

    Args:
        focal_length_mm: On 35 mm film.
        shape_hw: (height, width) of the image, pixels.
    """
    return focal_length_mm / DIAGONAL_OF_35MM_FILM * float(np.hypot(*shape_hw))


def focal_length_from_view(field_of_view_deg: float, shape_hw: tuple[int, int]) -> float:
    """Return the focal length in pixels from the field of view.

    Args:
        field_of_view_deg: Across the image's width.
        shape_hw: (height, width) of the image, pixels.
    """
    return shape_hw[1] / 2 / float(np.tan(np.radians(field_of_view_deg) / 2))


@dataclass(frozen=True)
class Leveling:
    """Transformation between an image and the image of a level camera at the same place.

    A pixel at the image's center covers the same ground in both. Offsets are complex numbers in pixels of the level
    image, x right, y up, from the ground at the image's center.

    Attributes:
        homography: (3, 3) from pixel coordinates (column, row) of the image to those of the level one.
        shape_hw: (height, width) of the level image, the smallest that contains all the ground seen.
        middle: Offset of the level image's middle.
        corners: (4,) offsets of the image's corners, upper left first, clockwise.
        nadir: Offset of the ground straight below the camera; None if its attitude is unknown.
        bent: The image with its lens distortion; None without one. ``homography`` then starts from undistorted pixels.
    """

    homography: np.ndarray
    shape_hw: tuple[int, int]
    middle: complex
    corners: np.ndarray
    nadir: complex | None
    bent: BentImage | None = None

    @property
    def view(self) -> np.ndarray:
        """(4,) complex corners of what the level image shows, pixels from its middle, clockwise."""
        return self.corners - self.middle

    def level(self, labels_hw: np.ndarray) -> np.ndarray:
        """Return labels as a level camera sees them, by nearest neighbor.

        Args:
            labels_hw: (H, W) uint8 labels of the image.

        Returns:
            Uint8 labels of shape ``shape_hw``; 0 is unseen ground.
        """
        return self._warped([labels_hw], self.shape_hw, (np.ones(2), np.ones(2)), cv2.INTER_NEAREST)[0]

    def level_planes(self, planes_hwk: np.ndarray, image_shape_hw: tuple[int, int]) -> np.ndarray:
        """Return planes on a grid over an image as a level camera sees them, by linear interpolation.

        Args:
            planes_hwk: (h, w, K) uint8; pixels of the grid may be larger than the image's.
            image_shape_hw: (height, width) of the image that they cover.

        Returns:
            (h', w', K) uint8 over the level image, with the pixel size at the image's center; 0 is unseen ground.
        """
        grid = np.array(planes_hwk.shape[1::-1], float)
        pixel = np.array(image_shape_hw[::-1]) / grid
        size = np.maximum(np.rint(np.array(self.shape_hw[::-1]) / pixel), 1).astype(int)
        level_pixel = np.array(self.shape_hw[::-1]) / size
        to = int(size[1]), int(size[0])
        split = [np.ascontiguousarray(plane) for plane in np.moveaxis(planes_hwk, 2, 0)]
        planes = self._warped(split, to, (pixel, level_pixel), cv2.INTER_LINEAR)
        return np.stack(planes, axis=2) if planes else np.zeros((*to, 0), np.uint8)

    def in_image(self, pixels_xy: np.ndarray) -> np.ndarray:
        """Return (n, 2) pixel coordinates of the image for (n, 2) ones of the level image."""
        straight = self._straight(pixels_xy)
        return straight if self.bent is None else self.bent.seen(straight)

    def _warped(
        self, planes: Sequence[np.ndarray], shape_hw: tuple[int, int], pixels: tuple[np.ndarray, np.ndarray], how: int
    ) -> list[np.ndarray]:
        """Return planes over the image as a level camera sees them.

        Args:
            planes: (h, w) each; pixels may be larger than the image's own.
            shape_hw: (height, width) of the result.
            pixels: (2,) width and height of a pixel of ``planes``, in pixels of the image, and of a pixel of the
                result, in pixels of the level image.
            how: OpenCV's interpolation flag.
        """
        if self.bent is not None:
            return self._unbent(planes, self.bent, shape_hw, pixels, how)
        # OpenCV counts from the center of the first pixel.
        shift = np.array([[1, 0, 0.5], [0, 1, 0.5], [0, 0, 1]])
        to_level = np.diag([*1 / pixels[1], 1]) @ self.homography @ np.diag([*pixels[0], 1])
        matrix = np.linalg.inv(shift) @ to_level @ shift
        return [cv2.warpPerspective(plane, matrix, shape_hw[::-1], flags=how) for plane in planes]

    def _unbent(
        self,
        planes: Sequence[np.ndarray],
        bent: BentImage,
        shape_hw: tuple[int, int],
        pixels: tuple[np.ndarray, np.ndarray],
        how: int,
    ) -> list[np.ndarray]:
        """Warp as ``_warped`` with lens distortion: strip by strip, one lookup table for all planes."""
        height, width = shape_hw
        found = [np.zeros(shape_hw, plane.dtype) for plane in planes]
        for first in range(0, height, STRIP_ROWS):
            rows, columns = np.mgrid[first : min(first + STRIP_ROWS, height), 0:width]
            straight = self._straight((np.column_stack([columns.ravel(), rows.ravel()]) + 0.5) * pixels[1])
            # OpenCV counts from the center of the first pixel.
            seen = (bent.seen(straight) / pixels[0] - 0.5).astype(np.float32)
            # Beyond the edge of the image the formula of the lens may return to positions inside it.
            seen[~bent.holds(straight)] = -2
            for plane, level in zip(planes, found):
                level[first : first + STRIP_ROWS] = cv2.remap(plane, seen.reshape(*rows.shape, 2), None, how)
        return found

    def _straight(self, pixels_xy: np.ndarray) -> np.ndarray:
        rays = np.column_stack([pixels_xy, np.ones(len(pixels_xy))]) @ np.linalg.inv(self.homography).T
        return rays[:, :2] / rays[:, 2:]


@dataclass(frozen=True)
class BentImage:
    """An image with lens distortion, and its undistorted pixels.

    Attributes:
        shape_hw: (height, width) of the image.
        focal_length_px: Of the undistorted image.
    """

    lens: LensDistortion
    shape_hw: tuple[int, int]
    focal_length_px: float

    def seen(self, straight_xy: np.ndarray) -> np.ndarray:
        """Return (n, 2) pixel coordinates of the image for (n, 2) undistorted ones."""
        width = self.shape_hw[1]
        return self._middle + width * self.lens.seen((straight_xy - self._middle) / self.focal_length_px)

    def straight(self, seen_xy: np.ndarray) -> np.ndarray:
        """Return (n, 2) undistorted pixel coordinates for (n, 2) ones of the image."""
        rays = self.lens.rays((seen_xy - self._middle) / self.shape_hw[1])
        return self._middle + self.focal_length_px * rays

    def holds(self, straight_xy: np.ndarray) -> np.ndarray:
        """Return (n,) bool: which undistorted pixels are within the image's largest distance from the center."""
        reach = np.hypot(*(self.border - self._middle).T).max() + 1
        return np.hypot(*(straight_xy - self._middle).T) <= reach

    @property
    def border(self) -> np.ndarray:
        """(n, 2) undistorted pixel coordinates around the image."""
        height, width = self.shape_hw
        return self.straight(self._middle + width * border(height / width))

    @property
    def _middle(self) -> np.ndarray:
        height, width = self.shape_hw
        return np.array([width / 2, height / 2])


def leveling(
    attitude: Attitude, focal_length_px: float, shape_hw: tuple[int, int], lens: LensDistortion | None = None
) -> Leveling:
    """Return the leveling of an image.

    Args:
        focal_length_px: Of the camera, pixels of the image.
        shape_hw: (height, width) of the image, pixels.
        lens: Its calibration; None for a lens without distortion.

    Raises:
        ParameterError: The focal length is out of range, or the view comes too near the horizon.
        LabelMapError: The image is empty or too large to warp.
    """
    height, width = shape_hw
    if not 0 < focal_length_px <= limits.FOCAL_LENGTH_PX:
        raise ParameterError(
            "The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.",
            focal_length_px=focal_length_px,
            most=limits.FOCAL_LENGTH_PX,
        )
    if not height or not width:
        raise LabelMapError("The image has no pixels.")
    bent = None if lens is None else BentImage(lens, shape_hw, focal_length_px)
    corners_xy = around_xy = np.array([(0, 0), (width, 0), (width, height), (0, height)], float)
    if bent is not None:
        corners_xy, around_xy = bent.straight(corners_xy), bent.border
    rays, around = (_rays(points, shape_hw, focal_length_px) for points in (corners_xy, around_xy))
    depths = around @ attitude.down
    steepest = float(np.degrees(np.arccos(np.clip(depths / np.linalg.norm(around, axis=1), -1, 1)).max()))
    if steepest > STEEPEST_VIEW_DEG:
        raise ParameterError(
            "With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from "
            "straight down; at most {most_deg:g}° is possible. Use images that look down more steeply.",
            roll_deg=attitude.roll_deg,
            pitch_deg=attitude.pitch_deg,
            steepest=steepest,
            most_deg=STEEPEST_VIEW_DEG,
        )
    to_ground = _ground_matrix(attitude.down, focal_length_px)
    corners = _complex(to_ground, rays)
    ground = _complex(to_ground, around)
    left, bottom = np.floor((ground.real.min(), ground.imag.min()))
    right, top = np.ceil((ground.real.max(), ground.imag.max()))
    size = int(top - bottom), int(right - left)
    if max(*size, *shape_hw) > limits.WARPED_EDGE_PX:
        raise LabelMapError(
            "The image has {width} × {height} pixels, and {level_width} × {level_height} after leveling. An edge may "
            "have at most {most} pixels; reduce the image first.",
            width=width,
            height=height,
            level_width=size[1],
            level_height=size[0],
            most=limits.WARPED_EDGE_PX,
        )
    from_pixels = np.array([[1, 0, -width / 2], [0, -1, height / 2], [0, 0, focal_length_px]])
    to_pixels = np.array([[1, 0, -left], [0, -1, top], [0, 0, 1]])
    nadir = complex(_complex(to_ground, attitude.down))
    homography = to_pixels @ to_ground @ from_pixels
    return Leveling(homography, size, complex(left + right, bottom + top) / 2, corners, nadir, bent)


def _rays(pixels_xy: np.ndarray, shape_hw: tuple[int, int], focal_length_px: float) -> np.ndarray:
    """Return (n, 3) rays in the camera's frame of (n, 2) pixels of an image without distortion."""
    height, width = shape_hw
    x, y = pixels_xy.T
    return np.column_stack([x - width / 2, height / 2 - y, np.full(len(pixels_xy), focal_length_px)])


def _ground_matrix(down: np.ndarray, focal_length_px: float) -> np.ndarray:
    """Return (3, 3) from camera rays to homogeneous ground offsets from the point that the optical axis meets.

    The level frame is the camera's, rotated by the smallest angle until its axis points straight down. The scale is
    such that a pixel at the center covers a ground area of 1: at height h it covers h² / (f² cos³ tilt).
    """
    cosine = down[2]
    # The rotation axis is perpendicular to the optical axis, (0, 0, 1), and to ``down``.
    across = np.array([-down[1], down[0], 0.0])
    sine = np.hypot(*down[:2])
    turn = across * (np.arctan2(sine, cosine) / sine if sine else 0.0)
    frame = cv2.Rodrigues(turn)[0].T
    height = focal_length_px * cosine**1.5
    right, top = (height * (frame[k] - frame[k, 2] / cosine * down) for k in (0, 1))
    return np.array([right, top, down])


def _complex(matrix: np.ndarray, rays: np.ndarray) -> np.ndarray:
    """Return (…,) complex points of homogeneous coordinates after a matrix."""
    x, y, w = matrix @ rays.T
    return (x + 1j * y) / w
