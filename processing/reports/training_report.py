"""The report of a training: how well each class is found on ground set aside, curves, examples side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...core.labels.comparison import LabelComparison
from ..messages.numbers import shown
from ..translation import tr
from . import charts, page, parts
from .charts import Series
from .maps import color_legend

CLASSES_IN_CHART = 8
"""Lines of the chart of curves beyond which nobody tells them apart: those of the largest classes."""


@dataclass(frozen=True)
class TrainingReport:
    """What the report is made from.

    Attributes:
        model: Name of the model's file.
        result: What the training tells (result.json).
        ground: What the metadata tell of the ground.
        examples: Pictures (PNG): photo, annotation, answer side by side.
    """

    model: str
    result: dict
    ground: dict
    examples: Sequence[bytes]

    @property
    def names(self) -> list[str]:
        """Of the classes, a channel each."""
        return [entry["name"] for entry in self.result["classes"]]

    def html(self) -> str:
        """The whole page."""
        return page.page(
            tr("Training of a network"),
            self.model,
            self._figures(),
            parts.next_steps(self._next()),
            page.section(tr("Classes"), *self._classes()),
            page.section(tr("Curves"), page.columns(self._loss(), self._iou())),
            page.section(tr("Examples"), *self._examples()),
            page.section(tr("What it was trained on"), self._ground()),
        )

    def _figures(self) -> str:
        result = self.result
        epochs = tr("{best} of {count} epochs").format(best=result["best_epoch"], count=len(result["history"]))
        tiles = tr("{training} tiles to train on, {validation} to validate on")
        minutes = page.number(result["seconds"] / 60, "min")
        return page.key_figures(
            [
                (page.percent(self.result["mean_iou"]), tr("mean IoU"), tr("on ground that was set aside")),
                (epochs, tr("best epoch"), stopped_by(result["stopped_by"])),
                (minutes, tr("training time"), result["device"]),
                (
                    page.number(result["bytes"] / 1e6, "MB"),
                    tr("size of the model"),
                    tiles.format(training=result["training"], validation=result["validation"]),
                ),
            ]
        )

    def _next(self) -> list[str]:
        steps = [tr("Try the model on ground that it has not seen: “Segment image”, then “Compare label maps”.")]
        if self.result["stopped_by"] == "minutes":
            steps.append(tr("The time was over before it stopped learning: train again, it goes on from here."))
        steps.append(tr("Classes that are found badly want more annotated ground, of places that differ."))
        return steps

    def _classes(self) -> list[str]:
        # Channels begin at 0, classes of a comparison at 1.
        counts = np.pad(np.array(self.result["confusion"], np.int64), ((1, 0), (1, 0)))
        if not counts.any():
            return [page.paragraph(tr("No ground was set aside, so nothing tells how good the network is."))]
        found = LabelComparison(counts)
        annotated, predicted = (np.flatnonzero(of_value).tolist() for of_value in (found.annotated, found.predicted))

        def name(value: int) -> str:
            return self.names[value - 1]

        return [parts.class_table(found, name, annotated), parts.confusion_figure(found, name, predicted)]

    def _loss(self) -> str:
        history = self.result["history"]
        losses = [row["training_loss"] for row in history]
        axis = charts.linear_axis(tr("loss"), 0.0, max([*losses, 1e-6]))
        series = [Series(tr("loss"), [row["epoch"] for row in history], losses, marked=len(history) < 30)]
        chart = charts.line_chart(series, self._epochs(), axis, tr("Loss while training"))
        return page.figure(chart, tr("Loss while training: how far the answers are off on what is learned."))

    def _iou(self) -> str:
        history = self.result["history"]
        order = sorted(range(len(self.names)), key=lambda n: -sum(self.result["confusion"][n]))
        shown = [self.names[n] for n in order[:CLASSES_IN_CHART] if f"iou_{self.names[n]}" in history[-1]]
        series = [
            Series(
                name,
                [row["epoch"] for row in history if f"iou_{name}" in row],
                [row[f"iou_{name}"] for row in history if f"iou_{name}" in row],
                marked=len(history) < 30,
            )
            for name in shown
        ]
        if not series:
            return ""
        chart = charts.line_chart(series, self._epochs(), charts.percent_axis(tr("IoU")), tr("IoU of each class"))
        return page.figure(chart, tr("IoU of each class on ground that was set aside."))

    def _epochs(self) -> charts.Axis:
        last = max(len(self.result["history"]), 2)
        steps = min(last - 1, 5)
        ticks = sorted({1 + round((last - 1) * n / steps) for n in range(steps + 1)})
        return charts.Axis(tr("epoch"), (1.0, float(last)), [(float(tick), str(tick)) for tick in ticks])

    def _examples(self) -> list[str]:
        if not self.examples:
            return [page.paragraph(tr("There is no example: no ground was set aside."))]
        alt = tr("Photo, annotation and answer of the network")
        caption = tr("Photo, annotation (gray where nothing is known) and what the network makes of it.")
        return [page.paragraph(caption), self._legend(), *(page.image(png, alt) for png in self.examples)]

    def _legend(self) -> str:
        return color_legend([(entry["color"], entry["name"]) for entry in self.result["classes"]])

    def _ground(self) -> str:
        rows = [(ground_title(key), _shown(value)) for key, value in self.ground.items()]
        return page.table([tr("What"), tr("Value")], rows)


def stopped_by(reason: str) -> str:
    """Why a training ended, in the user's language."""
    return {
        "epochs": tr("all epochs done"),
        "patience": tr("stopped: no progress any more"),
        "minutes": tr("stopped: the time was over"),
    }.get(reason, "")


def ground_title(key: str) -> str:
    """What an entry about the ground is called, in the user's language."""
    return {
        "image": tr("Image"),
        "labels": tr("Annotation or label map"),
        "crs": tr("CRS"),
        "extent": tr("Extent"),
        "pixel_size": tr("Pixel size (m)"),
        "base_model": tr("Base model"),
        "date": tr("Date"),
    }.get(key, key)


def _shown(value: object) -> str:
    if isinstance(value, (list, tuple)):
        return ", ".join(shown(part, ".2f") if isinstance(part, float) else str(part) for part in value)
    return shown(value, "g") if isinstance(value, float) else str(value)
