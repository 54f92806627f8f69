"""What layers come with beside their features: styles, titles of columns, map tips, forms, labels, what made them."""

from __future__ import annotations

import contextlib
import itertools
import sqlite3
import tempfile

import pytest
from made_inputs import square, write_layer
from qgis.core import (
    QgsEditFormConfig,
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeature,
    QgsGeometry,
    QgsGraduatedSymbolRenderer,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)

from semref.core.evaluation.as_json import FIELDS as TRIAL_FIELDS
from semref.processing.exchange.assessment_styles import cells_look, route_look
from semref.processing.exchange.flight_styles import poses_look, track_look
from semref.processing.exchange.layer_looks import changes_look, disagreements_look, issues_look, trials_look
from semref.processing.exchange.position_looks import footprints_look, matches_look, places_look, positions_look
from semref.processing.framework.localized_image import ALTERNATIVE_FIELDS, FOOTPRINT_FIELDS, MATCH_FIELDS
from semref.processing.framework.localized_layers import FLIGHT_FIELDS, POSITION_FIELDS
from semref.processing.wording.annotation_messages import FIELDS as ISSUE_FIELDS

KINDS = {"text": "string", "real": "double", "integer": "int", "boolean": "bool", "datetime": "datetime"}


def layer_of(geometry: str, fields) -> QgsVectorLayer:
    columns = "&".join(f"field={name}:{KINDS.get(kind, 'int8')}" for name, kind in fields)
    return QgsVectorLayer(f"{geometry}?crs=EPSG:32632&{columns}", "layer", "memory")


def feature_of(layer: QgsVectorLayer, **values) -> QgsFeature:
    feature = QgsFeature(layer.fields())
    for name, value in values.items():
        feature[name] = value
    feature.setGeometry(QgsGeometry.fromWkt("POINT(1 2)"))
    return feature


def tip_of(layer: QgsVectorLayer, feature: QgsFeature) -> str:
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    return QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context)


@pytest.fixture
def positions(qgis_app):
    layer = layer_of("Point", POSITION_FIELDS)
    positions_look(is_timed=True).give(layer)
    return layer


LOOKS = [
    ("Point", POSITION_FIELDS, lambda: positions_look(True)),
    ("Point", POSITION_FIELDS, lambda: poses_look(False)),
    ("Polygon", FOOTPRINT_FIELDS, footprints_look),
    ("Polygon", ALTERNATIVE_FIELDS, places_look),
    ("Point", MATCH_FIELDS, matches_look),
    ("LineString", (), track_look),
    ("Polygon", ISSUE_FIELDS, issues_look),
    ("Polygon", ISSUE_FIELDS, changes_look),
    ("Polygon", (), disagreements_look),
    ("Polygon", (), lambda: cells_look(0.9, 300.0, True)),
    ("Point", (), lambda: route_look(0.9)),
    ("Point", TRIAL_FIELDS, trials_look),
]


@pytest.mark.parametrize(("geometry", "fields", "look"), LOOKS)
def test_no_map_tip_or_label_of_any_look_has_an_error_in_it(qgis_app, geometry, fields, look):
    layer = layer_of(geometry, fields)
    look().give(layer)
    tip = layer.mapTipTemplate()
    parts = [part.partition("%]")[0] for part in tip.split("[%")[1:]]
    assert parts
    for part in filter(None, [*parts, layer.displayExpression()]):
        parsed = QgsExpression(part)
        assert not parsed.hasParserError(), (part, parsed.parserErrorString())


@pytest.mark.parametrize(("geometry", "fields", "look"), [look for look in LOOKS if look[1]])
def test_every_column_has_a_title_that_is_not_its_key(qgis_app, geometry, fields, look):
    layer = layer_of(geometry, fields)
    look().give(layer)
    titles = [layer.attributeAlias(index) for index in range(len(layer.fields()))]
    assert all(titles)
    assert len(set(titles)) == len(titles)


def test_the_map_tip_shows_status_radius_and_error_probability(positions):
    values = {"image": "/photos/a & b.jpg", "status": "fix", "method": "constellation", "error_95": 2.34}
    tip = tip_of(positions, feature_of(positions, **values, confidence=1 - 1 / 1234))
    assert "<b>a &amp; b.jpg</b>" in tip
    assert "<b>Fix</b>" in tip and "<b>Constellation</b>" in tip
    assert "2.3\u00a0m" in tip
    assert "<b>1 in 1,200</b>" in tip
    # Nothing is known of the heading: the line is left out.
    assert "Heading" not in tip


