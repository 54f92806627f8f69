"""Rasters are opened only by the driver of their suffix, so that untrusted files contact no server."""

import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from made_inputs import scattered_objects, write_raster, write_text
from osgeo import gdal
from qgis.core import QgsProcessingException

from semref.core.errors import SemRefError
from semref.core.labels.class_table import class_table_from_values
from semref.core.labels.image_files import read_photo
from semref.storage.images import GdalImage
from semref.storage.label_images import read_label_image
from semref.storage.label_maps import GdalLabels
from semref.storage.rasters import open_raster, require_own_pixels

LABELS = scattered_objects(80, 90, 6, seed=1)
OVERVIEWS = '<PAMDataset><Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">{name}</MDI></Metadata></PAMDataset>'
WMS = (
    '<GDAL_WMS><Service name="TMS"><ServerUrl>{url}/${{z}}/${{x}}/${{y}}.png</ServerUrl></Service><DataWindow>'
    "<UpperLeftX>0</UpperLeftX><UpperLeftY>90</UpperLeftY><LowerRightX>90</LowerRightX><LowerRightY>0</LowerRightY>"
    "<SizeX>90</SizeX><SizeY>80</SizeY></DataWindow><BandsCount>1</BandsCount></GDAL_WMS>"
)
VRT = (
    '<VRTDataset rasterXSize="90" rasterYSize="80"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
    '<SourceFilename relativeToVRT="0">{name}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>'
    "</VRTRasterBand></VRTDataset>"
)
ERS = (
    'DatasetHeader Begin\n\tVersion = "6.0"\n\tName = "a"\n\tDataFile = "{name}"\n\tDataSetType = Translated\n'
    "\tDataType = Raster\n\tByteOrder = LSBFirst\n\tRasterInfo Begin\n\t\tCellType = Unsigned8BitInteger\n"
    "\t\tNrOfLines = 80\n\t\tNrOfCellsPerLine = 90\n\t\tNrOfBands = 1\n\tRasterInfo End\nDatasetHeader End\n"
)


def doors():
    return (
        lambda path: GdalImage(path, (30, 30)).read(0, 0, 30, 30),
        lambda path: GdalLabels(path).read(0, 0, 80, 80),
        lambda path: read_label_image(path, class_table_from_values([1, 2, 3, 4])),
        open_raster,
    )


def refuse(path, readers, words=None) -> None:
    for read in readers:
        with pytest.raises(SemRefError, match=words) as refused:
            read(str(path))
        assert str(path) in str(refused.value)


@pytest.mark.parametrize("suffix", [".png", ".tif", ".jpg", ".dat", ""])
@pytest.mark.parametrize("content", ["wms", "curl", "local", "ers"])
def test_a_description_under_the_name_of_a_picture_is_refused(qgis_app, host, tmp_path, suffix, content):
    write_raster(tmp_path / "secret.tif", LABELS)
    texts = {"wms": WMS.format(url=host.url), "local": VRT.format(name=tmp_path / "secret.tif")}
    texts |= {"curl": VRT.format(name=f"/vsicurl/{host.url}/a.tif"), "ers": ERS.format(name=host.name())}
    path = write_text(tmp_path / f"picture{suffix}", texts[content])
    refuse(path, doors())
    assert host.asked == []


def test_descriptions_that_the_user_named_as_such_and_pictures_without_a_suffix_are_read(qgis_app, tmp_path):
    write_raster(tmp_path / "labels.tif", LABELS)
    (tmp_path / "named.vrt").write_text(VRT.format(name=tmp_path / "labels.tif"), encoding="utf-8")
    shutil.copy(tmp_path / "labels.tif", tmp_path / "labels.dat")
    part = f"/vsisubfile/0_100000000,{tmp_path}/labels.tif"
    for name in (f"{tmp_path}/named.vrt", part, f"{tmp_path}/labels.dat"):
        np.testing.assert_array_equal(GdalLabels(name).read(0, 0, 90, 80), LABELS)


@pytest.mark.parametrize("name", ["labels.png", "labels.jpg", "labels.JPEG"])
def test_a_picture_under_the_name_of_another_kind_is_refused(qgis_app, tmp_path, name):
    path = write_raster(tmp_path / "labels.tif", LABELS).rename(tmp_path / name)
    refuse(path, (*doors(), read_photo), r"its content is TIFF\. Change the suffix to \.tif")


