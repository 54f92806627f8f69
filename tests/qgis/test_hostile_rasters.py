"""Rasters are opened only by the driver of their suffix, so that untrusted files contact no server."""

import numpy as np
import pytest
from listening import listening
from made_inputs import scattered_objects, write_raster

from semref.core.errors import SemRefError
from semref.core.labels.class_table import class_table_from_values
from semref.core.labels.image_files import read_photo
from semref.storage.images import GdalImage
from semref.storage.label_images import read_label_image
from semref.storage.label_maps import GdalLabels
from semref.storage.rasters import open_raster

LABELS = scattered_objects(80, 90, 6, seed=1)

WMS = (
    '<GDAL_WMS><Service name="TMS"><ServerUrl>http://127.0.0.1:{port}/${{z}}/${{x}}/${{y}}.png</ServerUrl></Service>'
    "<DataWindow><UpperLeftX>0</UpperLeftX><UpperLeftY>90</UpperLeftY><LowerRightX>90</LowerRightX>"
    "<LowerRightY>0</LowerRightY><SizeX>90</SizeX><SizeY>80</SizeY></DataWindow><BandsCount>1</BandsCount>"
    "<ZeroBlockHttpCodes>404</ZeroBlockHttpCodes></GDAL_WMS>"
)
VRT = (
    '<VRTDataset rasterXSize="90" rasterYSize="80"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
    '<SourceFilename relativeToVRT="0">{source}</SourceFilename><SourceBand>1</SourceBand>'
    '<SourceProperties RasterXSize="90" RasterYSize="80" DataType="Byte"/></SimpleSource></VRTRasterBand></VRTDataset>'
)


@pytest.fixture
def host():
    with listening() as server:
        yield server


def doors():
    return (
        lambda path: GdalImage(path).read(0, 0, 80, 80),
        lambda path: GdalLabels(path).read(0, 0, 80, 80),
        lambda path: read_label_image(path, class_table_from_values([1, 2, 3, 4])),
        lambda path: open_raster(path),
    )


@pytest.mark.parametrize("suffix", [".png", ".tif", ".jpg", ".dat", ""])
@pytest.mark.parametrize("content", ["wms", "curl", "local"])
def test_a_description_under_the_name_of_a_picture_is_refused(qgis_app, host, tmp_path, suffix, content):
    write_raster(tmp_path / "secret.tif", LABELS)
    port = host.server_port
    texts = {
        "wms": WMS.format(port=port),
        "curl": VRT.format(source=f"/vsicurl/http://127.0.0.1:{port}/a.tif"),
        "local": VRT.format(source=tmp_path / "secret.tif"),
    }
    path = tmp_path / f"picture{suffix}"
    path.write_text(texts[content], encoding="utf-8")
    for door in doors():
        with pytest.raises(SemRefError) as refused:
            door(str(path))
        assert str(path) in str(refused.value)
    assert host.asked == []


def test_a_description_that_the_user_named_as_such_is_read(qgis_app, tmp_path):
    write_raster(tmp_path / "labels.tif", LABELS)
    (tmp_path / "named.vrt").write_text(VRT.format(source=tmp_path / "labels.tif"), encoding="utf-8")
    for name in (f"{tmp_path}/named.vrt", f"/vsisubfile/0_100000000,{tmp_path}/labels.tif"):
        np.testing.assert_array_equal(GdalLabels(name).read(0, 0, 90, 80), LABELS)


@pytest.mark.parametrize("name", ["labels.png", "labels.jpg", "labels.JPEG"])
def test_a_picture_under_the_name_of_another_kind_is_refused(qgis_app, tmp_path, name):
    write_raster(tmp_path / "labels.tif", LABELS)
    path = (tmp_path / "labels.tif").rename(tmp_path / name)
    for door in (*doors(), read_photo):
        with pytest.raises(SemRefError, match=r"its content is TIFF\. Change the suffix to \.tif"):
            door(str(path))


def test_a_picture_without_a_suffix_is_read(qgis_app, tmp_path):
    write_raster(tmp_path / "labels.tif", LABELS)
    (tmp_path / "labels.tif").rename(tmp_path / "labels.dat")
    np.testing.assert_array_equal(GdalLabels(str(tmp_path / "labels.dat")).read(0, 0, 90, 80), LABELS)


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
