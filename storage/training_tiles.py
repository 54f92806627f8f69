"""Write training tiles: image and label tiles, class table and manifest in one folder.

See docs/how-to/train_a_network.md.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Callable

import numpy as np
from osgeo import gdal

from ..core.errors import ClassTableError, LabelMapError, ParameterError
from ..core.labels.class_table import UNLABELED, ClassTable
from ..core.labels.image_source import PixelMask
from ..core.labels.sources import count_labels
from ..core.labels.training_tiles import SUBSETS, TRAIN, VALIDATION, Tile, block_size, plan_tiles, validation_blocks
from ..core.steps import Steps
from .gdal_errors import gdal_failures, read_by_gdal
from .images import GdalImage
from .label_maps import GdalLabels, RasterFile, as_labels, class_table_of_map, class_table_of_values
from .pictures import write_png, write_tiff
from .rasters import open_raster, pixel_area
from .text_tables import CLASSES_FILE

MANIFEST = "manifest.json"
FORMAT = "semref training tiles 1"

COUNTING_SHARE = 0.2
"""Share of the work for counting labels."""

SMALLEST_DEVIATION = 0.1 / 255
"""Of the colors of an image, in 0…1; below it the image shows nothing."""

_KINDS = (gdal.GDT_Byte, gdal.GDT_UInt16, gdal.GDT_Int16)
"""Band types that can be exported."""

_COUNTED_AT_ONCE = 4096


class ImageBands:
    """An image's bands without alpha bands.

    Attributes:
        kind: GDAL's data type of all bands.
        shape_hw: (height, width) in pixels.
        geotransform: GDAL's six numbers; None without a georeference.
        network_bands: Numbers, from 1, of the exported bands that a network gets as red, green and blue.
        stretch: (3, 2) values that become 0 and 255 for the network; None for 8 bits.

    Raises:
        LabelMapError: The bands can't be exported as tiles.
        ImageError: The file can't be read.
    """

    def __init__(self, path: str) -> None:
        self.path = path
        self._dataset = open_raster(path)
        bands = {n: self._dataset.GetRasterBand(n) for n in range(1, self._dataset.RasterCount + 1)}
        kept = [n for n, band in bands.items() if band.GetColorInterpretation() != gdal.GCI_AlphaBand]
        self.bands = [bands[n] for n in kept]
        self.kind = self.bands[0].DataType
        if any(band.DataType != self.kind for band in self.bands) or self.kind not in _KINDS:
            name = gdal.GetDataTypeName(self.kind)
            raise LabelMapError(
                "{path} has {name} values. Convert it to an image of 8 or 16 bits.", path=path, name=name
            )
        if self.bands[0].GetRasterColorTable() is not None:
            raise LabelMapError("{path} has a palette; convert it to an RGB image first.", path=path)
        self._seen = GdalImage(path)
        self.network_bands = [kept.index(n) + 1 for n in self._seen.bands]
        self.stretch = self._seen.stretch
        self.shape_hw, self.geotransform = self._seen.shape_hw, self._seen.geotransform

    @property
    def as_png(self) -> bool:
        """Whether tiles can be PNG: 8 bits, gray or three colors."""
        return self.kind == gdal.GDT_Byte and len(self.bands) in (1, 3)

    def read(self, column: int, row: int, size: int) -> np.ndarray:
        """Return (bands, size, size) original values."""
        part = column, row, size, size
        return np.stack([read_by_gdal(self.path, band.ReadAsArray, *part) for band in self.bands])

    def read_as_seen(self, column: int, row: int, size: int) -> tuple[np.ndarray, np.ndarray]:
        """Return (size, size, 3) uint8 as a network gets it, and (size, size) bool of valid data."""
        pixels, has_data = self._seen.read(column, row, size, size)
        return pixels, np.ones((size, size), bool) if has_data is None else has_data


class LabelsOnImage:
    """A LabelSource: a label map on an image's grid, by nearest neighbor if the grids differ, 0 outside the map.

    If only one of them has a CRS, the other is assumed to have the same.

    Raises:
        LabelMapError: Their sizes differ, and one of them has no georeference.
    """

    def __init__(self, file: RasterFile, image: ImageBands, image_crs_wkt: str) -> None:
        self._path, self.labels = file.path, GdalLabels(file.path)
        self.shape_hw = image.shape_hw
        self._image_transform = image.geotransform
        self._crs = file.crs_wkt or image_crs_wkt, image_crs_wkt or file.crs_wkt
        transform = self.labels.dataset.GetGeoTransform(can_return_null=True)
        placed = transform is not None and self._image_transform is not None
        self._same_grid = self.labels.shape_hw == self.shape_hw and (not placed or transform == self._image_transform)
        if not self._same_grid and not placed:
            raise LabelMapError(
                "{path} has {size} pixels, the image {image_size}, and not both are georeferenced. Georeference both, "
                "or choose labels of the image’s size.",
                path=file.path,
                size=_size(self.labels.shape_hw),
                image_size=_size(self.shape_hw),
            )

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) uint8 labels of a part of the image."""
        if self._same_grid:
            return self.labels.read(column, row, width, height)
        x0, dx_column, dx_row, y0, dy_column, dy_row = self._image_transform
        corner_x, corner_y = x0 + column * dx_column + row * dx_row, y0 + column * dy_column + row * dy_row
        source = self.labels.dataset
        piece = gdal.GetDriverByName("MEM").Create("", width, height, 1, source.GetRasterBand(1).DataType)
        piece.SetGeoTransform((corner_x, dx_column, dx_row, corner_y, dy_column, dy_row))
        with gdal_failures() as failures:
            gdal.ReprojectImage(source, piece, *self._crs, gdal.GRA_NearestNeighbour)
        if failures:
            raise LabelMapError("The labels can’t be reprojected to the image: {reason}.", reason=failures[0])
        return as_labels(piece.ReadAsArray(), self._path)


