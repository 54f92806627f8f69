"""File names in untrusted positions, projects, sets, routes and map tips are not followed elsewhere."""

import os
from pathlib import Path

import pytest
from made_inputs import NORTH, WEST, scattered_objects, write_layer, write_raster, write_text
from osgeo import gdal
from qgis.core import (
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsExpressionFunction,
    QgsFeature,
    QgsProcessingUtils,
    QgsProject,
    QgsVectorLayer,
)

from semref.core.errors import ParameterError
from semref.processing.layers.styles import style_document
from semref.storage.route_files import read_waypoint_file
from semref.ui.project_state import SCOPE, read_state

COLUMNS = [("image", "text"), ("status", "text"), ("heading", "real"), ("pixel_size", "real")]
UNC = [r"\\host\share\a.tif", "//host/share/a.tif", "file://host/share/a.tif", "/vsismb/host/a.tif"]


@pytest.fixture
def georeference(run_algorithm, tmp_path, feedback):
    """`georeference(name)`: number of images made of positions with that image name."""

    def run(name, folder=tmp_path / "positions", **more):
        folder.mkdir(exist_ok=True)
        row = f"POINT ({WEST + 200} {NORTH - 200})", name, "fix", 0.0, 1.0
        positions = write_layer(folder / "positions.gpkg", [row], COLUMNS)
        given = {"POSITIONS": str(positions), "OUTPUT": str(tmp_path / "placed"), **more}
        return run_algorithm("semref:georeferenceimages", given, feedback)["IMAGE_COUNT"]

    return run


@pytest.fixture
def outside(tmp_path):
    (tmp_path / "outside").mkdir()
    return str(write_raster(tmp_path / "outside" / "a.tif", scattered_objects(80, 90, 6, seed=1), transform=None))


@pytest.mark.parametrize(
    "name", [*UNC, "/vsicurl/{url}/a.tif", "{url}/a.tif", "WMS:{url}", "{outside}", "../outside/a.tif"]
)
def test_positions_that_name_an_image_elsewhere_get_nobody_to_open_it(georeference, host, outside, feedback, name):
    assert georeference(name.format(url=host.url, outside=outside)) == 0
    assert "which is not in the folder of the layer. Select the image" in feedback.textLog()
    assert host.asked == []


@pytest.mark.parametrize("name", ["{outside}", "../outside/a.tif", r"a.tif"])
def test_an_image_that_the_user_selects_is_taken(georeference, outside, name):
    assert georeference(name.format(outside=outside), IMAGES=[os.path.dirname(outside)]) == 1


def test_positions_of_this_session_name_images_that_the_user_chose(georeference, outside, tmp_path):
    assert georeference(outside, Path(QgsProcessingUtils.tempFolder()) / "names") == 1


@pytest.mark.parametrize("name", [*UNC, "/vsicurl/{url}/a.tif", "{url}/a.tif"])
def test_a_map_tip_does_not_ask_whether_a_picture_elsewhere_is_there(qgis_app, host, name):
    tip = style_document("footprints").documentElement().firstChildElement("mapTip").text()
    template = tip.replace("file_exists", "semref_file_exists")
    layer = QgsVectorLayer("Point?field=image:string", "a", "memory")
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    FileExists.asked.clear()
    function = FileExists()
    QgsExpression.registerFunction(function)
    try:
        for image in (name.format(url=host.url), "/home/me/a.jpg"):
            feature = QgsFeature(layer.fields())
            feature["image"] = image
            context.setFeature(feature)
            shown = QgsExpression.replaceExpressionText(template, context)
            assert ("<img" in shown) == (image == "/home/me/a.jpg"), shown
    finally:
        QgsExpression.unregisterFunction("semref_file_exists")
    assert FileExists.asked == ["/home/me/a.jpg"]


class FileExists(QgsExpressionFunction):
    """QGIS's ``file_exists``, which remembers what it was asked; QGIS keeps no reference to it."""

    asked: list = []

    def __init__(self):
        super().__init__("semref_file_exists", 1, "General", "")

    def func(self, values, context, parent, node):
        self.asked.append(values[0])
        return True

    def clone(self):
        return FileExists()


@pytest.mark.parametrize("name", [*UNC, "/vsicurl/http://host/a.gpkg", "http://host/a.gpkg"])
def test_a_project_brings_no_paths_of_other_computers(qgis_app, tmp_path, name):
    project = QgsProject()
    for key in ("/database", "/model", "/results"):
        project.writeEntry(SCOPE, key, name)
    project.writeEntry(SCOPE, "/images", [name, str(tmp_path / "a.tif")])
    state = read_state(project)
    assert (state.database, state.model, state.results) == ("", "", "")
    assert state.images == [str(tmp_path / "a.tif")]


@pytest.mark.parametrize("suffix", [".gpx", ".kml", ".kmz"])
def test_a_description_under_the_name_of_a_route_is_refused(qgis_app, host, tmp_path, suffix):
    source = f"/vsicurl/{host.url}/a.geojson"
    layer = f'<OGRVRTLayer name="a"><SrcDataSource>{source}</SrcDataSource></OGRVRTLayer>'
    text = f"<OGRVRTDataSource>{layer}</OGRVRTDataSource>"
    path = write_text(tmp_path / f"route{suffix}", text)
    with pytest.raises(ParameterError):
        read_waypoint_file(str(path))
    assert host.asked == [] and gdal.OpenEx(str(path), gdal.OF_VECTOR, ["OGR_VRT"]) is not None
