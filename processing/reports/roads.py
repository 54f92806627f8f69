"""What told radii and confidences are worth, by road: the same table in every report."""

from __future__ import annotations

from collections.abc import Sequence

from ...core.evaluation.summary import RoadSummary
from ..translation import tr
from ..wording.sentences import worded
from . import page


def road_rows(summaries: Sequence[RoadSummary], of: str = "") -> list[list[str]]:
    """Rows of the table; ``of``: what the fixes are of, where there are several."""
    return [
        [
            f"{of}: {worded(one.road.title)}" if of else worded(one.road.title),
            page.rate_text(one.right),
            page.percent(one.told, 2),
            page.percent(one.calibration_error, 2),
            *(page.rate_text(rate) for rate in one.held),
            page.number(one.median_radius, "m"),
            page.number(one.median_error, "m"),
        ]
        for one in summaries
    ]


def road_table(rows: Sequence[list[str]]) -> list[str]:
    """The table and what its columns mean."""
    if not rows:
        return [page.paragraph(tr("No image has a fix."))]
    header = [
        tr("Fixes by"),
        tr("right"),
        tr("told to be right"),
        tr("calibration error"),
        tr("in the 50 % ellipse"),
        tr("in the 95 % ellipse"),
        tr("in the 99 % ellipse"),
        tr("median 95 % radius"),
        tr("median error"),
    ]
    text = tr(
        "By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right "
        "fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes "
        "whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %."
    )
    return [page.table(header, rows, range(1, len(header))), page.paragraph(text)]
