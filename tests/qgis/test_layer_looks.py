"""Appearance of layers and metadata of databases: styles, titles, map tips, forms, history, licenses."""

import contextlib
import itertools
import sqlite3
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from made_inputs import NAMES, scattered_objects, square, write_layer, write_raster
from qgis.core import (
    QgsEditFormConfig,
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeature,
    QgsGeometry,
    QgsGraduatedSymbolRenderer,
    QgsLayerMetadata,
    QgsProject,
    QgsProviderRegistry,
    QgsRasterLayer,
    QgsRenderContext,
    QgsVectorLayer,
)

from semref.core.assessment import squares
from semref.core.assessment.squares import VERDICTS
from semref.core.evaluation import as_json
from semref.processing.algorithms import assess_route, compare_labels, describe_image
from semref.processing.jobs import localized_layers, segmented_files
from semref.processing.layers import palette, styles
from semref.processing.layers.class_styles import COLORS, cells_renderer, route_renderer
from semref.processing.layers.database_layers import add_database_to_map
from semref.processing.layers.layer_metadata import Note
from semref.processing.layers.output_style import Look
from semref.processing.layers.styles import STYLES
from semref.processing.messages import annotation_messages
from semref.processing.messages.columns import verdict_words
from semref.storage.database.schema import WINDOW_FIELDS

WITHOUT_DOUBT = {}, {"jump": False}, {"status": "fix"}
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


def context_of(layer: QgsVectorLayer, feature: QgsFeature) -> QgsExpressionContext:
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(layer))
    context.setFeature(feature)
    return context


def tip_of(layer: QgsVectorLayer, **values) -> str:
    context = context_of(layer, feature_of(layer, **{"image": "a.tif", "status": "fix", **values}))
    return QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context)


@pytest.fixture
def positions(qgis_app):
    layer = layer_of("Point", localized_layers.POSITION_FIELDS)
    Look("positions", is_timed=True).apply(layer)
    return layer


LAYERS = {
    "positions": ("Point", localized_layers.POSITION_FIELDS),
    "poses": ("Point", localized_layers.FLIGHT_FIELDS),
    "footprints": ("Polygon", localized_layers.FOOTPRINT_FIELDS),
    "places": ("Polygon", localized_layers.ALTERNATIVE_FIELDS),
    "matches": ("Point", localized_layers.MATCH_FIELDS),
    "track": ("LineString", localized_layers.TRACK_FIELDS),
    "issues": ("Polygon", annotation_messages.FIELDS),
    "changes": ("Polygon", annotation_messages.FIELDS),
    "disagreements": ("Polygon", compare_labels.FIELDS),
    "cells": ("Polygon", squares.FIELDS),
    "route": ("Point", assess_route.FIELDS),
    "trials": ("Point", as_json.FIELDS),
    "class_polygons": ("Polygon", segmented_files.FIELDS),
    "landmarks": ("Point", describe_image.FIELDS),
    "windows": ("Polygon", WINDOW_FIELDS),
}


def styled(style: str) -> QgsVectorLayer:
    layer = layer_of(*LAYERS[style])
    Look(style).apply(layer)
    return layer


def test_every_style_is_of_a_layer(qgis_app):
    assert {path.stem for path in STYLES.iterdir()} == {*LAYERS, "columns", "labels", "percent"}


@pytest.mark.parametrize("style", LAYERS)
def test_every_column_has_its_title_and_description_and_map_tips_and_labels_no_error(qgis_app, style, repository):
    layer = styled(style)
    parts = [part.partition("%]")[0] for part in layer.mapTipTemplate().split("[%")[1:]]
    assert parts or style == "windows"
    for part in [*parts, layer.displayExpression()]:
        parsed = QgsExpression(part)
        assert not parsed.hasParserError(), (part, parsed.parserErrorString())
    titles = {field.name(): layer.attributeAlias(n) for n, field in enumerate(layer.fields())}
    assert [name for name, title in titles.items() if not title] == [], "add their titles to columns.qml"
    page = (repository / "docs" / "reference" / "file_formats.md").read_text(encoding="utf-8")
    assert [name for name in titles if f"`{name}`" not in page] == [], "add these columns to the page"
    assert len(set(titles.values())) == len(titles)


