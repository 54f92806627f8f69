"""What a report of a fault needs to say, and nothing that is private."""

from __future__ import annotations

import pytest
from growth import LINEAR, growth

PLUGIN = "/home/jane/.local/share/QGIS/QGIS3/profiles/default/python/plugins/semref"


@pytest.fixture
def unnamed(qgis_app):
    from semref.processing.packages.unnamed import unnamed

    return unnamed


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("/home/jane/My Maps/secret base.gpkg is not a GeoPackage.", "<path.gpkg> is not a GeoPackage."),
        (r"C:\Users\Jane Doe\maps\base.tif can't be read.", "<path.tif> can't be read."),
        (r"\\server\share\base.tif can't be read.", "<path.tif> can't be read."),
        ("The folder ~/maps is empty.", "The folder <path> is empty."),
        ("photo_of_home.jpg: no match", "<file.jpg>: no match"),
        ("see https://tiles.jane.net/key=1 or write to jane@doe.net", "see <address> or write to <address>"),
        ("fix at 550123.4, 5220456.7", "fix at #, #"),
        ("lon 9.6816047, lat 48.9477409", "lon #, lat #"),
        ("The layer Hideout of janes-pc", "The layer <name> of <name>"),
    ],
)
def test_what_is_private_in_a_message_is_left_out(unnamed, line, left):
    assert unnamed(line, PLUGIN, ["Hideout", "janes-pc"]) == left


@pytest.mark.parametrize(
    "line",
    [
        "12 of 12 images have a fix, wrong once in 1,200; 1.37 m (95 %) and/or more",
        "ValueError: operands could not be broadcast together with shapes (3,) (4,)",
        "Labels have 1/2 of the pixels",
    ],
)
def test_what_is_not_private_stays(unnamed, line):
    assert unnamed(line, PLUGIN, ["Hideout"]) == line


def test_tracebacks_keep_where_in_semref_and_in_packages_it_was(unnamed):
    trace = (
        f'  File "{PLUGIN}/core/labels/image.py", line 12, in read\n'
        '  File "/usr/lib/python3/dist-packages/numpy/core/x.py", line 3, in dot\n'
        r'  File "C:\OSGeo4W\apps\Python312\lib\site-packages\cv2\x.py", line 3'
    )
    left = unnamed(trace, PLUGIN)
    assert '"…semref/core/labels/image.py", line 12' in left
    assert "dist-packages/numpy/core/x.py" in left and "/usr" not in left
    assert r"site-packages/cv2\x.py" in left and "OSGeo4W" not in left


def test_diagnostics_tell_versions_packages_devices_and_messages_without_names(qgis_app, monkeypatch, tmp_path):
    import getpass
    import platform

    import numpy
    from qgis.core import Qgis, QgsProject, QgsVectorLayer

    from semref.processing.packages.diagnostics import diagnostics
    from semref.processing.version import plugin_version

    monkeypatch.setattr(platform, "node", lambda: "janes-pc")
    monkeypatch.setattr(getpass, "getuser", lambda: "jane")
    layer = QgsVectorLayer("Polygon", "Hideout", "memory")
    QgsProject.instance().addMapLayer(layer)
    text = diagnostics([f"SemRef: {tmp_path}/x.gpkg of jane on janes-pc, layer “Hideout”, can't be read."])
    QgsProject.instance().removeMapLayer(layer.id())
    versions = f"SemRef {plugin_version()}", f"QGIS {Qgis.QGIS_VERSION}", f"numpy {numpy.__version__}"
    assert [told for told in (*versions, "OpenCV: ", "ONNX Runtime: ") if told not in text] == []
    assert "Device: auto chosen" in text and "can't be read." in text
    assert not [private for private in (str(tmp_path), "jane", "Hideout") if private in text]


def test_nobody_is_led_to_a_tracker_that_nobody_filled_in(qgis_app, monkeypatch):
    from semref.processing import version

    monkeypatch.setattr(version, "plugin_metadata", lambda: {"tracker": "https://example.org/semref/issues"})
    assert version.tracker_url() == ""
    monkeypatch.setattr(version, "plugin_metadata", lambda: {"tracker": "https://forge.net/semref/issues"})
    assert version.tracker_url() == "https://forge.net/semref/issues"


def test_diagnostics_without_messages_say_so(qgis_app):
    from semref.processing.packages.diagnostics import diagnostics

    assert diagnostics().endswith("Last messages:\n(none)\n")


@pytest.mark.parametrize("part", ["/", "a.", "\\\\", "C:/", "~/"])
def test_the_time_for_a_long_message_grows_with_its_length_alone(unnamed, part):
    assert growth(unnamed, lambda n: part * n, 2000) < LINEAR
