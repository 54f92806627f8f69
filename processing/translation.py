"""Translation of texts for the user."""

from qgis.PyQt.QtCore import QCoreApplication

CONTEXT = "SemRef"


def tr(text: str) -> str:
    """Translate ``text`` into the user's language; lupdate finds the calls by this name."""
    return QCoreApplication.translate(CONTEXT, text)
