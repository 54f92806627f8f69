from made_inputs import square, write_layer
from qgis.core import QgsApplication

from semref.processing.layers.results_file import open_results


def test_results_without_some_tables_open_without_a_warning_in_the_log(qgis_app, tmp_path):
    path, logged = write_layer(tmp_path / "positions.gpkg", [(square(0, 0, 9), "fix")], [("status", "text")]), []
    QgsApplication.messageLog().messageReceived[str, str, "Qgis::MessageLevel"].connect(lambda *one: logged.append(one))
    positions, *others = open_results(str(path))
    assert (positions.featureCount(), others, logged) == (1, [None] * 4, [])
