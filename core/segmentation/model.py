"""ONNX segmentation networks: the only file that uses onnxruntime."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Callable

import cv2
import numpy as np

from ..errors import ModelError
from ..labels.class_table import ClassTable
from ..sentences import Sentence
from .certainty import are_probabilities, softmax
from .class_bias import read_class_bias
from .metadata import named_channels, read_classes, read_settings
from .onnx_file import read_header, smallest_model

if TYPE_CHECKING:
    from onnxruntime import InferenceSession

PROVIDERS = (
    "CUDAExecutionProvider",
    "ROCMExecutionProvider",
    "DmlExecutionProvider",
    "CoreMLExecutionProvider",
    "CPUExecutionProvider",
)
"""What may run a network, best first; of those that onnxruntime has, it falls back on the next when one fails."""

DEFAULT_TILE_SIZE_PX = 512
"""Edge of a tile for networks that take any size and don't say which they were trained on."""

LARGEST_TILE_PX = 8192
"""Edge of a tile: its three bands as floats are 800 MB then, and the network's own results many times as much."""

TILES_AT_ONCE = 4
"""Tiles given to a graphics card together, where the network takes several; the CPU gains nothing by it."""

RUNS_AT_ONCE = 2
"""How often the network runs side by side on a CPU: two runs of half the threads each wait less for one another than
one run of all, and each that runs holds its own intermediate results in memory."""

_CPU = PROVIDERS[-1]
_IR_VERSION_OF_ALL, _OPSET_OF_ALL, _HIGHEST_ASKED = 4, 11, 100
"""Versions that every onnxruntime knows, and one that none knows."""

_FLOATS = {"tensor(float)": np.float32, "tensor(float16)": np.float16}
_BANDS = 3


