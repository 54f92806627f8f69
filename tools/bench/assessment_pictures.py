"""Pictures of the documentation that show what the assessment bench made: a map, a reliability diagram, a profile."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsMapRendererParallelJob, QgsMapSettings, QgsVectorLayer
from qgis.PyQt.QtCore import QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFont, QPainter

from bench.assessment import SPACING
from semref.processing.reports import charts
from semref.processing.reports.assessment_report import series_of

MAP_PX = 760, 960
"""Size of the map's picture, with its legend."""


def write(work: Path, folder: Path, found: list, count: int) -> None:
    """All three, from what the bench left in its folder."""
    reliability_picture(found, count, folder / "assessment_reliability.svg")
    map_picture(work, folder)
    route_picture(work, folder)


def reliability_picture(found: list, count: int, path: Path) -> None:
    """Expected against measured success."""
    title = f"{count} fresh images, cut from the label map"
    chart = charts.reliability_diagram([series_of(title, found)], "predicted success", "right fixes", title)
    path.write_text(standing_alone(chart), encoding="utf-8")


def standing_alone(svg: str) -> str:
    """A report's chart with the colors of the report's page inside, as a file of its own."""
    colors = {
        "--ground": "#ffffff",
        "--text": "#1c2126",
        "--soft": "#5d6770",
        "--line": "#d5dade",
        "--s0": "#0067a5",
        "--s1": "#c65102",
        "--bad": "#b3261e",
    }
    for name, color in colors.items():
        svg = svg.replace(f"var({name})", color)
    style = "<style>text{font:12px sans-serif;fill:#1c2126} .soft{fill:#5d6770}</style>"
    background = '<rect width="100%" height="100%" fill="#ffffff"/>'
    head, _, body = svg.partition(">\n")
    return f"{head}>\n{style}{background}\n{body}\n"


def map_picture(work: Path, folder: Path) -> None:
    """The assessment in its own style, the route upon it, with the legend of the style."""
    source = next(iter(sorted(work.glob("squares_*.gpkg"))))
    squares = QgsVectorLayer(str(source), "expected success", "ogr")
    route = QgsVectorLayer(str(work / "route.gpkg"), "points along a route", "ogr")
    settings = QgsMapSettings()
    settings.setLayers([route, squares])
    settings.setDestinationCrs(squares.crs())
    extent = squares.extent()
    extent.grow(SPACING)
    height = MAP_PX[1]
    width = round(height * extent.width() / extent.height())
    settings.setExtent(extent)
    settings.setOutputSize(QSize(width, height))
    settings.setOutputDpi(110)
    settings.setBackgroundColor(QColor("#ffffff"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    picture = job.renderedImage().copy(0, 0, MAP_PX[0], height)
    painter = QPainter(picture)
    painter.fillRect(QRectF(width, 0, MAP_PX[0] - width, height), QColor("#ffffff"))
    texts = ["Expected success of images", "that show 1,280 m; circles:", "points along a route", ""]
    ranges = [(one.label(), one.symbol().color()) for one in squares.renderer().ranges()]
    painter.setFont(QFont("sans-serif", 9))
    for row, text in enumerate(texts + [label for label, _ in ranges]):
        color = ranges[row - len(texts)][1] if row >= len(texts) else None
        if color:
            painter.fillRect(QRectF(width + 14, 30 + 24 * row, 24, 16), color)
        left = width + (46 if color else 14)
        painter.drawText(QRectF(left, 26 + 24 * row, MAP_PX[0] - left, 24), Qt.AlignmentFlag.AlignVCenter, text)
    painter.end()
    picture.save(str(folder / "assessment_liechtenstein.png"))


def route_picture(work: Path, folder: Path) -> None:
    """The profile out of the route's report."""
    text = (work / "route.html").read_text(encoding="utf-8")
    start = text.index("<svg")
    profile = text[start : text.index("</svg>", start) + len("</svg>")]
    (folder / "assessment_route.svg").write_text(standing_alone(profile), encoding="utf-8")