def _size(shape_hw: tuple[int, int]) -> str:
    return f"{shape_hw[1]} × {shape_hw[0]}"


class TileExport:
    """Writer of the tiles of an image."""

    def __init__(  # noqa: PLR0913 - what is cut, how, and what of it
        self,
        image: RasterFile,
        labels: RasterFile,
        tile_size: int,
        stride: int,
        fraction: float,
        mask: PixelMask | None = None,
        unseen_apart: bool = False,
        require: Callable[[np.ndarray, ClassTable], None] | None = None,
    ) -> None:
        """Open image and labels without writing tiles.

        Args:
            tile_size: Edge in pixels.
            stride: Distance between tiles in pixels.
            fraction: Share of the ground for validation.
            mask: The pixels of the image to use; others count as no data. None for all.
            unseen_apart: Whether pixels without data get a value that no class has. Needed if 0 is trained as a class.
            require: Check of the (256,) pixels per value and the classes before the first tile is written. It raises an
                error for unsuitable labels. None for no check.
        """
        self._require = require
        self._image = ImageBands(image.path)
        self._mask = mask
        self._unseen_apart, self._unseen = unseen_apart, UNLABELED
        self._labels = LabelsOnImage(labels, self._image, image.crs_wkt)
        self._files = image, labels
        self._tile_size, self._stride, self._fraction = tile_size, stride, fraction
        self._block = block_size(self._image.shape_hw, tile_size)
        self._counts: dict[str, int] = dict.fromkeys(SUBSETS, 0)
        self._lacks_data = False
        self._tiles: list[dict] = []
        self._class_pixels = {subset: np.zeros(256, np.int64) for subset in SUBSETS}
        self._sums, self._squares, self._pixels = np.zeros(3), np.zeros(3), 0

    def write(self, folder: Path, table: ClassTable | None) -> Steps[dict[str, int]]:
        """Count labels, divide the ground, and write tiles, class table and manifest; return the tiles per subset.

        Args:
            table: The classes; None for the classes of the label map.

        Raises:
            ParameterError: There are no tiles for training or validation.
            ClassTableError: The label map has a value that no class has.
            ImageError: Image or labels can't be read.
        """
        height, width = self._image.shape_hw
        labeled = np.zeros((-(-height // self._block), -(-width // self._block)), np.int64)
        values = np.zeros(256, np.int64)
        for number, (row, column) in enumerate(np.ndindex(labeled.shape)):
            for counted in self._block_counts(row * self._block, column * self._block):
                values += counted
                labeled[row, column] += counted[UNLABELED + 1 :].sum()
                yield "Counting labels", COUNTING_SHARE * number / labeled.size
        table = table or class_table_of_map(self._labels.labels, self._files[1]) or class_table_of_values(values)
        _require_known_values(values, table)
        if self._require is not None:
            self._require(values, table)
        if self._unseen_apart:
            self._unseen = next((v for v in range(255, 0, -1) if table.by_value(v) is None), UNLABELED)
        held_out = validation_blocks(labeled, self._fraction)
        tiles = plan_tiles(self._image.shape_hw, self._tile_size, self._stride, held_out, self._block)
        for subset in SUBSETS:
            for kind in ("images", "labels"):
                (folder / subset / kind).mkdir(parents=True)
        for number, tile in enumerate(tiles):
            yield "Writing tiles", COUNTING_SHARE + (1 - COUNTING_SHARE) * number / len(tiles)
            self._write_tile(folder, tile)
        self._require_tiles(labeled)
        (folder / CLASSES_FILE).write_text(table.to_csv(), encoding="utf-8")
        (folder / MANIFEST).write_text(json.dumps(self._manifest(), indent=1) + "\n", encoding="utf-8")
        return self._counts

    def _block_counts(self, first_row: int, first_column: int) -> Iterator[np.ndarray]:
        """Yield (256,) pixels per value of the parts of a block."""
        height, width = self._image.shape_hw
        last_row, last_column = min(first_row + self._block, height), min(first_column + self._block, width)
        for row in range(first_row, last_row, _COUNTED_AT_ONCE):
            for column in range(first_column, last_column, _COUNTED_AT_ONCE):
                size = min(_COUNTED_AT_ONCE, last_column - column), min(_COUNTED_AT_ONCE, last_row - row)
                labels = self._labels.read(column, row, *size)
                if self._mask is not None:
                    labels = np.where(self._mask.read(column, row, *size), labels, UNLABELED).astype(np.uint8)
                yield count_labels(labels)

    def _write_tile(self, folder: Path, tile: Tile) -> None:
        size = self._tile_size
        seen, has_data = self._image.read_as_seen(tile.column, tile.row, size)
        if self._mask is not None:
            has_data = has_data & self._mask.read(tile.column, tile.row, size, size)
        known = self._labels.read(tile.column, tile.row, size, size)
        labels = np.where(has_data, known, self._unseen).astype(np.uint8)
        counted = count_labels(labels)
        unlabeled = counted[UNLABELED] + (counted[self._unseen] if self._unseen else 0)
        if unlabeled == labels.size:
            self._lacks_data |= not has_data.any() and bool(known.any())
            return
        images = folder / tile.subset / "images"
        pixels = self._image.read(tile.column, tile.row, size)
        transform = self._image.geotransform
        if self._image.as_png:
            write_png(images / f"{tile.name}.png", pixels)
        else:
            write_tiff(images / f"{tile.name}.tif", pixels, self._image.kind)
        write_png(folder / tile.subset / "labels" / f"{tile.name}.png", labels[None])
        self._counts[tile.subset] += 1
        counted[self._unseen] = counted[self._unseen] if self._unseen == UNLABELED else 0
        self._class_pixels[tile.subset] += counted
        place = {"name": tile.name, "subset": tile.subset, "column": tile.column, "row": tile.row}
        if transform is not None:
            place["x"] = transform[0] + tile.column * transform[1] + tile.row * transform[2]
            place["y"] = transform[3] + tile.column * transform[4] + tile.row * transform[5]
        self._tiles.append({**place, "labeled": round(1 - float(unlabeled) / labels.size, 4)})
        if tile.subset == TRAIN:
            shares = seen[has_data] / 255
            self._sums += shares.sum(axis=0)
            self._squares += (shares**2).sum(axis=0)
            self._pixels += len(shares)

    def _require_tiles(self, labeled: np.ndarray) -> None:
        if not labeled.any():
            raise ParameterError("No pixel of the image is labeled; check that image and labels show the same ground.")
        if self._lacks_data and not self._tiles:
            raise ParameterError(
                "The image has no data where the ground is labeled: its pixels there have the nodata value or are "
                "transparent. Choose an image of this ground, or correct its nodata value."
            )
        if not self._counts[TRAIN] or (self._fraction and not self._counts[VALIDATION]):
            raise ParameterError(
                "The labeled ground gives {training} tiles of {tile_size} pixels for training and {validation} for "
                "validation. Label more ground, or choose a finer resolution, smaller tiles or another validation "
                "fraction.",
                training=self._counts[TRAIN],
                validation=self._counts[VALIDATION],
                tile_size=self._tile_size,
            )
        if self._statistics()[1].max() < SMALLEST_DEVIATION:
            raise LabelMapError(
                "The image has the same color everywhere, so a network can't learn from it. Choose another image."
            )

    def _statistics(self) -> tuple[np.ndarray, np.ndarray]:
        """Return mean and deviation (3,) of red, green and blue in 0…1 over the training tiles."""
        mean = self._sums / self._pixels
        return mean, np.sqrt(np.maximum(self._squares / self._pixels - mean**2, 0))

    def _manifest(self) -> dict:
        image, labels = self._files
        transform = self._image.geotransform
        mean, deviation = self._statistics()
        return {
            "format": FORMAT,
            "image": Path(image.path).name,
            "labels": Path(labels.path).name,
            "crs": image.crs_wkt if transform is not None else "",
            "geotransform": list(transform) if transform is not None else None,
            "pixel_size": round(pixel_area(transform) ** 0.5, 6) if transform is not None and image.is_metric else None,
            "tile_size": self._tile_size,
            "stride": self._stride,
            "block_size": self._block,
            "validation_fraction": self._fraction,
            "band_count": len(self._image.bands),
            "data_type": gdal.GetDataTypeName(self._image.kind),
            "network_bands": self._image.network_bands,
            "stretch": None if self._image.stretch is None else self._image.stretch.tolist(),
            "statistics": {
                "class_pixels": {
                    subset: {str(value): int(counts[value]) for value in np.flatnonzero(counts)}
                    for subset, counts in self._class_pixels.items()
                },
                "band_mean": mean.tolist(),
                "band_std": deviation.tolist(),
            },
            "tiles": self._tiles,
        }


def _require_known_values(values: np.ndarray, table: ClassTable) -> None:
    """Raise ClassTableError for a value without a class; ``values``: (256,) pixels per value."""
    unknown = [str(v) for v in np.flatnonzero(values) if v != UNLABELED and table.by_value(int(v)) is None]
    if unknown:
        raise ClassTableError(
            "The labels have the value {unknown}, which the class table lacks; its classes are {classes}.",
            unknown=unknown,
            classes=table.describe(),
        )