class SegmentationModel:
    """A network from an ONNX file: images → scores of its classes.

    ``classes`` and ``settings``: its metadata. ``tile_hw``: (height, width) of the images it takes. ``tiles_at_once``:
    how many of them best. ``runs_at_once``: how many threads may call ``scores`` at a time with gain. ``provider``:
    what runs it. ``class_bias``: how far off it shows its classes, by name in small letters, as far as it says so.
    ``notes``: sentences on metadata that were overruled.
    """

    def __init__(self, path: str, threads: int, class_table: ClassTable | None = None) -> None:
        """``threads``: for the CPU. ``class_table``: the user's, see ``read_classes``.

        Raises ModelError when onnxruntime is missing, or the file or what it says about itself can't be used.
        """
        self.path = path
        self.notes: list[Sentence] = []
        self.runs_at_once = min(RUNS_AT_ONCE, threads) if _providers()[:1] == [_CPU] else 1
        self._session = _open(path, -(-threads // self.runs_at_once))
        self.provider = self._session.get_providers()[0]
        try:
            texts = self._session.get_modelmeta().custom_metadata_map
            self.settings = read_settings(texts, path)
            self._read_input()
        except UnicodeDecodeError:
            raise ModelError("segmentation.not_text", path=path) from None
        mean, std = (np.array(v, np.float32) for v in (self.settings.mean, self.settings.std))
        # (pixel / 255 - mean) / std of each of the 256 pixel values, for each band.
        self._standardized = ((np.arange(256, dtype=np.float32) / 255)[None] - mean[:, None]) / std[:, None]
        names = named_channels(texts, path)
        outputs = self._probe()
        single = outputs.ndim == 3 or outputs.shape[1] == 1
        self._gives_numbers = single and (outputs.dtype.kind in "iu" or (names is not None and len(names) > 2))
        self._gives_probability = single and not self._gives_numbers
        self._gives_probabilities = self._gives_numbers or not single and are_probabilities(outputs)
        channels = 2 if single else outputs.shape[1]
        if self._gives_numbers:
            channels = len(names or class_table or ())
        self.classes = read_classes(texts, channels, path, class_table)
        self.class_bias = read_class_bias(texts, self.classes.names, path)

    @property
    def temperature(self) -> float | None:
        """What ``probabilities`` divides scores by, as the model states; None without such scores."""
        return None if self._gives_probabilities or self._gives_probability else self.settings.temperature

    def scores(self, images: Sequence[np.ndarray]) -> np.ndarray:
        """(N, C, H, W) float32: for each image the score of each class; the highest is the pixel's.

        ``images``: N of (H, W, 3) uint8, red first, H × W = ``tile_hw``.
        Raises ModelError when the network fails or gives values that are no numbers.
        """
        outputs = self._run(images)
        if self._gives_numbers:
            return self._votes(outputs)
        found = outputs.astype(np.float32, copy=False)
        # Checked on the sum: any NaN or infinity is in it.
        if not np.isfinite(found.sum()):
            raise ModelError("segmentation.not_numbers", path=self.path)
        if self._gives_probability:
            found = found.reshape(len(images), 1, *self.tile_hw)
            return np.concatenate([np.full_like(found, self.settings.threshold), found], axis=1)
        return found

    def probabilities(self, scores: np.ndarray) -> np.ndarray:
        """(C, …) float32 probability of each class, of (C, …) scores or their weighted means."""
        if self._gives_probability:
            return np.stack([1 - scores[1], scores[1]])
        if self._gives_probabilities:
            return scores
        temperature = self.settings.temperature
        return softmax(scores if temperature is None else scores / np.float32(temperature))

    def _votes(self, outputs: np.ndarray) -> np.ndarray:
        """One for the class that the network names, zero for the others."""
        numbers = outputs.reshape(len(outputs), 1, *self.tile_hw)
        count = len(self.classes.names)
        if not ((numbers >= 0) & (numbers < count)).all():
            raise ModelError("segmentation.unknown_class_number", path=self.path, number=numbers.max(), count=count)
        return (numbers == np.arange(count).reshape(1, count, 1, 1)).astype(np.float32)

    def _read_input(self) -> None:
        inputs = self._session.get_inputs()
        if len(inputs) != 1 or len(self._session.get_outputs()) != 1:
            raise ModelError(
                "segmentation.inputs_outputs",
                path=self.path,
                inputs=len(inputs),
                outputs=len(self._session.get_outputs()),
            )
        shape = inputs[0].shape
        if len(shape) != 4 or shape[1] not in (_BANDS, None) and isinstance(shape[1], int):
            raise ModelError("segmentation.input_shape", path=self.path, shape=_shape_text(shape))
        if inputs[0].type not in _FLOATS:
            raise ModelError("segmentation.input_type", path=self.path, kind=inputs[0].type)
        self._name, self._type = inputs[0].name, _FLOATS[inputs[0].type]
        stated = self.settings.tile_size_px
        fixed = [size if isinstance(size, int) else stated or DEFAULT_TILE_SIZE_PX for size in shape[2:]]
        self.tile_hw = fixed[0], fixed[1]
        if stated is not None and (stated, stated) != self.tile_hw:
            self.notes.append(Sentence("segmentation.other_tile_size", stated=stated, width=fixed[1], height=fixed[0]))
        if not all(0 < size <= LARGEST_TILE_PX for size in fixed):
            raise ModelError(
                "segmentation.tile_too_large", path=self.path, width=fixed[1], height=fixed[0], most=LARGEST_TILE_PX
            )
        fixed_batch = isinstance(shape[0], int)
        self.tiles_at_once = 1 if fixed_batch or self.provider == _CPU else TILES_AT_ONCE
        if fixed_batch and shape[0] != 1:
            raise ModelError("segmentation.batch_size", path=self.path, count=shape[0])

    def _probe(self) -> np.ndarray:
        """What the network gives for a black image; its stated shape may be silent on the number of classes."""
        height, width = self.tile_hw
        outputs = self._run([np.zeros((height, width, _BANDS), np.uint8)])
        if outputs.ndim not in (3, 4) or outputs.shape != (1, *outputs.shape[1:-2], height, width):
            raise ModelError(
                "segmentation.output_shape",
                path=self.path,
                shape=_shape_text(outputs.shape),
                width=width,
                height=height,
            )
        return outputs

    def _planes(self, images: Sequence[np.ndarray]) -> np.ndarray:
        """(N, 3, H, W) standardized pixels, as the network takes them."""
        planes = np.empty((len(images), _BANDS, *self.tile_hw), self._type)
        for image, plane in zip(images, planes):
            for band, pixels in enumerate(cv2.split(image)):
                plane[band] = cv2.LUT(pixels, self._standardized[band])
        return planes

    def _run(self, images: Sequence[np.ndarray]) -> np.ndarray:
        try:
            found = self._session.run(None, {self._name: self._planes(images)})[0]
        except _failures_of_a_run() as error:
            height, width = self.tile_hw
            raise ModelError(
                "segmentation.run_failed", path=self.path, width=width, height=height, reason=_reason(error)
            ) from error
        if not isinstance(found, np.ndarray) or found.dtype.kind not in "fiub":
            kind = found.dtype.name if isinstance(found, np.ndarray) else type(found).__name__
            raise ModelError("segmentation.output_kind", path=self.path, kind=kind)
        return found


def _onnxruntime() -> ModuleType:
    try:
        import onnxruntime
    except ImportError as error:
        raise ModelError("segmentation.no_onnxruntime", reason=str(error)) from None
    return onnxruntime


def _failures_of_a_run() -> tuple[type[BaseException], ...]:
    return (*_failures(), MemoryError, cv2.error)


def _failures() -> tuple[type[BaseException], ...]:
    """The exceptions of onnxruntime, which have no base of their own."""
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    names = (
        "EPFail",
        "EngineError",
        "Fail",
        "InvalidArgument",
        "InvalidGraph",
        "InvalidProtobuf",
        "ModelLoaded",
        "NoModel",
        "NoSuchFile",
        "NotImplemented",
        "RuntimeException",
    )
    return (*(getattr(state, name) for name in names if hasattr(state, name)), RuntimeError, ValueError)


def _providers() -> list[str]:
    """What onnxruntime has to run a network, best first."""
    there = _onnxruntime().get_available_providers()
    return [name for name in PROVIDERS if name in there]


def _open(path: str, threads: int) -> InferenceSession:
    onnxruntime = _onnxruntime()
    if not os.path.isfile(path):
        raise ModelError("segmentation.no_model_file", path=path)
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    # A thread that spins while it waits takes the core from reading and blending.
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    # Errors are raised; onnxruntime would write them to a console that QGIS users don't have, too.
    options.log_severity_level = 4
    try:
        return onnxruntime.InferenceSession(path, options, providers=_providers())
    except _failures() as error:
        raise ModelError(_why_not_opened(path, error, onnxruntime.__version__)) from error


def _why_not_opened(path: str, error: BaseException, version: str) -> Sentence:
    """One sentence for why onnxruntime refused a file; by what is in the file, for messages change with releases."""
    header = read_header(_content(path))
    if header is None:
        return Sentence("segmentation.no_onnx", path=path)
    known = _newest_known(header.ir_version, lambda ir_version: smallest_model(ir_version, _OPSET_OF_ALL))
    if known < header.ir_version:
        return Sentence("segmentation.newer_ir", path=path, found=header.ir_version, version=version, known=known)
    known = _newest_known(header.opset, lambda opset: smallest_model(_IR_VERSION_OF_ALL, opset))
    if known < header.opset:
        return Sentence("segmentation.newer_opset", path=path, found=header.opset, version=version, known=known)
    missing = header.missing_weights(path)
    if missing:
        return Sentence("segmentation.weights_missing", path=path, reason=missing)
    return Sentence("segmentation.not_run", path=path, version=version, reason=_reason(error))


def _content(path: str) -> bytes:
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def _newest_known(asked: int, model: Callable[[int], bytes]) -> int:
    """The highest version up to the one asked for that onnxruntime opens a model of."""
    for tried in range(min(asked, _HIGHEST_ASKED), 0, -1):
        if _opens(model(tried)):
            return asked if tried == min(asked, _HIGHEST_ASKED) < _HIGHEST_ASKED else tried
    return 0


def _opens(model: bytes) -> bool:
    onnxruntime = _onnxruntime()
    from onnxruntime.capi import onnxruntime_pybind11_state as state

    options = onnxruntime.SessionOptions()
    options.log_severity_level = 4
    try:
        onnxruntime.InferenceSession(model, options, providers=[_CPU])
    except state.NotImplemented:
        # The version is known, but this build lacks the one operator.
        return True
    except _failures():
        return False
    return True


def _reason(error: object) -> str:
    """The last part of onnxruntime's message, without its error code and source files, as part of a sentence."""
    text = re.sub(r"\[ONNXRuntimeError\] : \d+ : [A-Z_]+ : ", "", " ".join(str(error).split()))
    text = re.sub(r"\S*/onnxruntime/\S+:\d+ [^\n]*?\) ", "", text)
    return re.sub(r"\.\s+(?=[A-Z])", "; ", text)[:300].rstrip(". ")


def _shape_text(shape: Sequence[object]) -> str:
    return " × ".join(str(size) if isinstance(size, int) else "any" for size in shape)
