"""Sentences about the camera of an image: what was read, and whether the image was leveled."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..translation import tr
from .numbers import LocalTemplate

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera


def camera_read(camera: Camera, shape_hw: tuple[int, int]) -> str:
    """Return the known camera data in one line; empty if nothing is known."""
    known = camera.lens is not None and camera.lens.fits(shape_hw)
    attitude, distortion = camera.attitude, camera.distortion if known else None
    shift = None if distortion is None else 100 * distortion.shift(shape_hw[0] / shape_hw[1])
    parts = (
        (camera.focal_length_px(shape_hw) if known else None, tr("focal length {value:.0f} px")),
        (camera.height and camera.height.meters, tr("height {value:.1f} m")),
        (camera.heading_deg, tr("heading {value:.1f}°")),
        (attitude and attitude.roll_deg, tr("roll {value:.1f}°")),
        (attitude and attitude.pitch_deg, tr("pitch {value:.1f}°")),
        (shift, tr("lens distortion up to {value:.1f} % of the width corrected")),
    )
    return ", ".join(LocalTemplate(text).format(value=_tenths(value)) for value, text in parts if value is not None)


def camera_remark(camera: Camera, shape_hw: tuple[int, int]) -> str:
    """Return a sentence about the leveling of an image of this shape; empty if its attitude is unknown."""
    if camera.attitude is None:
        return ""
    if camera.lens is None:
        return tr("Not leveled, because {source} contains no focal length.").format(source=camera.source)
    if not camera.lens.fits(shape_hw):
        text = tr("Not leveled, because the image does not have the shape that {source} gives.")
        return text.format(source=camera.source)
    text = tr("Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).")
    roll, pitch = (_tenths(angle) for angle in (camera.attitude.roll_deg, camera.attitude.pitch_deg))
    return text.format(roll=roll, pitch=pitch, source=camera.source)


def _tenths(value: float) -> float:
    """Round to a tenth, without −0."""
    return round(value, 1) + 0.0