def test_texts_of_styles_are_in_the_user_s_language(qgis_app, monkeypatch):
    monkeypatch.setattr(styles, "tr", lambda text: f"l'{text} & %]")
    layer = styled("positions")
    assert layer.attributeAlias(0) == "l'Image & %]"
    assert [rule.label() for rule in layer.renderer().rootRule().children()][0] == "l'Position with heading & %]"
    assert layer.editFormConfig().tabs()[0].name() == "l'Image & %]"
    tip = tip_of(layer, image="a.tif", status="fix", method="constellation", confidence=1.0)
    assert "<td>l&#x27;Error probability &amp; % ]</td><td><b>l&#x27;below 1 in 10,000 &amp; % ]</b>" in tip


def test_translations_have_the_texts_of_styles(qgis_app, monkeypatch, repository):
    known = {one.text for one in ElementTree.parse(repository / "i18n" / "semref_de.ts").iter("source")}
    asked = set()
    monkeypatch.setattr(styles, "tr", lambda text: asked.add(text) or text)
    for path in STYLES.iterdir():
        styles.style_document(path.stem)
    assert asked and asked <= known


def test_the_map_tip_shows_status_radius_and_error_probability(positions):
    values = {"image": "/photos/a & b.jpg", "status": "fix", "method": "constellation", "error_95": 2.34}
    tip = tip_of(positions, **values, confidence=1 - 1 / 1234)
    assert all(f"<b>{text}</b>" in tip for text in ("a &amp; b.jpg", "Position", "Constellation"))
    assert "2.3\u00a0m" in tip and "<b>1 in 1,200</b>" in tip
    # The heading is unknown, so its line is left out.
    assert "Heading" not in tip


@pytest.mark.parametrize("risk", [1e-6, 1e-9, 1e-12, 0.0])
def test_a_map_tip_shows_no_smaller_error_probability_than_was_tested(positions, risk):
    tip = tip_of(positions, method="constellation", confidence=1 - risk)
    assert "<td>Error probability</td><td><b>below 1 in 10,000</b></td>" in tip


def test_the_map_tip_shows_an_unknown_status_unchanged_and_no_probability_of_topology_vectors(positions):
    tip = tip_of(positions, status="<img src='file:///seen.png'>")
    assert "<img" not in tip and "&lt;img src=" in tip
    assert "Error probability" not in tip_of(positions, method="topology vector", confidence=0.8)


def test_the_map_tip_shows_the_picture_where_it_is_whatever_its_name(positions, tmp_path):
    picture = tmp_path / 'photo #1 100%25 "a".png'
    picture.write_bytes(b"")
    tip = tip_of(positions, image=str(picture), status="fix")
    assert f'src="file:///{str(tmp_path).lstrip("/")}/photo%20%231%20100%2525%20%22a%22.png"' in tip
    assert "<img" not in tip_of(positions, image=str(tmp_path / "gone.png"), status="fix")


def test_positions_are_labeled_by_their_images_played_by_time_and_have_a_form_of_pages(positions):
    assert positions.labelsEnabled()
    assert positions.labeling().settings().fieldName == 'base_file_name("image")'
    assert positions.temporalProperties().isActive() and positions.temporalProperties().startField() == "time"
    assert positions.editFormConfig().layout() == QgsEditFormConfig.TabLayout


@pytest.mark.parametrize("style", ["positions", "poses"])
def test_the_form_of_positions_shows_each_column_on_one_page(qgis_app, style):
    layer = styled(style)
    pages = layer.editFormConfig().tabs()
    assert {"Image", "Position", "Accuracy", "Method"} <= {page.name() for page in pages}
    shown = [child.name() for page in pages for child in page.children()]
    assert sorted(shown) == sorted(field.name() for field in layer.fields()), f"change the form in {style}.qml"


