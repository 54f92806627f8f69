from pathlib import Path

import pytest
from made_inputs import read_rows, write_text
from qgis.core import (
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsGeometry,
    QgsProcessingException,
    QgsVectorFileWriter,
    QgsVectorLayer,
)

from semref.processing.compat import make_field

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
BUILDING = "field=building:string", ("yes",)


def layer_of(fields: str, *features: tuple, crs: str = "EPSG:32632") -> QgsVectorLayer:
    layer = QgsVectorLayer(f"MultiPolygon?crs={crs}&{fields}", "osm", "memory")
    for number, attributes in enumerate(features):
        x = 100 * number
        add(layer, f"MultiPolygon((({x} 0, {x + 50} 0, {x + 50} 50, {x} 0)))", attributes)
    return layer


def add(layer: QgsVectorLayer, wkt: str, attributes) -> None:
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromWkt(wkt))
    feature.setAttributes(list(attributes))
    assert layer.dataProvider().addFeatures([feature])[0]


@pytest.fixture
def extract(tmp_path):
    path = tmp_path / "extract.osm"
    path.write_text(EXTRACT, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("suffix", ["", "|layername=multipolygons"])
def test_an_extract_becomes_land_cover(run_algorithm, tmp_path, extract, suffix):
    out = str(tmp_path / "cover.gpkg")
    results = run_algorithm(CLASSIFY, {"INPUT": extract + suffix, "OUTPUT": out})
    found = {row["osm_id"]: row for row in read_rows(results["OUTPUT"])}
    assert results["FEATURE_COUNT"] == 3 and set(found) == {"11", "12", "13"}
    assert [found[key]["class"] for key in ("11", "12", "13")] == ["forest", "building", "built_up"]
    assert found["11"]["name"] == "Wood & <b>more" and found["12"]["tag"] == "building=*"
    assert found["12"]["priority"] > found["11"]["priority"]


def test_a_shapefile_that_names_values_without_keys_is_understood(run_algorithm, tmp_path):
    layer = layer_of("field=osm_id:string&field=fclass:string", ("7", "forest"), ("8", "building"), ("9", "cinema"))
    path = str(tmp_path / "gis_osm_landuse_a_free_1.shp")
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "ESRI Shapefile"
    written = QgsVectorFileWriter.writeAsVectorFormatV3(layer, path, QgsCoordinateTransformContext(), options)
    assert written[0] == QgsVectorFileWriter.NoError
    out = str(tmp_path / "cover.gpkg")
    assert run_algorithm(CLASSIFY, {"INPUT": path, "OUTPUT": out})["FEATURE_COUNT"] == 2
    assert [(row["osm_id"], row["class"]) for row in read_rows(out)] == [("7", "forest"), ("8", "building")]


def test_polygons_that_cross_themselves_are_kept_for_repair(run_algorithm, tmp_path):
    layer = layer_of(*BUILDING)
    bow = QgsGeometry.fromWkt("MultiPolygon(((0 0, 10 10, 10 0, 0 10, 0 0)))")
    assert layer.dataProvider().changeGeometryValues({1: bow})
    out = str(tmp_path / "cover.gpkg")
    assert run_algorithm(CLASSIFY, {"INPUT": layer, "OUTPUT": out})["FEATURE_COUNT"] == 1


def test_layers_without_known_tags_or_polygons_and_cut_extracts_are_refused(run_algorithm, tmp_path):
    cut = str(write_text(tmp_path / "cut.osm", EXTRACT[: EXTRACT.index('<way id="13"')]))
    for layer, message in (
        (layer_of("field=height:double", (3.5,)), "Its columns are: height"),
        (cut, "cannot be read completely"),
        (lines_of(ROAD), "“lines” has LineString geometry. Choose a polygon layer."),
    ):
        with pytest.raises(QgsProcessingException, match=message):
            run_algorithm(CLASSIFY, {"INPUT": layer, "OUTPUT": str(tmp_path / "cover.gpkg")})
        assert not (tmp_path / "cover.gpkg").exists()


def test_the_layer_is_drawn_in_the_colors_that_classes_are_known_by(run_algorithm, tmp_path):
    output = str(tmp_path / "landcover.gpkg")
    run_algorithm(CLASSIFY, {"INPUT": layer_of(*BUILDING), "OUTPUT": output})
    layer = QgsVectorLayer(output, "landcover", "ogr")
    layer.loadDefaultStyle()
    colors = {one.value(): one.symbol().color().name() for one in layer.renderer().categories()}
    assert (colors["water"], colors["forest"], colors["building"]) == ("#3a87c8", "#1f7a3a", "#c8372d")
    assert layer.renderer().orderByEnabled()


def lines_of(*features: tuple[str, dict], crs: str = "EPSG:32632") -> QgsVectorLayer:
    """Return a layer of lines as GDAL reads an extract: ``highway`` and ``waterway``, other tags packed."""
    fields = "&".join(f"field={name}:string" for name in ("osm_id", "highway", "waterway", "other_tags"))
    layer = QgsVectorLayer(f"LineString?crs={crs}&{fields}", "lines", "memory")
    for number, (wkt, tags) in enumerate(features):
        packed = ",".join(f'"{k}"=>"{v}"' for k, v in tags.items() if k not in ("highway", "waterway")) or None
        add(layer, wkt, [str(number), tags.get("highway"), tags.get("waterway"), packed])
    return layer


STRAIGHT = "LineString(600000 5200000, 600300 5200400)"
"""500 m long."""


def areas_of(run_algorithm, tmp_path, lines, **given) -> dict[str, tuple[str, float]]:
    """Return (class, area in m²) of the areas of lines by osm_id, next to one building."""
    out = str(tmp_path / "cover.gpkg")
    run_algorithm(CLASSIFY, {"INPUT": layer_of(*BUILDING), "LINES": lines, "OUTPUT": out, **given})
    return {one["osm_id"]: (one["class"], one["geometry"].GetArea()) for one in read_rows(out) if one["osm_id"]}


@pytest.mark.parametrize(
    ("tags", "name", "width"),
    [
        ({"highway": "primary", "lanes": "3", "width": "6.5 m"}, "road", 6.5),
        ({"railway": "rail"}, "road", 4),
        ({"waterway": "river", "width": "about 20"}, "water", 10),
    ],
)
def test_a_straight_line_becomes_an_area_of_its_length_and_width(run_algorithm, tmp_path, tags, name, width):
    found = areas_of(run_algorithm, tmp_path, lines_of((STRAIGHT, tags)))
    assert found["0"] == (name, pytest.approx(500 * width, rel=1e-6))


def test_widths_are_meters_for_lines_in_degrees_and_for_polygons_in_degrees(run_algorithm, tmp_path):
    east = "LineString(9 47, 9.001 47)"
    found = areas_of(run_algorithm, tmp_path, lines_of((east, {"highway": "residential"}), crs="EPSG:4326"))
    assert found["0"][1] == pytest.approx(76.06 * 5.5, rel=0.002)
    out, lines = str(tmp_path / "degrees.gpkg"), lines_of((STRAIGHT, {"highway": "track"}))
    run_algorithm(CLASSIFY, {"INPUT": layer_of(*BUILDING, crs="EPSG:4326"), "LINES": lines, "OUTPUT": out})
    left, right, bottom, top = next(row["geometry"].GetEnvelope() for row in read_rows(out) if row["osm_id"])
    assert 10.3 < left < right < 10.4 and 46.9 < bottom < top < 47


def test_tunnels_and_lines_without_a_width_leave_no_area(run_algorithm, tmp_path):
    road = {"highway": "primary"}
    kinds = [road, {**road, "tunnel": "yes"}, {"waterway": "stream", "tunnel": "culvert"}, {**road, "tunnel": "no"}]
    lines = lines_of(*((STRAIGHT, tags) for tags in (*kinds, {"highway": "path"}, {"landuse": "forest"})))
    assert set(areas_of(run_algorithm, tmp_path, lines)) == {"0", "3"}


def test_the_lines_of_an_extract_are_below_buildings_and_above_land_use(run_algorithm, tmp_path, extract):
    text = Path(extract).read_text(encoding="utf-8")
    way = '<way id="21" version="1"><nd ref="1"/><nd ref="3"/><tag k="highway" v="service"/></way></osm>'
    Path(extract).write_text(text.replace("</osm>", way), encoding="utf-8")
    out = str(tmp_path / "cover.gpkg")
    run_algorithm(CLASSIFY, {"INPUT": extract, "LINES": extract, "OUTPUT": out})
    found = {row["osm_id"]: row for row in read_rows(out)}
    assert (found["21"]["class"], found["21"]["tag"]) == ("road", "highway=service")
    assert found["12"]["priority"] > found["21"]["priority"] > found["11"]["priority"]


def test_roads_of_a_shapefile_that_names_values_without_keys_have_an_area(run_algorithm, tmp_path):
    layer = QgsVectorLayer("LineString?crs=EPSG:32632&field=osm_id:string&field=fclass:string", "roads", "memory")
    layer.dataProvider().addAttributes([make_field("tunnel", "text"), make_field("width", "integer")])
    layer.updateFields()
    for number, tunnel in enumerate("FT"):
        add(layer, STRAIGHT, [str(number), "residential", tunnel, 0])
    assert areas_of(run_algorithm, tmp_path, layer) == {"0": ("road", pytest.approx(500 * 5.5, rel=1e-6))}


ROAD = STRAIGHT, {"highway": "primary"}
WITHOUT_WIDTH = "key,value,class,priority\nbuilding,*,building,9\nhighway,*,road,8\n"


@pytest.mark.parametrize(
    ("lines", "rules", "message"),
    [
        (lambda: QgsVectorLayer("LineString?crs=EPSG:32632&field=length:double", "lines", "memory"), "", "columns are"),
        (lambda: layer_of(*BUILDING), "", "“osm” has MultiPolygon geometry. Choose a layer of lines."),
        (lambda: lines_of(ROAD, crs=""), "", "has no CRS. Set the CRS of the layer"),
        (lambda: lines_of(ROAD), WITHOUT_WIDTH, "No rule with a width matches a tag of the lines “lines”"),
        (lambda: lines_of(ROAD), "key,value,class,priority,width\nhighway,*,road,8,wide\n", "line 2: “wide” is not a"),
    ],
)
def test_lines_that_have_no_area_are_refused_with_the_reason(run_algorithm, tmp_path, capfd, lines, rules, message):
    given = {"RULES": str(write_text(tmp_path / "rules.csv", rules))} if rules else {}
    with pytest.raises(QgsProcessingException, match=message):
        areas_of(run_algorithm, tmp_path, lines(), **given)
    assert not (tmp_path / "cover.gpkg").exists() and "disk I/O error" not in capfd.readouterr().err