@pytest.mark.parametrize(
    "transform",
    [
        (float("nan"), 1.0, 0.0, 5220000.0, 0.0, -1.0),
        (1e300, 1.0, 0.0, 5220000.0, 0.0, -1.0),
        (550000.0, 1e300, 0.0, 5220000.0, 0.0, -1e300),
        (550000.0, float("inf"), 0.0, 5220000.0, 0.0, float("-inf")),
    ],
)
def test_a_georeference_that_no_map_has_is_refused(qgis_app, run_algorithm, tmp_path, transform):
    path = write_raster(tmp_path / "labels.tif", LABELS, transform=transform)
    with pytest.raises(SemRefError, match="georeference"):
        GdalLabels(str(path))


def in_tag(path, name):
    """Write the item into the TIFF itself."""
    dataset = gdal.Open(str(path), gdal.GA_Update)
    dataset.SetMetadataItem("OVERVIEW_FILE", name, "OVERVIEWS")
    dataset = None
    assert not os.path.exists(f"{path}.aux.xml")


def beside(suffix, text):
    return lambda path, host: write_text(Path(f"{path}{suffix}"), text.format(name=host.name(), url=host.url))


def overview(plant):
    def run(path, host):
        shutil.copy(path, f"{path}.ovr")
        plant(f"{path}.ovr", host)

    return run


PLANTED = {
    "aux.xml": beside(".aux.xml", OVERVIEWS),
    "overviews of a web map": beside(".ovr", WMS),
    "overviews of a description": beside(".ovr", VRT),
    "mask of a description": beside(".msk", VRT),
    "tag": lambda path, host: in_tag(path, host.name()),
    "aux.xml of the overviews": overview(beside(".aux.xml", OVERVIEWS)),
    "tag of the overviews": overview(lambda path, host: in_tag(path, host.name())),
    "UNC": lambda path, host: write_text(Path(f"{path}.aux.xml"), OVERVIEWS.format(name=r"\\host\share\a.tif")),
}


def overviews_of(path):
    dataset = open_raster(path)
    return dataset.GetRasterBand(1).GetOverviewCount()


def doors_to_all():
    return (*doors()[:3], overviews_of, require_own_pixels)


@pytest.mark.parametrize("kind", PLANTED)
def test_a_raster_with_planted_overviews_is_refused_and_nobody_is_asked(qgis_app, host, tmp_path, kind):
    path = write_raster(tmp_path / "labels.tif", LABELS)
    PLANTED[kind](path, host)
    refuse(path, doors_to_all())
    assert host.asked == []


@pytest.mark.parametrize("kind", ["aux.xml", "overviews of a web map", "tag", "aux.xml of the overviews"])
def test_an_algorithm_refuses_it_before_qgis_opens_it(run_algorithm, host, tmp_path, kind):
    path = write_raster(tmp_path / "labels.tif", LABELS)
    PLANTED[kind](path, host)
    with pytest.raises(QgsProcessingException, match=r"labels\.tif"):
        run_algorithm("semref:builddatabase", {"LABELS": str(path), "DATABASE": str(tmp_path / "area.gpkg")})
    assert host.asked == []


@pytest.mark.parametrize("suffix", [".aux.xml", ".ovr", ".msk"])
def test_a_pipe_beside_a_raster_does_not_block_it(qgis_app, tmp_path, suffix):
    path = write_raster(tmp_path / "labels.tif", LABELS)
    os.mkfifo(f"{path}{suffix}")
    refuse(path, doors_to_all())


@pytest.mark.parametrize("is_external", [True, False])
def test_ones_own_overviews_masks_and_statistics_are_read(qgis_app, tmp_path, is_external):
    path = write_raster(tmp_path / "labels.tif", np.kron(LABELS, np.ones((8, 8), np.uint8)))
    dataset = gdal.Open(str(path), gdal.GA_ReadOnly if is_external else gdal.GA_Update)
    dataset.BuildOverviews("NEAREST", [2, 4])
    dataset = None
    dataset = gdal.Open(str(path))
    dataset.GetRasterBand(1).ComputeStatistics(False)
    dataset = None
    (tmp_path / "labels.aux").write_text("\\relax")  # LaTeX's
    assert os.path.exists(f"{path}.ovr") == is_external and os.path.exists(f"{path}.aux.xml")
    assert overviews_of(str(path)) == 2
    for door in doors_to_all():
        door(str(path))
