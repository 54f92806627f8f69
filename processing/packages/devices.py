"""Devices that run networks: the selected one, the available ones, and the packages that add others."""

from __future__ import annotations

import sys

from qgis.core import QgsSettings

from ...core.segmentation.devices import AUTO, COREML, CUDA, DEVICES, DIRECTML, KEYS, OPENVINO, Device
from .components import ONNXRUNTIME, ONNXRUNTIME_VARIANTS, Package, is_missing

DEVICE_SETTING = "semref/options/device"

_SYSTEMS = {CUDA: ("linux", "win32"), DIRECTML: ("win32",), OPENVINO: ("linux",)}
"""Systems for which a wheel contains all that the device needs beside drivers; OpenVINO's for Windows does not."""


def chosen_device() -> str:
    """Return the key of the selected device; AUTO if it is not set or unknown."""
    key = QgsSettings().value(DEVICE_SETTING, AUTO, type=str)
    return key if key in KEYS else AUTO


def choose_device(key: str) -> None:
    """Store the selected device for all following runs."""
    QgsSettings().setValue(DEVICE_SETTING, key)


def available_devices() -> list[Device]:
    """Return the devices that onnxruntime reports; empty if it is missing or broken."""
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
    """Return the package of a device, and its system if there is only one."""
    system = {DIRECTML: "Windows", COREML: "macOS"}.get(device)
    return f"{device.package}, {system}" if system else device.package


def package_of(device: Device) -> Package | None:
    """Return the package that SemRef can install for a device on this system; None without one."""
    if not sys.platform.startswith(_SYSTEMS.get(device, ())):
        return None
    return next((package for package in ONNXRUNTIME_VARIANTS if package.pip_name == device.package), None)
