"""Diagnostics for a bug report."""

import os

import numpy
import pytest
from qgis.core import Qgis

from semref.processing import version
from semref.processing.packages.diagnostics import diagnostics, without_home
from semref.processing.version import plugin_version


@pytest.mark.parametrize(
    ("home", "line", "left"),
    [
        ("/home/jane", "/home/jane/maps/base.gpkg is damaged.", "~/maps/base.gpkg is damaged."),
        ("/home/jane/", "“/home/jane” and file:///home/jane/x", "“~” and file:~/x"),
        ("/home/jane", "/home/janet/x, /mnt/home/jane/x", "/home/janet/x, /mnt/home/jane/x"),
        (r"C:\Users\Jane Doe", r"C:\Users\Jane Doe\a.tif, c:/users/Jane Doe/b.tif", r"~\a.tif, ~/b.tif"),
        (r"C:\Users\Jane", r"'C:\\Users\\Jane\\a.tif'", r"'~\\a.tif'"),
        ("/", "/usr/share/x", "/usr/share/x"),
    ],
)
def test_the_home_folder_is_left_out(qgis_app, home, line, left):
    assert without_home(line, home) == left


def test_diagnostics_have_versions_packages_settings_and_messages(qgis_app):
    text = diagnostics([f"SemRef: {os.path.expanduser('~')}/x.gpkg can't be read."])
    versions = f"SemRef {plugin_version()}", f"QGIS {Qgis.QGIS_VERSION}", f"numpy {numpy.__version__}"
    assert [told for told in (*versions, "OpenCV: ", "ONNX Runtime: ") if told not in text] == []
    assert "Device: auto chosen" in text and "Training: " in text
    assert text.endswith("Last messages:\nSemRef: ~/x.gpkg can't be read.\n")
    assert diagnostics().endswith("Last messages:\n(none)\n")


def test_nobody_is_led_to_a_tracker_that_nobody_filled_in(qgis_app, monkeypatch):
    monkeypatch.setattr(version, "_metadata", lambda: {"tracker": "https://example.org/semref/issues"})
    assert version.tracker_url() == ""
    monkeypatch.setattr(version, "_metadata", lambda: {"tracker": "https://forge.net/semref/issues"})
    assert version.tracker_url() == "https://forge.net/semref/issues"
