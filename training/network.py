"""The network: a Pyramid Attention Network (Li et al. 2018, arXiv:1805.10180) from segmentation_models_pytorch."""

from __future__ import annotations

import importlib

import torch


def pyramid_attention_network(encoder: str, depth: int, class_count: int, pretrained: bool) -> torch.nn.Module:
    """PAN of three bands in and ``class_count`` channels of logits out.

    encoder: a name of segmentation_models_pytorch; ``tu-NAME`` takes timm's NAME. depth 3 to 5: how often it halves.
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
    """Lets every enlargement keep the places of what it enlarges.

    With aligned corners, as segmentation_models_pytorch enlarges, a pixel's answer is drawn away from the middle of the
    tile, by up to half a pixel of the smallest map at its edges. No training can make up for that, as it differs by
    place, and photos that a single tile shows are taken for about 1 % larger than they are
    (docs/how-to/train_a_network.md).
    """
    for module in network.modules():
        if hasattr(module, "align_corners"):
            module.align_corners = False


def allow_torchvision_without_operators() -> None:
    """Lets torchvision be imported where its compiled operators don't load.

    PyPI's torchvision for Linux is built for CUDA and refuses to be imported beside a CPU build of torch, although
    segmentation_models_pytorch and timm need its Python part only. Declaring the two operators it looks up is enough.
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


_DECLARED: list[torch.library.Library] = []  # operators vanish with their library
