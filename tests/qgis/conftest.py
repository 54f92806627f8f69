"""QGIS without a display."""

import os

import pytest


@pytest.fixture(scope="session")
def qgis_app(start_qgis):
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    return start_qgis(window=False)
