"""Train a Pyramid Attention Network on tiles from semref:exporttrainingtiles and write it as an ONNX model.

    python tools/training/train_pan.py TILES [TILES …] --output MODEL.onnx [--epochs 60] [--test TILES] [--resume]

TILES are folders of exported tiles with the same classes. Beside the model a folder MODEL.training holds the curves
(curves.csv), the best weights and what --resume needs. --test tells how good the model is on tiles of another place,
in torch and in onnxruntime. Set-up: bash tools/training/setup_training.sh; docs/training.md explains.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path


def main(arguments: list[str] | None = None) -> int:
    """Run from the command line; returns the exit status."""
    options = parse(arguments)
    try:
        from training.tiles import TrainingError
    except ImportError as error:
        print(
            f"train_pan: {error}. Run it with the Python that tools/training/setup_training.sh sets up.",
            file=sys.stderr,
        )
        return 1
    try:
        train(options)
    except TrainingError as error:
        print(f"train_pan: {error}", file=sys.stderr)
        return 1
    return 0


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tiles", type=Path, nargs="+", metavar="TILES")
    parser.add_argument("--output", type=Path, required=True, help="ONNX file to write")
    parser.add_argument("--test", type=Path, nargs="+", default=[], metavar="TILES", help="tiles of another place")
    parser.add_argument("--encoder", default="tu-mobilenetv3_small_100", help="default %(default)s")
    parser.add_argument("--depth", type=int, choices=(3, 4, 5), default=5, help="of the encoder; default %(default)s")
    parser.add_argument("--pretrained", action="store_true", help="start from ImageNet's weights (downloads them)")
    parser.add_argument("--encoder-weights", type=Path, metavar="FILE", help="start from these: a torch state dict")
    parser.add_argument("--learn-unlabeled", action="store_true", help="value 0 is a class of its own, not unknown")
    parser.add_argument("--epochs", type=int, default=60)
    parser.add_argument("--pieces", type=int, help="an epoch; default: as many as cover the tiles once")
    parser.add_argument("--piece-size", type=int, default=256, help="pixels, a multiple of 32; default %(default)s")
    parser.add_argument("--batch", type=int, default=8)
    parser.add_argument("--learning-rate", type=float, default=1e-3)
    parser.add_argument("--light", type=float, default=1.0, help="how much light and color vary; default %(default)s")
    parser.add_argument("--patience", type=int, default=20, help="epochs without progress; 0: train to the end")
    parser.add_argument("--mixed-precision", choices=("auto", "on", "off"), default="auto", help="auto: with a GPU")
    parser.add_argument("--channels-last", action="store_true", help="twice as fast for mobile encoders on a CPU")
    parser.add_argument("--resolution", type=float, help="meters a pixel; default: as the tiles say")
    parser.add_argument("--overlap", type=int, default=15, help="percent of a tile, for the metadata")
    parser.add_argument("--workers", type=int, default=0, help="processes that read tiles")
    parser.add_argument("--threads", type=int, help="of torch on the CPU")
    parser.add_argument("--seed", type=int, default=1671)
    parser.add_argument("--resume", action="store_true", help="go on with the run beside the output")
    options = parser.parse_args(arguments)
    if options.pretrained and options.encoder_weights:
        parser.error("--pretrained and --encoder-weights exclude each other")
    return options


def train(options: argparse.Namespace) -> None:
    """Trains, exports and checks. Raises TrainingError."""
    import numpy as np
    import torch

    from training import encoder_weights, export, loop, metrics, network, tiles

    folders = tiles.open_folders(options.tiles)
    classes = [export.UNLABELED, *folders[0].classes]
    if options.learn_unlabeled:
        classes[0] = tiles.ClassRow(0, "other", "#000000", "background")
    values = [c.value for c in classes]
    readers = {
        subset: tiles.TileReader([p for f in folders for p in f.tiles(subset)], values, options.learn_unlabeled)
        for subset in ("train", "validation")
    }
    tile_size = min(folder.manifest["tile_size"] for folder in folders)
    mean, deviation = tiles.band_statistics(folders)
    pixels = np.array(
        [sum(f.manifest["statistics"]["class_pixels"]["train"].get(str(value), 0) for f in folders) for value in values]
    )
    if not options.learn_unlabeled:
        pixels[0] = 0
    torch.manual_seed(options.seed)
    if options.threads:
        torch.set_num_threads(options.threads)
    settings = loop.Settings(
        epochs=options.epochs,
        pieces=options.pieces or len(readers["train"]) * max(1, (tile_size // options.piece_size) ** 2),
        piece_size=options.piece_size,
        batch=options.batch,
        learning_rate=options.learning_rate,
        patience=options.patience,
        mixed_precision=options.mixed_precision == "on"
        or (options.mixed_precision == "auto" and torch.cuda.is_available()),
        channels_last=options.channels_last,
        workers=options.workers,
        seed=options.seed,
        light=options.light,
    )
    net = network.pyramid_attention_network(options.encoder, options.depth, len(classes), options.pretrained)
    if options.encoder_weights:
        encoder_weights.load_encoder_weights(net.encoder, options.encoder_weights)
    if options.encoder_weights or options.pretrained:
        mean, deviation = encoder_weights.standardization(options.encoder)
    folder = options.output.with_suffix(".training")
    folder.mkdir(parents=True, exist_ok=True)
    weights = metrics.class_weights(pixels)
    trainer = loop.Trainer(net, mean, deviation, [c.name for c in classes], weights, settings, folder)
    print(
        f"{len(readers['train'])} tiles to train on, {len(readers['validation'])} to validate on, {trainer.device}; "
        f"{sum(p.numel() for p in net.parameters())} weights; class weights {np.round(weights, 2)}",
        flush=True,
    )
    if options.resume:
        trainer.resume()
    trainer.run(readers["train"], readers["validation"])
    sizes = {f.manifest["pixel_size"] for f in folders}
    resolution = options.resolution or (sizes.pop() if len(sizes) == 1 else None)
    finish(options, trainer, classes, (mean, deviation), tile_size, resolution, readers["train"])
    for test in tiles.open_folders(options.test):
        pairs = test.tiles("train") + test.tiles("validation")
        reader = tiles.TileReader(pairs, values, options.learn_unlabeled)
        by_torch, by_onnx, same = export.compared(trainer.network, options.output, reader, mean, deviation)
        print(f"\n{test.path}, {len(reader)} tiles, {same:.4%} of the pixels alike in torch and onnxruntime\n")
        print("| class | IoU in torch | IoU in onnxruntime |\n|---|---|---|")
        pairs = zip([c.name for c in classes], *(metrics.intersection_over_union(m) for m in (by_torch, by_onnx)))
        print("\n".join(f"| {name} | {a:.4f} | {b:.4f} |" for name, a, b in pairs if np.isfinite(a)))


def finish(options, trainer, classes, standardization, tile_size: int, resolution, reader) -> None:
    """Writes the model beside its place, checks it, and moves it there."""
    from training import export

    mean, deviation = standardization
    temporary = options.output.with_name(f".{options.output.name}.part")
    export.write_onnx(trainer.network, tile_size, temporary)
    export.add_metadata(temporary, classes, mean, deviation, tile_size, options.overlap, resolution)
    whole = (reader(0)[0].transpose(2, 0, 1) - mean[:, None, None]) / deviation[:, None, None]
    half = tile_size // 32 * 16
    difference = export.largest_difference(trainer.network, temporary, [whole, whole[:, :half, :tile_size]])
    temporary.replace(options.output)
    print(
        f"{options.output}: {options.output.stat().st_size / 1e6:.2f} MB, best validation in epoch "
        f"{trainer.best_epoch}; differs from torch by at most {difference:.1e} in a logit"
    )


if __name__ == "__main__":
    sys.exit(main())
