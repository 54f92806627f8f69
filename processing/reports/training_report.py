"""Report of a training: quality of each class on validation ground, curves, examples."""

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
"""Largest number of lines in the chart of curves, for the largest classes."""


@dataclass(frozen=True)
class TrainingReport:
    """Data of the report.

    Attributes:
        model: Name of the model's file.
        result: Content of result.json.
        examples: PNG pictures with photo, annotation and prediction.
    """

    model: str
    result: dict
    ground: dict
    examples: Sequence[bytes]

    @property
    def names(self) -> list[str]:
        """Names of the classes by channel."""
        return [entry["name"] for entry in self.result["classes"]]

    @property
    def mean_iou(self) -> float | None:
        """Mean IoU on validation ground; None without such ground."""
        return self.result["mean_iou"] if np.any(self.result["confusion"]) else None

    def html(self) -> str:
        return page.page(
            tr("Training of a model"),
            self.model,
            self._figures(),
            parts.next_steps(self._next()),
            page.section(tr("Classes"), *self._classes()),
            page.section(tr("Curves"), page.columns(self._loss(), self._iou())),
            page.section(tr("Examples"), *self._examples()),
            page.section(tr("Training ground"), self._ground()),
        )

    def _figures(self) -> str:
        result = self.result
        epochs = tr("{best} of {count} epochs").format(best=result["best_epoch"], count=len(result["history"]))
        tiles = tr("{training} training tiles, {validation} validation tiles")
        minutes = page.number(result["seconds"] / 60, "min")
        return page.key_figures(
            [
                (page.percent(self.mean_iou), tr("Mean IoU"), tr("on validation ground")),
                (epochs, tr("Best epoch"), stopped_by(result["stopped_by"])),
                (minutes, tr("Training time"), result["device"]),
                (
                    page.number(result["bytes"] / 1e6, "MB"),
                    tr("Size of the model"),
                    tiles.format(training=result["training"], validation=result["validation"]),
                ),
            ]
        )

    def _next(self) -> list[str]:
        steps = [tr("Test the model on new ground with “Segment image”, then “Compare label maps”.")]
        if self.result["stopped_by"] == "minutes":
            steps.append(tr("The time limit ended the training. Train again to continue this training."))
        steps.append(tr("For classes with a low IoU, annotate more ground in different places."))
        return steps

    def _classes(self) -> list[str]:
        # Channels begin at 0, classes of a comparison at 1.
        counts = np.pad(np.array(self.result["confusion"], np.int64), ((1, 0), (1, 0)))
        if not counts.any():
            return [page.paragraph(tr("There is no validation ground, so the quality of the model is unknown."))]
        found = LabelComparison(counts)
        annotated, predicted = (np.flatnonzero(of_value).tolist() for of_value in (found.annotated, found.predicted))

        def name(value: int) -> str:
            return self.names[value - 1]

        return [parts.class_table(found, name, annotated), parts.confusion_figure(found, name, predicted)]

    def _loss(self) -> str:
        history = self.result["history"]
        losses = [row["training_loss"] for row in history]
        axis = charts.linear_axis(tr("Loss"), max([*losses, 1e-6]))
        series = [Series(tr("Loss"), [row["epoch"] for row in history], losses, marked=len(history) < 30)]
        chart = charts.line_chart(series, self._epochs(), axis, tr("Training loss"))
        return page.figure(chart, tr("Training loss: the error on training tiles."))

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
        return page.figure(chart, tr("IoU of each class on validation ground."))

    def _epochs(self) -> charts.Axis:
        last = max(len(self.result["history"]), 2)
        steps = min(last - 1, 5)
        ticks = sorted({1 + round((last - 1) * n / steps) for n in range(steps + 1)})
        return charts.Axis(tr("Epoch"), (1.0, float(last)), [(float(tick), str(tick)) for tick in ticks])

    def _examples(self) -> list[str]:
        if not self.examples:
            return [page.paragraph(tr("There are no examples, because there is no validation ground."))]
        alt = tr("Photo, annotation and prediction")
        caption = tr("Photo, annotation (gray: unknown) and prediction of the model.")
        return [page.paragraph(caption), self._legend(), *(page.image(png, alt) for png in self.examples)]

    def _legend(self) -> str:
        return color_legend([(entry["color"], entry["name"]) for entry in self.result["classes"]])

    def _ground(self) -> str:
        rows = [(ground_title(key), _shown(value)) for key, value in self.ground.items()]
        return page.table([tr("Property"), tr("Value")], rows)


def stopped_by(reason: str) -> str:
    """Return the reason for the end of a training in the user's language."""
    return {
        "epochs": tr("all epochs completed"),
        "patience": tr("stopped: no further progress"),
        "minutes": tr("stopped: time limit"),
    }.get(reason, "")


def ground_title(key: str) -> str:
    """Return the title of an entry about the training ground in the user's language."""
    return {
        "image": tr("Image"),
        "labels": tr("Land-cover layer or label map"),
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
