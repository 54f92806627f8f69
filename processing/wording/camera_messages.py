"""What the log says about the attitude of an image's camera."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..translation import tr

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera


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
    return text.format(roll=camera.attitude.roll_deg, pitch=camera.attitude.pitch_deg, source=camera.source)
