"""The dock beside a map on a small screen: 320 pixels are enough, in every language."""

from xml.etree import ElementTree

import pytest
from dock_area import AUTOMATIC, choose_method, localize, settle
from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from qgis.PyQt.QtWidgets import QWidget

from semref.ui.dock.content import CORRECT, INSPECT, LOCALIZE

pytestmark = pytest.mark.slow  # a dock is made for each test

LEAST_PX = 320
LANGUAGES = ("", "de", "es", "fr", "zh_Hans")


@pytest.fixture(params=LANGUAGES, ids=[name or "en" for name in LANGUAGES])
def language(request, qgis_app, repository):
    """SemRef's texts in this language, from the translation files."""

    class Kept(QTranslator):
        def translate(self, context, source, *_more):
            # None is no translation; an empty text would be one.
            return texts.get(source) if context == "SemRef" else None

        def isEmpty(self):
            return False

    texts = {}
    if request.param:
        tree = ElementTree.parse(repository / "i18n" / f"semref_{request.param}.ts")
        texts = {entry.findtext("source"): entry.findtext("translation") for entry in tree.iter("message")}
    translator = Kept()
    QCoreApplication.installTranslator(translator)
    yield request.param
    QCoreApplication.removeTranslator(translator)


def widest(widget) -> list[str]:
    """Return the widest widgets, to explain a failure."""
    parts = [part for part in widget.findChildren(QWidget) if part.isVisibleTo(widget)]
    parts.sort(key=lambda part: -part.minimumSizeHint().width())
    return [f"{type(p).__name__} {p.objectName()} {p.minimumSizeHint().width()}" for p in parts[:12]]


def test_the_dock_can_be_narrow(language, dock, area, issues, tab):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    dock.content.inspect.show_window("150_250")
    # While a package is missing.
    dock.notice.sentence.setText("OpenCV, ONNX Runtime")
    dock.notice.setVisible(True)
    for page in (LOCALIZE, INSPECT, CORRECT):
        dock.content.tabs.setCurrentIndex(page)
        for box in (dock.content.database, tab.images):
            box.setCollapsed(False)
        settle()
        assert dock.notice.isVisible()
        assert dock.minimumSizeHint().width() <= LEAST_PX, widest(dock.content)
