"""The dock by keyboard and by ear, and beside a map on a small screen in every language."""

from xml.etree import ElementTree

import pytest
from dock_area import AUTOMATIC, CONSTELLATION, choose_method, localize, settle, wait_until
from qgis.PyQt.QtCore import QCoreApplication, Qt, QTranslator
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QLabel, QWidget

from semref.ui.dock.content import CORRECT, INSPECT, LOCALIZE

pytestmark = pytest.mark.slow

MOST_STEPS = 80


def reachable(page) -> list:
    """What a mouse could use now, and keys should."""
    widgets = [w for w in page.findChildren(QWidget) if w.isVisible() and w.isEnabled()]
    return [w for w in widgets if w.focusPolicy() & Qt.FocusPolicy.TabFocus and w.focusProxy() is None]


def has_focus(widget) -> bool:
    widget.window().activateWindow()
    widget.setFocus()
    settle()
    return widget.hasFocus()


def walked(first) -> list:
    """Widgets that have the focus one after the other while Tab is pressed, from the first until it comes again."""
    # Without a window manager, X reports the active window late, and no window has the focus until then.
    wait_until(lambda: has_focus(first), "the focus")
    seen = []
    for _ in range(MOST_STEPS):
        focused = QApplication.focusWidget()
        if focused in seen:
            break
        seen.append(focused)
        QTest.keyClick(focused, Qt.Key.Key_Tab)
    return seen


def name_of(widget) -> str:
    """What a screen reader says: Qt takes a widget's own name, else its text or title, else the label beside it."""
    own = [widget.accessibleName()] + [getattr(widget, part)() for part in ("text", "title") if hasattr(widget, part)]
    labels = [label.text() for label in widget.window().findChildren(QLabel) if label.buddy() is widget]
    # A tab bar has its tabs, a scroll area what it shows.
    inner = [widget.tabText(0)] if hasattr(widget, "tabText") else []
    return next(filter(None, [*own, *labels, *inner]), "")


@pytest.fixture(params=["localize", *(pytest.param(tab, marks=pytest.mark.slow) for tab in ("inspect", "correct"))])
def filled(request, dock, area, issues, tab):
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    dock.content.inspect.show_window("150_250")
    dock.content.tabs.setCurrentIndex(["localize", "inspect", "correct"].index(request.param))
    settle()
    return dock


def test_tab_walks_through_everything(filled):
    expected = reachable(filled.content)
    seen = walked(expected[0])
    assert [f"{type(w).__name__} {name_of(w)}" for w in expected if w not in seen] == []


def test_everything_has_a_name(filled):
    nameless = [w for w in reachable(filled.content) if not name_of(w)]
    assert [f"{type(w).__name__} {w.objectName()} in {type(w.parent()).__name__}" for w in nameless] == []


def test_a_mirrored_dock_shows_everything(filled, qgis_app):
    filled.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
    settle()
    inside = filled.content.rect()
    for widget in reachable(filled.content.tabs.currentWidget()):
        left = widget.mapTo(filled.content, widget.rect().topLeft()).x()
        assert inside.left() <= left and left + widget.width() <= inside.right() + 1
    filled.setLayoutDirection(Qt.LayoutDirection.LeftToRight)


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
