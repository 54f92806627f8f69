"""Devices that run networks: the selected one, and the available ones."""

from __future__ import annotations

from qgis.core import QgsSettings

from ...core.errors import ModelError
from ...core.segmentation.devices import AUTO, COREML, DEVICES, DIRECTML, KEYS, Device
from .components import ONNXRUNTIME, is_missing

DEVICE_SETTING = "semref/options/device"


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
