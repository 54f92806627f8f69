"""Devices that can run a network, with onnxruntime's provider and Python package for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Device:
    """A device that can run a network.

    Attributes:
        key: Value in settings and command lines.
        title: Display name, the same in all languages.
        provider: onnxruntime's name of it.
        package: The Python package of onnxruntime that supports it.
    """

    key: str
    title: str
    provider: str
    package: str


CPU = Device("cpu", "CPU", "CPUExecutionProvider", "onnxruntime")
CUDA = Device("cuda", "CUDA", "CUDAExecutionProvider", "onnxruntime-gpu")
ROCM = Device("rocm", "ROCm", "ROCMExecutionProvider", "onnxruntime-rocm")
DIRECTML = Device("directml", "DirectML", "DmlExecutionProvider", "onnxruntime-directml")
COREML = Device("coreml", "CoreML", "CoreMLExecutionProvider", "onnxruntime")
OPENVINO = Device("openvino", "OpenVINO", "OpenVINOExecutionProvider", "onnxruntime-openvino")

DEVICES = (CPU, CUDA, DIRECTML, COREML, OPENVINO)
"""Devices that a user can choose."""

AUTO = "auto"
"""The key for the first of AUTOMATIC that is available and starts."""

AUTOMATIC = (CUDA, ROCM, DIRECTML, COREML, OPENVINO, CPU)
"""Graphics cards first, then the faster providers on the same processor."""

KEYS = (AUTO, *(device.key for device in DEVICES))


def device_of(key: str) -> Device | None:
    """Return the device for a key; None for AUTO and unknown keys."""
    return next((device for device in DEVICES if device.key == key), None)


def devices_to_try(asked: str, there: Sequence[str]) -> list[Device]:
    """Return the devices to try for a network, in order, the CPU last.

    Args:
        asked: One of KEYS.
        there: onnxruntime's names of its available providers.
    """
    chosen = device_of(asked)
    wanted = AUTOMATIC if chosen is None else (chosen, CPU)
    return [device for device in dict.fromkeys(wanted) if device is CPU or device.provider in there]