@pytest.mark.parametrize("risk", [1e-6, 1e-9, 1e-12, 0.0])
def test_a_map_tip_shows_no_smaller_error_probability_than_was_tested(positions, risk):
    values = {"image": "a.tif", "status": "fix", "method": "constellation", "confidence": 1 - risk}
    tip = tip_of(positions, feature_of(positions, **values))
    assert "<td>Error probability</td><td><b>below 1 in 10,000</b></td>" in tip


def test_a_sentence_has_as_many_lines_in_a_form_as_it_takes(positions):
    setup = positions.editorWidgetSetup(positions.fields().lookupField("reason"))
    assert setup.type() == "TextEdit" and setup.config()["IsMultiline"]


def test_the_map_tip_shows_a_status_that_has_no_words_as_it_is(positions):
    tip = tip_of(positions, feature_of(positions, image="a.tif", status="<img src='file:///seen.png'>"))
    assert "<img" not in tip and "&lt;img src=" in tip


def test_the_confidence_of_topology_vectors_is_not_told_as_a_probability(positions):
    values = {"image": "a.tif", "status": "fix", "method": "topology vector", "confidence": 0.8}
    assert "Wrong once in" not in tip_of(positions, feature_of(positions, **values))


def test_the_map_tip_shows_the_picture_where_it_is_whatever_its_name(positions, tmp_path):
    picture = tmp_path / 'photo #1 100%25 "a".png'
    picture.write_bytes(b"")
    tip = tip_of(positions, feature_of(positions, image=str(picture), status="fix"))
    assert f'src="file:///{str(tmp_path).lstrip("/")}/photo%20%231%20100%2525%20%22a%22.png"' in tip
    assert "<img" not in tip_of(positions, feature_of(positions, image=str(tmp_path / "gone.png"), status="fix"))


def test_positions_are_labeled_by_their_images_played_by_time_and_have_a_form_of_pages(positions):
    assert positions.labelsEnabled()
    assert positions.labeling().settings().fieldName == 'base_file_name("image")'
    assert positions.temporalProperties().isActive() and positions.temporalProperties().startField() == "time"
    form = positions.editFormConfig()
    assert form.layout() == QgsEditFormConfig.TabLayout
    assert [page.name() for page in form.tabs()] == ["Image", "Position", "How exactly", "How it was found"]
    shown = [child.name() for page in form.tabs() for child in page.children()]
    assert sorted(shown) == sorted(field.name() for field in positions.fields())


@pytest.mark.parametrize(
    ("look", "values", "rule"),
    [
        (lambda: positions_look(True), {"heading": 10.0, "jump": False}, "Fix, with its heading"),
        (lambda: positions_look(True), {"heading": 10.0}, "Fix, with its heading"),
        (lambda: positions_look(True), {"jump": False}, "Fix without a heading"),
        (lambda: positions_look(True), {"heading": 10.0, "jump": True}, "Out of reach in time"),
        (lambda: poses_look(True), {"source": "own", "outvoted": False}, "Fix of the image itself"),
        (lambda: poses_look(True), {"source": "flight", "outvoted": False}, "Placed by the flight"),
        (lambda: poses_look(True), {"source": "flight"}, "Placed by the flight"),
        (lambda: poses_look(True), {"source": "flight", "outvoted": True}, "Its own fix was outvoted"),
    ],
)
def test_every_kind_of_position_is_drawn_by_one_rule(qgis_app, look, values, rule):
    layer = layer_of("Point", FLIGHT_FIELDS)
    feature = feature_of(layer, **values)
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    renderer = look().renderer
    rules = renderer.rootRule().children()
    drawn = [one.label() for one in rules if QgsExpression(one.filterExpression()).evaluate(context)]
    assert drawn == [rule]


def test_keys_have_words_in_the_attribute_table(positions):
    index = positions.fields().lookupField("status")
    words = positions.editorWidgetSetup(index).config()["map"]
    assert {"No match": "no_match"} in words and {"could not be read": "error"} in words


def test_squares_let_the_base_map_through_and_the_route_does_not(qgis_app):
    cells, route = cells_look(0.9, 300.0, True).renderer, route_look(0.9).renderer
    assert isinstance(cells, QgsGraduatedSymbolRenderer)
    assert {symbol.opacity() for symbol in cells.symbols(_context())} == {0.5}
    assert {symbol.opacity() for symbol in route.symbols(_context())} == {1.0}
    colors = [[one.symbol().color().name() for one in renderer.ranges()] for renderer in (cells, route)]
    assert colors[0] == ["#ffea46", "#bcad6c", "#7c7b78", "#46516c", "#00204d"]


