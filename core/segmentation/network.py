"""A network from an ONNX file, as it runs: device, size of its images, and its output."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from threading import Semaphore

import cv2
import numpy as np

from .. import limits
from ..errors import ModelError
from ..sentences import Sentence
from .certainty import are_probabilities
from .devices import AUTO, CPU, Device, device_of, devices_to_try
from .metadata import read_settings
from .session import available_providers, failures_of_a_run, open_session, reason_of

DEFAULT_TILE_SIZE_PX = 512
"""Default edge of a tile for networks of variable size that do not state one."""

TILES_AT_ONCE = 4
"""Tiles that a graphics card processes together, if the network accepts several; the CPU gains nothing by it."""

RUNS_AT_ONCE = 2
"""Runs of the network at a time on a CPU: two runs with half the threads each wait less for one another than one run
with all; each needs memory for its own intermediate results."""

_FLOATS = {"tensor(float)": np.float32, "tensor(float16)": np.float16}
_BANDS = 3


class OnnxNetwork:
    """A network from an ONNX file: images → its output. The names of its classes may be missing.

    Attributes:
        tile_hw: (height, width) of the images it accepts.
        tiles_at_once: Best number of images for one call.
        runs_at_once: Number of runs at a time; more threads wait, also those of other images.
        fallbacks: Why other devices that were requested or tried do not.
        notes: Sentences on metadata that were overruled.
        texts: Its metadata by key.
        output_axes: Number of axes of its output, 3 or 4.
        channels: Number of pictures in its output; 1 for the probability of one class, or class numbers.
        gives_integers: Whether the output is class numbers by its type.
        sums_to_one: Whether its outputs for a black image are probabilities of several classes.
    """

    def __init__(self, path: str, threads: int, device: str = AUTO) -> None:
        """Open the network.

        Raises:
            ModelError: onnxruntime is missing, or the file or its metadata can't be used.
        """
        self.path = path
        self.texts, outputs = self._start(threads, device)
        self.output_axes = outputs.ndim
        self.channels = 1 if outputs.ndim == 3 else outputs.shape[1]
        self.gives_integers = outputs.dtype.kind in "iu"
        self.sums_to_one = outputs.ndim == 4 and are_probabilities(outputs)

    @property
    def is_single(self) -> bool:
        """Whether the output is one picture."""
        return self.channels == 1

    def run(self, images: Sequence[np.ndarray]) -> np.ndarray:
        """Return the output for N (H, W, 3) uint8 images, red first, H × W = ``tile_hw``. Raises ModelError."""
        try:
            planes = self._planes(images)
            with self._free:
                found = self._session.run(None, {self._name: planes})[0]
        except failures_of_a_run() as error:
            height, width = self.tile_hw
            raise ModelError(
                "{path} fails on an image of {width} × {height} pixels: {reason}.",
                path=self.path,
                width=width,
                height=height,
                reason=reason_of(error),
            ) from error
        if not isinstance(found, np.ndarray) or found.dtype.kind not in "fiub":
            kind = found.dtype.name if isinstance(found, np.ndarray) else type(found).__name__
            raise ModelError(
                "{path} outputs {kind}; a segmentation network outputs one array of numbers.", path=self.path, kind=kind
            )
        return found

    def _start(self, threads: int, asked: str) -> tuple[Mapping[str, str], np.ndarray]:
        """Open the network on the first device that runs it; return its metadata and its output for a black image."""
        devices, chosen = devices_to_try(asked, available_providers()), device_of(asked)
        reasons: dict[Device, object] = {}
        for device in devices[:-1]:
            try:
                found = self._open(device, threads)
                break
            except ModelError as error:
                reasons[device] = dict(error.sentence.values).get("reason", error.sentence)
        else:
            found = self._open(devices[-1], threads)
        other = self.device.title
        self.fallbacks = [
            Sentence(
                "{device} could not be started ({reason}); the network runs on {other}.",
                device=device.title,
                reason=reason,
                other=other,
            )
            for device, reason in reasons.items()
        ]
        if chosen is not None and chosen not in devices:
            missing = Sentence(
                "{device} is selected, but this onnxruntime does not support it; the Python package {package} does. "
                "The network runs on {other}.",
                device=chosen.title,
                package=chosen.package,
                other=other,
            )
            self.fallbacks.append(missing)
        return found

    def _open(self, device: Device, threads: int) -> tuple[Mapping[str, str], np.ndarray]:
        """Open the network on a device; return its metadata and its output for a black image. Raises ModelError."""
        self.device = device
        self.notes: list[Sentence] = []
        self.runs_at_once = min(RUNS_AT_ONCE, threads) if device is CPU else 1
        self._free = Semaphore(self.runs_at_once)
        self._session = open_session(self.path, -(-threads // self.runs_at_once), device.provider)
        try:
            texts = self._session.get_modelmeta().custom_metadata_map
            self.settings = read_settings(texts, self.path)
            self._read_input()
        except UnicodeDecodeError:
            raise ModelError(
                "{path} has names or metadata that are not UTF-8 text; export the network again.", path=self.path
            ) from None
        mean, std = (np.array(v, np.float32) for v in (self.settings.mean, self.settings.std))
        # (pixel / 255 - mean) / std of each of the 256 pixel values, for each band.
        self._standardized = ((np.arange(256, dtype=np.float32) / 255)[None] - mean[:, None]) / std[:, None]
        return texts, self._probe()

    def _read_input(self) -> None:
        inputs = self._session.get_inputs()
        if len(inputs) != 1 or len(self._session.get_outputs()) != 1:
            raise ModelError(
                "{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.",
                path=self.path,
                inputs=len(inputs),
                outputs=len(self._session.get_outputs()),
            )
        shape = inputs[0].shape
        is_last = len(shape) == 4 and shape[1] != _BANDS and shape[3] == _BANDS
        if len(shape) != 4 or is_last or shape[1] not in (_BANDS, None) and isinstance(shape[1], int):
            raise ModelError(
                "{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).",
                path=self.path,
                shape=_shape_text(shape),
            )
        if inputs[0].type not in _FLOATS:
            raise ModelError(
                "{path} takes {kind} values; a segmentation network takes floats.", path=self.path, kind=inputs[0].type
            )
        self._name, self._type = inputs[0].name, _FLOATS[inputs[0].type]
        stated = self.settings.tile_size_px
        fixed = [size if isinstance(size, int) else stated or DEFAULT_TILE_SIZE_PX for size in shape[2:]]
        self.tile_hw = fixed[0], fixed[1]
        if stated is not None and (stated, stated) != self.tile_hw:
            self.notes.append(
                Sentence(
                    "tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels; "
                    "SemRef uses the size of the network.",
                    stated=stated,
                    width=fixed[1],
                    height=fixed[0],
                )
            )
        if not all(0 < size <= limits.TILE_PX for size in fixed):
            raise ModelError(
                "{path} takes images of {width} × {height} pixels; SemRef supports up to {most} × {most}. Export it "
                "with a smaller or variable size.",
                path=self.path,
                width=fixed[1],
                height=fixed[0],
                most=limits.TILE_PX,
            )
        fixed_batch = isinstance(shape[0], int)
        self.tiles_at_once = 1 if fixed_batch or self.device is CPU else TILES_AT_ONCE
        if fixed_batch and shape[0] != 1:
            raise ModelError(
                "{path} takes {count} images at once; export it for one (or any number).",
                path=self.path,
                count=shape[0],
            )

    def _probe(self) -> np.ndarray:
        """Return the network's output for a black image; its stated shape may lack the number of classes."""
        height, width = self.tile_hw
        outputs = self.run([np.zeros((height, width, _BANDS), np.uint8)])
        if outputs.ndim not in (3, 4) or outputs.shape != (1, *outputs.shape[1:-2], height, width):
            raise ModelError(
                "{path} outputs the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × "
                "{height} × {width}.",
                path=self.path,
                shape=_shape_text(outputs.shape),
                width=width,
                height=height,
            )
        return outputs

    def _planes(self, images: Sequence[np.ndarray]) -> np.ndarray:
        """Return (N, 3, H, W) standardized pixels, the network's input."""
        planes = np.empty((len(images), _BANDS, *self.tile_hw), self._type)
        for image, plane in zip(images, planes):
            for band, pixels in enumerate(cv2.split(image)):
                plane[band] = cv2.LUT(pixels, self._standardized[band])
        return planes


def _shape_text(shape: Sequence[object]) -> str:
    return " × ".join(str(size) if isinstance(size, int) else "any" for size in shape)