@pytest.mark.parametrize(
    ("style", "values", "rule"),
    [
        *(("positions", {"heading": 10.0, **more}, "Position with heading") for more in WITHOUT_DOUBT),
        ("positions", {"jump": False}, "Position without heading"),
        ("positions", {"heading": 10.0, "jump": True}, "Faster than the maximum speed"),
        ("positions", {"heading": 10.0, "status": "likely"}, "Likely position"),
        ("footprints", {"status": "fix"}, "Position"),
        ("footprints", {"status": "likely"}, "Likely position"),
        ("trials", {"status": "likely"}, "likely position"),
        ("poses", {"source": "own", "outvoted": False}, "Own position"),
        ("poses", {"source": "flight", "outvoted": False}, "Position from the flight"),
        ("poses", {"source": "flight"}, "Position from the flight"),
        ("poses", {"source": "flight", "outvoted": True}, "Own position outvoted"),
        *(("poses", {"source": one, "status": "likely"}, "Likely position") for one in ("own", "flight")),
    ],
)
def test_every_kind_of_position_is_drawn_by_one_rule(qgis_app, style, values, rule):
    geometry, fields = LAYERS[style]
    layer = layer_of(geometry, localized_layers.FLIGHT_FIELDS if style == "positions" else fields)
    Look(style).apply(layer)
    context = context_of(layer, feature_of(layer, **values))
    rules = layer.renderer().rootRule().children()
    drawn = [one.label() for one in rules if QgsExpression(one.filterExpression()).evaluate(context)]
    assert drawn == [rule]


def test_a_likely_position_has_one_color_in_all_layers_and_lists(qgis_app):
    *by_rules, places = (
        styles.style_renderer(style) for style in ("positions", "poses", "footprints", "trials", "places")
    )
    rules = [rule for renderer in by_rules for rule in renderer.rootRule().children()]
    likely = [rule.symbol() for rule in rules if rule.label().lower() == "likely position"]
    assert [symbol.color().name() for symbol in (*likely, places.symbol())] == 5 * [palette.WARNING]
    sign = STYLES.parent / "severity" / "likely.svg"
    assert f'fill="{palette.WARNING}"' in sign.read_text(encoding="utf-8")


def test_keys_have_labels_in_the_attribute_table(positions):
    index = positions.fields().lookupField("status")
    words = positions.editorWidgetSetup(index).config()["map"]
    assert {"No match": "no_match"} in words and {"cannot be read": "error"} in words


def test_squares_let_the_base_map_through_and_the_route_does_not(qgis_app):
    cells, route = cells_renderer(0.9, 300.0, True), route_renderer(0.9)
    assert isinstance(cells, QgsGraduatedSymbolRenderer)
    assert {symbol.opacity() for symbol in cells.symbols(QgsRenderContext())} == {0.5}
    assert {symbol.opacity() for symbol in route.symbols(QgsRenderContext())} == {1.0}
    colors = [[one.symbol().color().name() for one in renderer.ranges()] for renderer in (cells, route)]
    assert colors[0] == ["#ffea46", "#bcad6c", "#7c7b78", "#46516c", "#00204d"]


@pytest.fixture
def annotation(qgis_app, tmp_path):
    features = [(square(10 + 40 * n, 10, 30), name) for n, name in enumerate(("water", "forest"))]
    layer = QgsVectorLayer(str(write_layer(tmp_path / "annotation.gpkg", features)), "My annotation", "ogr")
    metadata = layer.metadata()
    metadata.setLicenses(["CC BY 4.0"])
    metadata.setRights(["© a surveyor"])
    layer.setMetadata(metadata)
    QgsProject.instance().addMapLayer(layer)
    yield layer
    QgsProject.instance().removeMapLayer(layer)