def _context():
    from qgis.core import QgsRenderContext

    return QgsRenderContext()


@pytest.fixture
def annotation(qgis_app, tmp_path):
    features = [(square(10 + 40 * n, 10, 30), name) for n, name in enumerate(("water", "forest"))]
    layer = QgsVectorLayer(str(write_layer(tmp_path / "annotation.gpkg", features)), "My annotation", "ogr")
    told = layer.metadata()
    told.setLicenses(["CC BY 4.0"])
    told.setRights(["© a surveyor"])
    layer.setMetadata(told)
    QgsProject.instance().addMapLayer(layer)
    yield layer
    QgsProject.instance().removeMapLayer(layer)


def test_a_layer_tells_what_it_is_what_made_it_and_the_license_of_its_source(annotation, run_algorithm, tmp_path):
    output = str(tmp_path / "issues.gpkg")
    run_algorithm("semref:checkannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "ISSUES": output})
    told = QgsVectorLayer(output, "issues", "ogr").metadata()
    assert told.title() == "Issues"
    assert told.abstract().startswith("One feature a finding")
    assert told.rights() == ["My annotation (CC BY 4.0, © a surveyor)"]
    (line,) = told.history()
    assert 'processing.run("semref:checkannotation"' in line and "'CLASS_FIELD':'class'" in line


@pytest.mark.parametrize("name", ["target", "zipcodes"])
def test_a_name_that_reads_like_an_archive_is_one_as_any(annotation, run_algorithm, tmp_path, name, monkeypatch):
    """QGIS looks for an archive where a dot stands before zip, tar or gz: outputs lie beside such names for a while."""
    monkeypatch.setattr(tempfile, "_get_candidate_names", lambda: (f"gz{n}" for n in itertools.count()))
    out = str(tmp_path / f"{name}.gpkg")
    run_algorithm("semref:repairannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "OUTPUT": out})
    with contextlib.closing(sqlite3.connect(out)) as connection:
        assert len(connection.execute("SELECT * FROM layer_styles").fetchall()) == 1
        noted = connection.execute("SELECT metadata FROM gpkg_metadata").fetchall()
    assert any("<history>" in text for (text,) in noted)


def test_in_a_folder_that_reads_like_an_archive_a_layer_comes_without_its_note(annotation, run_algorithm, tmp_path):
    (tmp_path / "maps.tar").mkdir()
    out = str(tmp_path / "maps.tar" / "clean.gpkg")
    told = run_algorithm("semref:repairannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "OUTPUT": out})
    assert told["OUTPUT"] == out
    with contextlib.closing(sqlite3.connect(out)) as connection:
        assert connection.execute("SELECT count(*) FROM layer_styles").fetchone() == (1,)


def test_a_label_map_tells_the_same_beside_it(annotation, run_algorithm, tmp_path):
    output = tmp_path / "labels.tif"
    run_algorithm("semref:rasterizeannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "OUTPUT": str(output)})
    layer = QgsRasterLayer(str(output), "labels")
    # As QGIS does when it adds a raster to a map.
    layer.loadDefaultMetadata()
    told = layer.metadata()
    assert told.title() == "Label map"
    assert told.rights() == ["My annotation (CC BY 4.0, © a surveyor)"]
    assert (tmp_path / "labels.qmd").is_file()


def test_a_layer_in_memory_comes_with_its_look_as_well(annotation, run_algorithm):
    given = {"INPUT": annotation, "CLASS_FIELD": "class", "ISSUES": "TEMPORARY_OUTPUT"}
    layer = run_algorithm("semref:checkannotation", given)["ISSUES"]
    assert layer.attributeAlias(layer.fields().lookupField("severity")) == "Severity"
    assert layer.metadata().title() == "Issues"


def test_every_column_of_an_assessment_and_every_verdict_has_its_word(qgis_app):
    from semref.core.assessment.squares import FIELDS, VERDICTS
    from semref.processing.exchange.assessment_styles import COLORS
    from semref.processing.wording.columns import column_titles, verdict_words

    assert {name for name, _ in FIELDS} <= set(column_titles())
    assert tuple(verdict_words()) == VERDICTS and len(COLORS) == len(VERDICTS)
