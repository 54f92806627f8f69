"""What log and dock say about an image's camera: what was read of it, and what was done with that."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..translation import tr

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera


def camera_read(camera: Camera, shape_hw: tuple[int, int]) -> str:
    """What is known of an image's camera, in one line; empty when nothing is."""
    known = camera.lens is not None and camera.lens.fits(shape_hw)
    attitude = camera.attitude
    parts = (
        (camera.focal_length_px(shape_hw) if known else None, tr("focal length {value:.0f} px")),
        (camera.height and camera.height.meters, tr("height {value:.1f} m")),
        (camera.heading_deg, tr("yaw {value:.1f}°")),
        (attitude and attitude.roll_deg, tr("roll {value:.1f}°")),
        (attitude and attitude.pitch_deg, tr("pitch {value:.1f}°")),
        (_most_shift(camera, shape_hw) if known else None, tr("lens straightened by up to {value:.1f} % of the width")),
    )
    return ", ".join(text.format(value=_tenths(value)) for value, text in parts if value is not None)


def _most_shift(camera: Camera, shape_hw: tuple[int, int]) -> float | None:
    """Percent of the width; None where no lens is known to bend."""
    return None if camera.distortion is None else 100 * camera.distortion.shift(shape_hw[0] / shape_hw[1])


def camera_remark(camera: Camera, shape_hw: tuple[int, int]) -> str:
    """Says whether an image of this shape is leveled; empty when nothing is known of its attitude."""
    if camera.attitude is None:
        return ""
    if camera.lens is None:
        return tr("{source} tells no focal length, so the image is taken as it is.").format(source=camera.source)
    if not camera.lens.fits(shape_hw):
        text = tr("The shape is not that of {source}, so the image is taken as it is.")
        return text.format(source=camera.source)
    text = tr("Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).")
    roll, pitch = (_tenths(angle) for angle in (camera.attitude.roll_deg, camera.attitude.pitch_deg))
    return text.format(roll=roll, pitch=pitch, source=camera.source)


def _tenths(value: float) -> float:
    """To a tenth, and never −0."""
    return round(value, 1) + 0.0
