"""Train on tiles of dubai_aerial except some, to measure a network of modest quality on real photos.

    .venv/bin/python tools/training/train_dubai.py OUTPUT_FOLDER --leave-out 6

The script cuts the photos of $SEMREF_DATA or ../shared/data, and trains in .venv-train (setup_training.sh) from weights
of ImageNet. The model is OUTPUT_FOLDER/without_tile6.onnx (without_tiles13.onnx for --leave-out 1 3). Then
``.venv/bin/python -m benchmarks run dubai --only "tile 6" --models OUTPUT_FOLDER`` localizes crops of this tile.
"""

from common import DATA, Job, cut, parser_of, prepare, train

from benchmarks.places import TILE_CLASSES
from semref.training.job import LITE0, PACKAGED

TILES = (1, 2, 3, 4, 5, 6)
GRID_PX, VALIDATION_FRACTION = (512, 512), 0.1


def main() -> None:
    parser = parser_of(__doc__)
    parser.add_argument("--leave-out", type=int, nargs="+", choices=TILES, default=[6])
    options = parser.parse_args()
    folder = prepare(parser, options, "dubai_aerial")
    classes = folder / "classes.csv"
    classes.write_text(TILE_CLASSES, encoding="utf-8")
    tiles = []
    for number in set(TILES) - set(options.leave_out):
        pair = (DATA / "dubai_aerial" / f"tile{number}_{kind}.tif" for kind in ("image", "label"))
        tiles.append(str(cut(*pair, classes, folder / f"tile{number}", GRID_PX, VALIDATION_FRACTION)))
    plural = "s" if len(options.leave_out) > 1 else ""
    model = folder / f"without_tile{plural}{''.join(map(str, options.leave_out))}.onnx"
    job = Job(
        tuple(tiles),
        str(model),
        str(model.with_suffix(".training")),
        encoder=LITE0,
        encoder_weights=PACKAGED,
        light=1.5,
        epochs=12,
        pieces=400,
        learning_rate=5e-4,
        patience=0,
    )
    train(options.python, job)


if __name__ == "__main__":
    main()
