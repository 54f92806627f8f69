"""Real places with photos and labels, to train and test networks for photos.

The photos of a place are resampled to a pixel size, and its polygons are rasterized on their pixels. Both are kept in a
folder. SemRef does not contain this data.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from benchmarks.toml import read_toml

TILE_CLASSES = (
    "value,name,color,role\n1,building,#3c1098,reference\n2,land_unpaved,#8429f6,reference\n3,road,#6ec1e4,reference\n"
    "4,vegetation,#fedd3a,reference\n5,water,#e2a929,reference\n"
)
"""Class table of the labels of dubai_aerial."""

BUILDINGS = ("building",)
ALL_CLASSES = ("building", "land_unpaved", "road", "vegetation", "water")
BUILDING, OTHER = 1, 0


@dataclass(frozen=True)
class Photo:
    """A photo and its labels.

    Attributes:
        image: Path in the data folder.
        labels: Polygons of buildings, or a label map on the photo's pixels.
        part: Start and end of the place, as shares of the width.
    """

    image: str
    labels: str
    part: tuple[float, float] = (0.0, 1.0)

    @property
    def name(self) -> str:
        """Return the stem of the files created from the photo."""
        return Path(self.image).stem + ("" if self.part == (0.0, 1.0) else f"_{100 * self.part[0]:.0f}")


@dataclass(frozen=True)
class Place:
    """A place that is used for training, or left out, as a whole.

    Attributes:
        name: Key of the place.
        about: Location, a colon, and a description.
        drawn: Classes that were drawn completely.
        photos: Photos of the place.
    """

    name: str
    about: str
    drawn: tuple[str, ...]
    photos: tuple[Photo, ...]


def _place(name: str, about: str, drawn: list[str], photos: list[dict]) -> Place:
    photos = [{**one, "part": tuple(one.get("part", (0.0, 1.0)))} for one in photos]
    return Place(name, about, tuple(drawn), tuple(Photo(**one) for one in photos))


PLACES = tuple(_place(**one) for one in read_toml(Path(__file__).with_name("places.toml"))["place"])


def place(name: str) -> Place:
    """Return the place with this name; KeyError for an unknown name."""
    return {one.name: one for one in PLACES}[name]


def class_table(names: tuple[str, ...]) -> str:
    """Return the class table of these classes as CSV."""
    head, *rows = TILE_CLASSES.strip().split("\n")
    return "\n".join([head, *(row for row in rows if row.split(",")[1] in names)]) + "\n"


def prepared(photo: Photo, data: Path, pixel_m: float, folder: Path) -> tuple[Path, Path]:
    """Return a photo at a pixel size, its own without a georeference, and its labels; use existing files."""
    from osgeo import gdal, ogr

    gdal.UseExceptions()
    image, labels = (folder / f"{photo.name}_{pixel_m:g}m_{kind}.tif" for kind in ("image", "label"))
    if image.exists() and labels.exists():
        return image, labels
    folder.mkdir(parents=True, exist_ok=True)
    source = gdal.Open(str(data / photo.image))
    first, last = (round(share * source.RasterXSize) for share in photo.part)
    part = {"srcWin": [first, 0, last - first, source.RasterYSize]}
    if photo.labels.endswith(".tif"):
        gdal.Translate(str(image), source, **part)
        gdal.Translate(str(labels), str(data / photo.labels), **part)
        return image, labels
    made = gdal.Translate(str(image), source, xRes=pixel_m, yRes=pixel_m, resampleAlg="average", **part)
    burnt = gdal.GetDriverByName("GTiff").Create(str(labels), made.RasterXSize, made.RasterYSize, 1)
    burnt.SetGeoTransform(made.GetGeoTransform())
    burnt.SetProjection(made.GetProjection())
    polygons = ogr.Open(str(data / photo.labels))  # the layer does not keep its data source
    gdal.RasterizeLayer(burnt, [1], polygons.GetLayer(0), burn_values=[BUILDING])
    return image, labels
