"""One way to translate what the user reads."""

from qgis.PyQt.QtCore import QCoreApplication

CONTEXT = "SemRef"


def tr(text: str) -> str:
    """``text`` in the user's language; lupdate finds the calls by this name."""
    return QCoreApplication.translate(CONTEXT, text)
