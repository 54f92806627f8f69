"""semref:routesheet: an assessed route on paper."""

from __future__ import annotations

from pathlib import Path

import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsProcessingException, QgsVectorLayer

from semref.processing.algorithms.assess_route import FIELDS
from semref.processing.algorithms.make_route_sheet import Stretch, key_figures, stretch_row, stretches
from semref.processing.exchange.assessment_styles import route_look
from semref.processing.exchange.route_sheet import RouteSheet, column_shares

SHEET = "semref:routesheet"
KINDS = {"integer": "int", "real": "double", "text": "string"}


def point(n: int, gap: float, route: int = 1, **more) -> dict:
    return {"route": route, "along": 100.0 * n, "success": 0.5, "gap": gap, "gap_seconds": gap / 20, **more}


def layer_of(points: list[dict], fields=FIELDS) -> QgsVectorLayer:
    columns = "&".join(f"field={name}:{KINDS[kind]}" for name, kind in fields)
    layer = QgsVectorLayer(f"Point?crs=EPSG:32632&{columns}", "my route", "memory")
    for n, values in enumerate(points):
        feature = QgsFeature(layer.fields())
        for name, value in values.items():
            feature[name] = value
        feature.setGeometry(QgsGeometry.fromWkt(f"POINT({500_000 + 100 * n} {5_400_000 + 40 * (n % 3)})"))
        layer.dataProvider().addFeature(feature)
    route_look(0.9).give(layer)
    layer.updateExtents()
    return layer


def test_stretches_are_runs_of_one_gap_the_longest_first_and_end_with_their_route():
    points = [point(0, 0), point(1, 200), point(2, 200), point(3, 0), point(4, 300), point(5, 300)]
    points += [point(0, 300, route=2), point(1, 0, route=2)]
    found = stretches(points)
    assert [[(one["route"], one["along"]) for one in run.points] for run in found] == [
        [(1, 400), (1, 500)],
        [(2, 0)],
        [(1, 100), (1, 200)],
    ]
    # From the good point before to the one behind, as far as the route goes.
    assert [(run.start, run.end) for run in found] == [(300, 500), (0, 100), (0, 300)]


def test_the_key_figures_tell_length_good_points_and_the_longest_gap(qgis_app):
    points = [point(0, 0), point(40, 1200.0), point(80, 0), point(20, 0, route=2)]
    assert [value for _, value in key_figures(points)] == ["10 km", "75 %", "1,200 m, 60 s"]
    assert [value for _, value in key_figures([point(10, 0)])][2] == "nowhere"


def test_a_row_has_the_hint_to_the_side_it_is_on(qgis_app):
    points = [point(3, 200, shift=-320.0, reason="Too few landmarks"), point(4, 200)]
    row = ["1", "200", "500", "300", "Too few landmarks", "320 m to the left"]
    assert stretch_row(Stretch([{**points[0], "gap": 300}, points[1]], 200, 500)) == row
    assert stretch_row(Stretch([point(3, 200, shift=None, reason=None)], 200, 400))[4:] == ["", ""]


def test_a_row_has_the_reason_of_most_of_its_points(qgis_app):
    said = ["Too vague (15 in view)", None, "Too few: 2", "Too few: 1", "Too few: 0"]
    points = [point(n, 500, reason=reason) for n, reason in enumerate(said)]
    assert stretch_row(Stretch(points, 0, 500))[4] == "Too few: 1"


def test_columns_share_the_width_by_their_longest_cells():
    assert column_shares([["a", "b"], ["short", "x" * 80]]) == pytest.approx([6 / 66, 60 / 66])


REASON = "Too little evidence: the landmarks (15 in view) agree too loosely, and some places look alike from here"


@pytest.mark.parametrize("reason", ["r", REASON, REASON.replace(" ", "W"), 3 * REASON])
def test_nothing_of_the_table_is_cut_off(qgis_app, reason):
    from qgis.core import QgsLayoutItemManualTable, QgsLayoutTable, QgsPrintLayout, QgsProject

    rows = [["1", "7,680", "12,800", "5,760", reason, "320 m to the left"] for _ in range(40)]
    header = ["Route", "from (m)", "to (m)", "length (m)", "reason", "hint"]
    layout = QgsPrintLayout(QgsProject.instance())
    layout.initializeDefaults()
    RouteSheet("title", "subtitle", layer_of([point(0, 0)]), [], [], header, rows, "Stretches")._add_table(layout)
    tables = [table for table in layout.multiFrames() if isinstance(table, QgsLayoutItemManualTable)]
    assert sum(max(0, len(table.tableContents()) - 1) for table in tables) == len(rows)
    for table in tables:
        room = table.frames()[0].rect()
        assert table.wrapBehavior() == QgsLayoutTable.WrapText
        assert table.totalSize().height() <= room.height()
        assert table.totalSize().width() <= room.width() + 0.1
    # Before its project.
    del table, tables, layout


def test_points_that_somebody_emptied_do_not_end_the_work(run_algorithm, tmp_path):
    emptied = [point(0, 0), {"success": 0.5, "gap": 300.0}, point(2, 300), {"route": 2, "along": None, "gap": 0}]
    path = tmp_path / "sheet.pdf"
    run_algorithm(SHEET, {"ROUTE": layer_of(emptied), "OUTPUT": str(path)})
    assert path.read_bytes().startswith(b"%PDF")


def test_a_sheet_is_a_pdf_with_a_page_for_the_map_and_one_for_each_part_of_the_table(run_algorithm, tmp_path):
    layer = layer_of([point(n, 0.0 if n % 2 else 100.0 + n, reason="r") for n in range(60)])
    output = tmp_path / "sheet.pdf"
    assert run_algorithm(SHEET, {"ROUTE": layer, "TITLE": "Mission [% 1+1 %]", "OUTPUT": str(output)})["OUTPUT"]
    content = output.read_bytes()
    assert content.startswith(b"%PDF")
    # The map, and 30 stretches at 26 a page.
    assert content.count(b"/Type /Page\n") == 3
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.pdf"]


def test_a_layer_that_is_no_assessed_route_is_refused(run_algorithm, tmp_path):
    output = str(tmp_path / "sheet.pdf")
    with pytest.raises(QgsProcessingException, match="“my route” is no assessed route.*gap"):
        run_algorithm(SHEET, {"ROUTE": layer_of([{"route": 1}], FIELDS[:4]), "OUTPUT": output})
    with pytest.raises(QgsProcessingException, match="is no assessed route"):
        run_algorithm(SHEET, {"ROUTE": layer_of([]), "OUTPUT": output})
    assert not Path(output).exists()
