"""What a network can run on, which of onnxruntime's providers that is, and which Python package brings it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Device:
    """What a network can run on.

    Attributes:
        key: As settings and command lines have it.
        title: A name, the same in all languages.
        provider: onnxruntime's name of it.
        package: The Python package of onnxruntime that has it.
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
"""Those that can be chosen."""

AUTO = "auto"
"""The key for the first of AUTOMATIC that is there and starts."""

AUTOMATIC = (CUDA, ROCM, DIRECTML, COREML, OPENVINO, CPU)
"""Graphics cards first, then what is quicker on the same processor."""

KEYS = (AUTO, *(device.key for device in DEVICES))


def device_of(key: str) -> Device | None:
    """Return the device that was chosen; None for AUTO and for what is none."""
    return next((device for device in DEVICES if device.key == key), None)


def devices_to_try(asked: str, there: Sequence[str]) -> list[Device]:
    """Return what may run a network, in this order, the CPU last.

    Args:
        asked: One of KEYS.
        there: onnxruntime's names of the providers that it has.
    """
    chosen = device_of(asked)
    wanted = AUTOMATIC if chosen is None else (chosen, CPU)
    return [device for device in dict.fromkeys(wanted) if device is CPU or device.provider in there]
