"""Build the network: a Pyramid Attention Network (Li et al. 2018, arXiv:1805.10180)."""

from __future__ import annotations

import importlib

import torch


def pyramid_attention_network(encoder: str, depth: int, class_count: int, pretrained: bool) -> torch.nn.Module:
    """Return a network with three input bands and ``class_count`` channels of logits.

    Args:
        encoder: Name in segmentation_models_pytorch; ``tu-NAME`` is timm's NAME.
        depth: How often the encoder halves the image, 3 to 5.
        class_count: Number of classes.
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