def test_a_layer_has_a_title_a_history_and_the_license_of_its_source(annotation, run_algorithm, tmp_path):
    output = str(tmp_path / "issues.gpkg")
    run_algorithm("semref:checkannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "ISSUES": output})
    metadata = QgsVectorLayer(output, "issues", "ogr").metadata()
    assert metadata.title() == "Issues"
    assert metadata.abstract().startswith("One feature for each finding")
    assert metadata.rights() == ["My annotation (CC BY 4.0, © a surveyor)"]
    (line,) = metadata.history()
    assert 'processing.run("semref:checkannotation"' in line and "'CLASS_FIELD':'class'" in line


@pytest.mark.parametrize("name", ["target", "zipcodes"])
def test_a_name_that_reads_like_an_archive_is_one_as_any(annotation, run_algorithm, tmp_path, name, monkeypatch):
    """QGIS looks for an archive at a dot before zip, tar or gz; temporary outputs may have such names."""
    monkeypatch.setattr(tempfile, "_get_candidate_names", lambda: (f"gz{n}" for n in itertools.count()))
    out = str(tmp_path / f"{name}.gpkg")
    run_algorithm("semref:repairannotation", {"INPUT": annotation, "CLASS_FIELD": "class", "OUTPUT": out})
    with contextlib.closing(sqlite3.connect(out)) as connection:
        assert len(connection.execute("SELECT * FROM layer_styles").fetchall()) == 1
        noted = connection.execute("SELECT metadata FROM gpkg_metadata").fetchall()
    assert any("<history>" in text for (text,) in noted)


def test_a_label_map_has_the_same_metadata_beside_it_and_a_memory_layer_its_look(annotation, run_algorithm, tmp_path):
    given, output = {"INPUT": annotation, "CLASS_FIELD": "class"}, tmp_path / "labels.tif"
    run_algorithm("semref:rasterizeannotation", {**given, "OUTPUT": str(output)})
    layer = QgsRasterLayer(str(output), "labels")
    # As when QGIS adds a raster to a map.
    layer.loadDefaultMetadata()
    metadata = layer.metadata()
    assert metadata.title() == "Label map" and metadata.rights() == ["My annotation (CC BY 4.0, © a surveyor)"]
    assert (tmp_path / "labels.qmd").is_file()
    layer = run_algorithm("semref:checkannotation", {**given, "ISSUES": "TEMPORARY_OUTPUT"})["ISSUES"]
    assert layer.attributeAlias(layer.fields().lookupField("severity")) == "Severity"
    assert layer.metadata().title() == "Issues"


def test_every_verdict_has_its_word_and_color(qgis_app):
    assert tuple(verdict_words()) == VERDICTS and len(COLORS) == len(VERDICTS)


BUILD, UPDATE, LOCALIZE = "semref:builddatabase", "semref:updatedatabase", "semref:localizeimages"
LABELS = scattered_objects(600, 600, 300, seed=3)
TABLES = "references", "windows"
SOURCES = "Land cover of Erewhon (ODbL 1.0, © OpenStreetMap contributors)"


@pytest.fixture
def label_map(qgis_app, tmp_path) -> Path:
    """Return a label map with a license in QGIS's metadata file, like that of “Rasterize annotation”."""
    path = write_raster(tmp_path / "labels.tif", LABELS, names=NAMES)
    layer, metadata = QgsRasterLayer(str(path), "labels"), QgsLayerMetadata()
    metadata.setTitle("Land cover of Erewhon")
    metadata.setLicenses(["ODbL 1.0"])
    metadata.setRights(["© OpenStreetMap contributors"])
    layer.setMetadata(metadata)
    layer.saveNamedMetadata(str(path.with_suffix(".qmd")))
    return path


@pytest.fixture
def database(run_algorithm, label_map) -> str:
    given = {"LABELS": str(label_map), "REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": 200, "STRIDE": 100}
    return run_algorithm(BUILD, {**given, "DATABASE": str(label_map.with_name("area.gpkg"))})["DATABASE"]


def notes(path: str) -> list[QgsLayerMetadata]:
    return [QgsVectorLayer(f"{path}|layername={table}", table, "ogr").metadata() for table in TABLES]


def test_both_tables_have_title_history_and_licenses_and_results_name_the_sources_once(
    database, run_algorithm, tmp_path
):
    landmarks, windows = notes(database)
    assert (landmarks.title(), windows.title()) == ("Landmarks", "Windows")
    assert landmarks.abstract() != windows.abstract()
    for metadata in (landmarks, windows):
        assert metadata.rights() == [SOURCES]
        (line,) = metadata.history()
        assert "SemRef" in line and 'processing.run("semref:builddatabase"' in line and "'STRIDE':100" in line
    image = write_raster(tmp_path / "image.png", LABELS[100:300, 100:300])
    output = str(tmp_path / "positions.gpkg")
    run_algorithm(LOCALIZE, {"DATABASE": database, "IMAGES": [str(image)], "OUTPUT": output})
    assert QgsVectorLayer(output, "positions", "ogr").metadata().rights() == [SOURCES]


def test_an_update_adds_itself_to_the_history_and_keeps_the_rest(database, label_map, run_algorithm):
    labels = LABELS.copy()
    labels[300:330, 300:330] = 1
    new = write_raster(label_map.with_name("new.tif"), labels, names=NAMES)
    run_algorithm(UPDATE, {"DATABASE": database, "LABELS": str(new), "OUTPUT": database})
    for metadata in notes(database):
        assert ["builddatabase" in line for line in metadata.history()] == [True, False]
        assert "updatedatabase" in metadata.history()[1]
        assert metadata.rights() == [SOURCES]


def test_the_history_of_many_updates_keeps_the_first_line_and_the_newest_ones(qgis_app):
    layer = QgsVectorLayer("Point?crs=epsg:2056", "landmarks", "memory")
    note = Note("Landmarks", history=("2026-01-02 03:04 UTC, SemRef 1: processing.run('update')",))
    lines = ["built"]
    for number in range(120):
        metadata = QgsLayerMetadata()
        metadata.setHistory(lines)
        lines = note.after(metadata).metadata(layer).history()
        assert len(lines) == (number + 2 if number < 49 else 51)
        # Each line has the number of its run.
        lines[-1] = f"update {number}"
    assert lines[:2] == ["built", "…"]
    assert lines[2:] == [f"update {number}" for number in range(71, 120)]


def test_each_table_has_its_metadata_once_and_the_overview_has_them_on_the_map(database, label_map):
    with contextlib.closing(sqlite3.connect(database)) as connection:
        rows = connection.execute(
            "SELECT table_name, count(*) FROM gpkg_metadata_reference r JOIN gpkg_metadata m ON m.id = r.md_file_id "
            "WHERE m.md_standard_uri = 'http://mrcc.com/qgis.dtd' GROUP BY table_name ORDER BY 1"
        ).fetchall()
        texts = [text for (text,) in connection.execute("SELECT metadata FROM gpkg_metadata")]
    # GDAL would write each metadata entry again as its own.
    assert rows == [("references", 1), ("windows", 1)] and sum("builddatabase" in text for text in texts) == 2
    assert sorted(path.name for path in label_map.parent.glob("area*")) == ["area.gpkg"]
    project = QgsProject()
    (overview,) = (n.layer() for n in add_database_to_map(database, project).findLayers() if n.name() == "Overview")
    metadata = overview.metadata()
    assert (metadata.title(), metadata.rights(), len(metadata.history())) == ("Overview", [SOURCES], 1)


def test_a_damaged_note_of_an_input_costs_nothing(run_algorithm, tmp_path):
    path = write_raster(tmp_path / "labels.tif", scattered_objects(400, 400, 150, seed=4), names=NAMES)
    path.with_suffix(".qmd").write_bytes(np.random.default_rng(1).bytes(500))
    given = {"LABELS": str(path), "REFERENCE_CLASSES": "building", "WINDOW_SIZE": 200, "STRIDE": 100}
    database = run_algorithm(BUILD, {**given, "DATABASE": str(tmp_path / "area.gpkg")})["DATABASE"]
    assert [metadata.rights() for metadata in notes(database)] == [[], []]


def test_the_licenses_of_a_geopackage_layer_are_read_from_its_file(run_algorithm, tmp_path):
    features = [(square(10 + 40 * n, 10, 30), name) for n, name in enumerate(("water", "forest"))]
    path = str(write_layer(tmp_path / "annotation.gpkg", features))
    layer = QgsVectorLayer(path, "annotation", "ogr")
    metadata = QgsLayerMetadata()
    metadata.setLicenses(["CC BY 4.0"])
    layer.setMetadata(metadata)
    del layer
    QgsProviderRegistry.instance().saveLayerMetadata("ogr", f"{path}|layername=annotation", metadata)
    output = str(tmp_path / "issues.gpkg")
    run_algorithm("semref:checkannotation", {"INPUT": path, "CLASS_FIELD": "class", "ISSUES": output})
    assert QgsVectorLayer(output, "issues", "ogr").metadata().rights() == ["annotation (CC BY 4.0)"]
