"""Correct a network that was exported with aligned corners, so that labels have the right place.

    .venv/bin/python tools/training/keep_places.py MODEL.onnx OUTPUT.onnx

Networks of segmentation_models_pytorch (PAN, FPN, DeepLab and others) and older networks of SemRef enlarge with aligned
corners. What is off the middle of a tile is then shown up to half a pixel of the smallest map farther off
(docs/how-to/train_a_network.md). Half-pixel centers need no other weights, because training compensated for the mean.
Weights and metadata are those of MODEL. If it states a class offset, measure the offset again.
"""

import argparse
import sys
from pathlib import Path

import onnx

MODE, ALIGNED, CENTERS = "coordinate_transformation_mode", b"align_corners", b"half_pixel"


def keep_places(model: onnx.ModelProto) -> int:
    """Change the model and return how many enlargements had aligned corners."""
    modes = [a for node in model.graph.node if node.op_type == "Resize" for a in node.attribute if a.name == MODE]
    aligned = [mode for mode in modes if mode.s == ALIGNED]
    for mode in aligned:
        mode.s = CENTERS
    return len(aligned)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path)
    parser.add_argument("output", type=Path)
    options = parser.parse_args()
    model = onnx.load(options.model)
    changed = keep_places(model)
    if not changed:
        sys.exit(f"{options.model} enlarges nothing with aligned corners; nothing was written.")
    onnx.save(model, options.output)
    print(f"{options.output}: {changed} enlargements now keep the right places")


if __name__ == "__main__":
    main()
