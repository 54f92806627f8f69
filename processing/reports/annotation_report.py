"""Report of a check of a land-cover layer: findings by kind, severity and class."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from ...core.annotation.findings import CHECKED_KINDS, ERROR, NOTHING, SEVERITIES, Finding
from ..messages.annotation_messages import kind_titles, severity_title
from ..messages.numbers import count as number_text
from ..messages.numbers import shown
from ..translation import tr
from . import page, parts


def annotation_html(layer: str, features: int, findings: Sequence[Finding], class_names: dict[int, str]) -> str:
    """Return the page; ``class_names``: names by class value."""
    return page.page(
        tr("Check of a land-cover layer"),
        tr("{layer}: {features} features").format(layer=layer, features=number_text(features)),
        _key_figures(findings),
        parts.next_steps(_next(findings)),
        page.section(tr("Findings by kind"), _kinds_table(findings)),
        page.section(tr("Findings by class"), _classes_table(findings, class_names)),
    )


def _key_figures(findings: Sequence[Finding]) -> str:
    counts = Counter(finding.severity for finding in findings)
    figures = [(number_text(counts[severity]), severity_title(severity), "") for severity in SEVERITIES]
    return page.key_figures(figures)


def _next(findings: Sequence[Finding]) -> list[str]:
    if any(finding.severity == ERROR for finding in findings):
        return [
            tr("Fix the errors: open the layer of findings in the dock’s tab “Correct”, largest first."),
            tr("“Repair land-cover layer” fixes invalid geometries, overlaps and slivers automatically."),
            tr("Check again. Without errors, the layer is ready for “Rasterize land-cover layer”."),
        ]
    return [
        tr("There are no errors. Continue with “Rasterize land-cover layer”, then “Build reference database”."),
        tr("Warnings may reduce the number of landmarks. Check those in important places of the map."),
    ]


def _kinds_table(findings: Sequence[Finding]) -> str:
    if not findings:
        return page.paragraph(tr("The check has no findings."))
    rows = []
    for kind in CHECKED_KINDS:
        own = [finding for finding in findings if finding.kind == kind]
        if not own:
            continue
        counts = Counter(finding.severity for finding in own)
        cells = [_count(counts[severity], severity) for severity in SEVERITIES]
        area = shown(sum(f.area or 0.0 for f in own), ",.2f")
        rows.append([kind_titles()[kind], *cells, f"{area}{page.NO_BREAK}m²"])
    header = [tr("Kind"), *(severity_title(severity) for severity in SEVERITIES), tr("Area")]
    return page.table(header, rows, numbers=(1, 2, 3, 4))


def _classes_table(findings: Sequence[Finding], class_names: dict[int, str]) -> str:
    counts = Counter((f.class_value, f.severity) for f in findings)
    rows = [
        [name, *(_count(counts[value, severity], severity) for severity in SEVERITIES)]
        for value, name in [*class_names.items(), (NOTHING, tr("No class"))]
        if any(counts[value, severity] for severity in SEVERITIES)
    ]
    return page.table([tr("Class"), *(severity_title(s) for s in SEVERITIES)], rows, numbers=(1, 2, 3))


def _count(number: int, severity: str) -> str:
    text = number_text(number)
    return page.Marked(text, False) if number and severity == ERROR else text
