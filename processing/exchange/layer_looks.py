"""How the other layers look on a map: findings, changes, disagreements, classes, landmarks of an image, trials."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsFillSymbol,
    QgsMarkerSymbol,
    QgsRendererCategory,
    QgsRuleBasedRenderer,
)
from qgis.PyQt.QtGui import QColor

from ...core.annotation.classes import ClassLookup
from ...core.labels.class_table import ClassTable, class_table_from_names
from ...storage import map_tips
from ..translation import tr
from ..wording.annotation_messages import kind_titles, severity_words
from ..wording.columns import method_words, status_words
from .output_style import Look
from .palette import BAD, CASING, FIX, INFORMATION, WARNING
from .styles import annotation_renderer, issues_renderer, references_renderer

if TYPE_CHECKING:
    from .annotation import AnnotationSource


def issues_look() -> Look:
    """Findings of a check, by severity."""
    rows = [
        (tr("Severity"), map_tips.worded("severity", severity_words())),
        (tr("Area"), map_tips.number("area", 2, unit="m²")),
        (tr("Feature"), 'to_string("feature_id")'),
    ]
    tip = map_tips.tip(map_tips.text("message"), rows)
    return Look(issues_renderer(), name='"message"', tip=tip)


def changes_look() -> Look:
    """What a repair changed: outlines that let the annotation show through."""
    rows = [
        (tr("Kind"), map_tips.worded("kind", kind_titles())),
        (tr("Area"), map_tips.number("area", 2, unit="m²")),
    ]
    tip = map_tips.tip(map_tips.text("message"), rows)
    return Look(_outlines(FIX, tr("Changed")), name='"message"', tip=tip)


def repaired_look(lookup: ClassLookup, source: AnnotationSource) -> Look:
    """An annotation in its class colors; its columns keep the names that its owner gave."""
    categories = []
    for one in lookup.table:
        symbol = QgsFillSymbol.createSimple({"color": one.color, "outline_style": "no"})
        for raw in lookup.raw_values(one.value, source.class_is_number):
            categories.append(QgsRendererCategory(raw, symbol.clone(), one.name))
    return Look(QgsCategorizedSymbolRenderer(source.class_expression, categories), is_own=False)


def land_cover_look(names: Sequence[str], class_field: str, priority_field: str) -> Look:
    """Land cover in the colors that classes are known by, higher priorities on top."""
    return Look(annotation_renderer(class_table_from_names(names), class_field, priority_field), is_own=False)


def disagreements_look() -> Look:
    """Where two maps disagree: outlines, so that a photo below shows who is right."""
    heading = '"rank" || \': \' || "annotated_class" || \' → \' || "predicted_class"'
    rows = [
        (tr("Annotated class"), map_tips.text("annotated_class")),
        (tr("Predicted class"), map_tips.text("predicted_class")),
        (tr("Area"), map_tips.number("area", 0, unit="m²")),
    ]
    return Look(_outlines(BAD, tr("The maps disagree")), name=heading, tip=map_tips.tip('"rank"', rows))


def _outlines(color: str, words: str) -> QgsRuleBasedRenderer:
    """Outlines around what shows through, with the words of the legend."""
    symbol = QgsFillSymbol.createSimple({"outline_color": color, "outline_width": "0.5"})
    fill = QColor(color)
    fill.setAlpha(40)
    symbol.symbolLayer(0).setFillColor(fill)
    root = QgsRuleBasedRenderer.Rule(None)
    root.appendChild(QgsRuleBasedRenderer.Rule(symbol, 0, 0, "", words))
    return QgsRuleBasedRenderer(root)


def class_polygons_look(table: ClassTable) -> Look:
    """Polygons of a label map in its colors."""
    rows = [(tr("Area"), map_tips.number("area", 0, unit="m²"))]
    tip = map_tips.tip(map_tips.text("class_name"), rows)
    return Look(annotation_renderer(table, "class_name"), name='"class_name"', tip=tip)


def landmarks_look(table: ClassTable) -> Look:
    """Landmarks of an image in their class colors."""
    rows = [
        (tr("Area"), map_tips.number("area", 0, unit="m²")),
        (tr("Distance from the center (px)"), map_tips.number("center_distance", 0)),
    ]
    tip = map_tips.tip(map_tips.text("class_name"), rows)
    return Look(references_renderer(table), name='"class_name"', tip=tip)


def trials_look() -> Look:
    """Trials by what came of them: right, wrong, no fix, and mirrored images, of which no fix can be right."""
    shown = (
        ('"right" = 1', FIX, "circle", "2.2", tr("right fix")),
        ('"status" = \'fix\' AND "right" = 0', BAD, "cross2", "2.8", tr("wrong fix")),
        ("\"status\" = 'ambiguous'", WARNING, "triangle", "2.2", tr("ambiguous")),
        ("ELSE", INFORMATION, "circle", "1.2", tr("no fix")),
    )
    root = QgsRuleBasedRenderer.Rule(None)
    for expression, color, shape, size, words in shown:
        symbol = QgsMarkerSymbol.createSimple(
            {"name": shape, "color": color, "size": size, "outline_color": CASING, "outline_width": "0.2"}
        )
        if shape == "cross2":
            symbol.symbolLayer(0).setStrokeColor(QColor(color))
            symbol.symbolLayer(0).setStrokeWidth(0.6)
        root.appendChild(QgsRuleBasedRenderer.Rule(symbol, 0, 0, expression, words))
    rows = [
        (tr("Status"), map_tips.worded("status", status_words())),
        (tr("Method"), map_tips.worded("method", method_words())),
        (tr("Error"), map_tips.number("error", 1, unit="m")),
        (tr("Landmarks in the image"), map_tips.number("references")),
        (tr("Reason"), map_tips.text("reason")),
    ]
    return Look(QgsRuleBasedRenderer(root), name='"trial"', tip=map_tips.tip('to_string("trial")', rows))
