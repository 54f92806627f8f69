"""What networks run on: what was chosen in the options, what is there, which package brings what is not."""

from __future__ import annotations

import sys

from qgis.core import QgsSettings

from ...core.segmentation.devices import AUTO, COREML, CUDA, DEVICES, DIRECTML, KEYS, OPENVINO, Device
from .components import ONNXRUNTIME, ONNXRUNTIME_VARIANTS, Package, is_missing

DEVICE_SETTING = "semref/options/device"

_SYSTEMS = {CUDA: ("linux", "win32"), DIRECTML: ("win32",), OPENVINO: ("linux",)}
"""Where a wheel of the index has all that the device needs beside drivers; OpenVINO's own for Windows do not."""


def chosen_device() -> str:
    """The key of the device that was chosen; AUTO where none was, or one that this SemRef does not know."""
    key = QgsSettings().value(DEVICE_SETTING, AUTO, type=str)
    return key if key in KEYS else AUTO


def choose_device(key: str) -> None:
    """Keeps a choice, for all that runs from now on."""
    QgsSettings().setValue(DEVICE_SETTING, key)


def available_devices() -> list[Device]:
    """Those that can be chosen and that onnxruntime reports to have; none where it is missing or broken."""
    if is_missing(ONNXRUNTIME):
        return []
    from ...core.errors import ModelError
    from ...core.segmentation.session import available_providers

    try:
        there = available_providers()
    except ModelError:
        return []
    return [device for device in DEVICES if device.provider in there]


def package_name(device: Device) -> str:
    """Which package brings a device, and the system that it needs where there is only one."""
    system = {DIRECTML: "Windows", COREML: "macOS"}.get(device)
    return f"{device.package}, {system}" if system else device.package


def package_of(device: Device) -> Package | None:
    """The package that SemRef can install to have a device on this system; None where there is none."""
    if not sys.platform.startswith(_SYSTEMS.get(device, ())):
        return None
    return next((package for package in ONNXRUNTIME_VARIANTS if package.pip_name == device.package), None)
