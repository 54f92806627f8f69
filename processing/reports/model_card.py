"""A model's card as a page for people: what it knows, where it was trained, how good it is and what it is bad at."""

from __future__ import annotations

import os
from html import escape
from typing import TYPE_CHECKING

from ..translation import tr
from ..wording.numbers import shown
from ..wording.sentences import worded
from .page import NO_BREAK, NOTHING, percent

if TYPE_CHECKING:
    from ...core.segmentation.model_card import Ground, ModelCard


def card_title(card: ModelCard) -> str:
    """What a model is called: by itself, or by its file."""
    return card.name or os.path.splitext(os.path.basename(card.file))[0]


def resolution_text(card: ModelCard) -> str:
    """Meters a pixel, as people write them."""
    if card.resolution_m is None:
        return NOTHING
    return (
        f"{shown(card.resolution_m, 'g')}{NO_BREAK}m"
        if card.resolution_m >= 1
        else f"{shown(100 * card.resolution_m, 'g')}{NO_BREAK}cm"
    )


def quality_text(card: ModelCard) -> str:
    """Mean IoU in percent."""
    return NOTHING if card.mean_iou is None else percent(card.mean_iou, 0)


def card_html(card: ModelCard) -> str:
    """The card in HTML that Qt's text browser shows too."""
    unsaid = tr("It does not say what it was trained on: try it on a photo of ground that you know.")
    notes = [f"<p><i>{escape(unsaid)}</i></p>"] if not (card.fault or card.trained_on) else []
    fault = [f"<p><b>{escape(worded(card.fault))}</b></p>"] if card.fault else []
    return "".join(
        [
            f"<h3>{escape(card_title(card))}</h3>",
            *fault,
            _row(tr("Classes"), ", ".join(card.classes)),
            _row(tr("Pixels it was trained on"), resolution_text(card)),
            _row(tr("Trained on"), _listed(card.trained_on)),
            *notes,
            _quality(card),
            _row(tr("Good for"), card.good_for),
            _row(tr("Not good for"), card.not_for),
            _row(tr("License"), card.license),
            _row(tr("Made"), _made(card)),
            _row(tr("File"), card.file),
        ]
    )


def _row(title: str, text: str) -> str:
    return f"<p><b>{escape(title)}</b><br>{_shown(text)}</p>"


def _shown(text: str) -> str:
    unsaid = escape(tr("not said"))
    return f"<i>{unsaid}</i>" if text in ("", NOTHING) else escape(text).replace("\n", "<br>")


def _listed(grounds: tuple[Ground, ...]) -> str:
    return "\n".join(f"{one.place}: {one.about}" if one.about else one.place for one in grounds)


def _made(card: ModelCard) -> str:
    minutes = "" if card.minutes is None else tr("{minutes:g} minutes of training").format(minutes=card.minutes)
    return ", ".join(part for part in (card.date, minutes) if part)


def _quality(card: ModelCard) -> str:
    """How good it is: IoU by place and class."""
    beside = tr("{place}, set aside")
    rows = [
        (one.place if one.is_left_out else beside.format(place=one.place), one.iou) for one in card.tested_on if one.iou
    ]
    if card.validation_iou:
        rows.append((tr("ground set aside from training"), card.validation_iou))
    lines = [
        f"<i>{escape(place)}</i>: "
        + ", ".join(f"{escape(name)} <b>{percent(share, 0)}</b>" for name, share in iou.items())
        for place, iou in rows
    ]
    if card.tested_on:
        lines.append(escape(tr("Places are tested by networks that were trained without them.")))
    return f"<p><b>{escape(tr('How good (IoU)'))}</b><br>{'<br>'.join(lines) or _shown('')}</p>"
