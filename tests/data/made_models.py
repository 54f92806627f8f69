"""Small segmentation networks with known answers: the class of a pixel is its brightest color."""

import importlib.util
import json
import sys
from pathlib import Path

import numpy as np

WRITER = Path(__file__).parents[2] / "tools" / "onnx_writer.py"
NAMES = ("building", "water", "bare_land")
"""Classes of the network below: red, blue and green ground."""
RGB = {"building": (220, 40, 40), "water": (40, 40, 220), "bare_land": (40, 220, 40)}


def load_writer():
    """Return tools/onnx_writer.py as a module, without tools/ on sys.path."""
    if "semref_onnx_writer" not in sys.modules:
        spec = importlib.util.spec_from_file_location("semref_onnx_writer", WRITER)
        sys.modules["semref_onnx_writer"] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules["semref_onnx_writer"])
    return sys.modules["semref_onnx_writer"]


writer = load_writer()


def metadata(**more) -> dict:
    """Return metadata as Deepness writes them; ``None`` leaves a key out."""
    found = {
        "model_type": "Segmentor",
        "class_names": {str(n): name for n, name in enumerate(NAMES)},
        "tile_size": 64,
        "tiles_overlap": 25,
        "standardization_mean": [0.5, 0.5, 0.5],
        "standardization_std": [0.5, 0.5, 0.5],
        **more,
    }
    return {key: json.dumps(value) for key, value in found.items() if value is not None}


def brightest_color(kernel: int = 1, external: str = "", bands: int = 3, bias=(0, 0, 0)) -> writer.Network:
    """Return a network (1, 3, H, W) → (1, 3, H, W): red, blue, green; a larger kernel gives means of squares."""
    kernels = np.zeros((3, bands, kernel, kernel), np.float32)
    for channel, band in enumerate((0, 2, 1)):
        kernels[channel, band] = 1 / kernel**2
    return writer.Network().convolution(kernels, np.array(bias), external=external)


def ground_and_colors() -> writer.Network:
    """Return a network with the channels ground (the same everywhere), red, blue and green."""
    kernels = np.zeros((4, 3, 1, 1), np.float32)
    for channel, band in ((1, 0), (2, 2), (3, 1)):
        kernels[channel, band] = 1
    return writer.Network().convolution(kernels, np.array([0.2, 0, 0, 0]))


def write_model(path: Path, network=None, *, size=("height", "width"), classes="classes", batch=1, **options) -> Path:
    """Write ``network`` as an ONNX file; ``options`` are those of ``writer.model_bytes``."""
    network = network or brightest_color()
    options.setdefault("metadata", metadata())
    options.setdefault("input_shape", (batch, 3, *size))
    options.setdefault("output_shape", (batch, classes, *size))
    path.write_bytes(writer.model_bytes(network, **options))
    return path


def painted(labels_hw: np.ndarray, names=(None, *NAMES)) -> np.ndarray:
    """Return a (H, W, 3) uint8 photo of labels 1, 2, 3; unlabeled pixels are gray."""
    palette = np.array([(90, 90, 90) if name is None else RGB[name] for name in names], np.uint8)
    return palette[labels_hw]


def smallest_model() -> bytes:
    def part(number: int, data: bytes) -> bytes:
        return bytes([number << 3 | 2, len(data)]) + data

    one_float = part(1, b"\x08\x01" + part(2, part(1, b"\x08\x01")))
    node = part(1, b"x") + part(2, b"y") + part(4, b"Identity")
    ends = part(11, part(1, b"x") + part(2, one_float)) + part(12, part(1, b"y") + part(2, one_float))
    return b"\x08\x04" + part(7, part(1, node) + part(2, b"g") + ends) + part(8, b"\x10\x0b")
