"""semref:classifyopenstreetmap: an extract, columns of tags or outlines become land cover."""

from __future__ import annotations

import pytest
from qgis.core import (
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsGeometry,
    QgsProcessingException,
    QgsVectorFileWriter,
    QgsVectorLayer,
)

CLASSIFY = "semref:classifyopenstreetmap"

NODES = {1: (9.5, 47.1), 2: (9.501, 47.1), 3: (9.501, 47.101), 4: (9.5, 47.101), 5: (9.5002, 47.1004)}
EXTRACT = (
    '<?xml version="1.0"?><osm version="0.6">'
    + "".join(f'<node id="{n}" lon="{x}" lat="{y}" version="1"/>' for n, (x, y) in NODES.items())
    + "".join(
        f'<way id="{way}" version="1">'
        + "".join(f'<nd ref="{n}"/>' for n in (*nodes, nodes[0]))
        + "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        + "</way>"
        for way, nodes, tags in (
            (11, (1, 2, 3, 4), {"landuse": "forest", "name": "Wood &amp; &lt;b&gt;more"}),
            (12, (1, 2, 5), {"building": "house"}),
            (13, (1, 3, 5), {"area:highway": "footway", "area": "yes"}),
            (14, (1, 4, 5), {"boundary": "administrative", "area": "yes"}),
        )
    )
    + "</osm>"
)


def rows_of(layer: str) -> list[dict]:
    read = QgsVectorLayer(layer, "read", "ogr")
    assert read.isValid()
    return [dict(zip(read.fields().names(), feature.attributes())) for feature in read.getFeatures()]


def layer_of(fields: str, *features: tuple) -> QgsVectorLayer:
    layer = QgsVectorLayer(f"MultiPolygon?crs=EPSG:25832&{fields}", "osm", "memory")
    for number, attributes in enumerate(features):
        feature = QgsFeature(layer.fields())
        x = 100 * number
        feature.setGeometry(QgsGeometry.fromWkt(f"MultiPolygon((({x} 0, {x + 50} 0, {x + 50} 50, {x} 0)))"))
        feature.setAttributes(list(attributes))
        assert layer.dataProvider().addFeatures([feature])[0]
    return layer


@pytest.fixture
def extract(tmp_path):
    path = tmp_path / "extract.osm"
    path.write_text(EXTRACT, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("suffix", ["", "|layername=multipolygons"])
def test_an_extract_becomes_land_cover(run_algorithm, tmp_path, extract, suffix):
    out = str(tmp_path / "cover.gpkg")
    told = run_algorithm(CLASSIFY, {"INPUT": extract + suffix, "OUTPUT": out})
    found = {row["osm_id"]: row for row in rows_of(told["OUTPUT"])}
    assert told["FEATURE_COUNT"] == 3 and set(found) == {"11", "12", "13"}
    assert [found[key]["class"] for key in ("11", "12", "13")] == ["forest", "building", "built_up"]
    assert found["11"]["name"] == "Wood & <b>more" and found["12"]["tag"] == "building=*"
    assert found["12"]["priority"] > found["11"]["priority"]


def test_buildings_are_on_top_in_the_label_map_of_an_extract(run_algorithm, tmp_path, extract):
    cover = run_algorithm(CLASSIFY, {"INPUT": extract, "OUTPUT": str(tmp_path / "cover.gpkg")})["OUTPUT"]
    given = {"INPUT": cover, "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority", "PIXEL_SIZE": 1}
    told = run_algorithm(
        "semref:rasterizeannotation", {**given, "TARGET_CRS": "EPSG:32632", "OUTPUT": str(tmp_path / "map.tif")}
    )
    assert told["CLASS_COUNT"] == 3


def test_a_shapefile_that_names_values_without_keys_is_understood(run_algorithm, tmp_path):
    layer = layer_of("field=osm_id:string&field=fclass:string", ("7", "forest"), ("8", "building"), ("9", "cinema"))
    path = str(tmp_path / "gis_osm_landuse_a_free_1.shp")
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "ESRI Shapefile"
    written = QgsVectorFileWriter.writeAsVectorFormatV3(layer, path, QgsCoordinateTransformContext(), options)
    assert written[0] == QgsVectorFileWriter.NoError
    out = str(tmp_path / "cover.gpkg")
    assert run_algorithm(CLASSIFY, {"INPUT": path, "OUTPUT": out})["FEATURE_COUNT"] == 2
    assert [(row["osm_id"], row["class"]) for row in rows_of(out)] == [("7", "forest"), ("8", "building")]


def test_polygons_that_cross_themselves_are_kept_for_repair(run_algorithm, tmp_path):
    layer = layer_of("field=building:string", ("yes",))
    bow = QgsGeometry.fromWkt("MultiPolygon(((0 0, 10 10, 10 0, 0 10, 0 0)))")
    assert layer.dataProvider().changeGeometryValues({1: bow})
    out = str(tmp_path / "cover.gpkg")
    assert run_algorithm(CLASSIFY, {"INPUT": layer, "OUTPUT": out})["FEATURE_COUNT"] == 1


def test_a_layer_without_known_tags_is_refused_with_its_columns(run_algorithm, tmp_path):
    layer = layer_of("field=height:double", (3.5,))
    with pytest.raises(QgsProcessingException, match="Its columns are: height"):
        run_algorithm(CLASSIFY, {"INPUT": layer, "OUTPUT": str(tmp_path / "cover.gpkg")})
    assert not (tmp_path / "cover.gpkg").exists()


def test_an_extract_that_is_cut_short_is_refused(run_algorithm, tmp_path, extract):
    cut = tmp_path / "cut.osm"
    cut.write_text(EXTRACT[: EXTRACT.index('<way id="13"')], encoding="utf-8")
    with pytest.raises(QgsProcessingException, match="cannot be read completely"):
        run_algorithm(CLASSIFY, {"INPUT": str(cut), "OUTPUT": str(tmp_path / "cover.gpkg")})
    assert not (tmp_path / "cover.gpkg").exists()


def test_the_layer_is_drawn_in_the_colors_that_classes_are_known_by(run_algorithm, tmp_path):
    output = str(tmp_path / "landcover.gpkg")
    run_algorithm(CLASSIFY, {"INPUT": layer_of("field=building:string", ("yes",)), "OUTPUT": output})
    layer = QgsVectorLayer(output, "landcover", "ogr")
    layer.loadDefaultStyle()
    colors = {one.value(): one.symbol().color().name() for one in layer.renderer().categories()}
    assert (colors["water"], colors["forest"], colors["building"]) == ("#3a87c8", "#1f7a3a", "#c8372d")
    assert layer.renderer().orderByEnabled()
