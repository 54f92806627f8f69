"""A model card as HTML: classes, training ground, quality and suitable uses."""

from __future__ import annotations

import os

from ...core.segmentation.model_card import ModelCard
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr
from .page import NO_BREAK, NOTHING, macros, percent


def card_title(card: ModelCard) -> str:
    """Return the name of a model, or of its file."""
    return card.name or os.path.splitext(os.path.basename(card.file))[0]


def resolution_text(card: ModelCard) -> str:
    """Return the pixel size in m or cm."""
    if card.resolution_m is None:
        return NOTHING
    return (
        f"{shown(card.resolution_m, 'g')}{NO_BREAK}m"
        if card.resolution_m >= 1
        else f"{shown(100 * card.resolution_m, 'g')}{NO_BREAK}cm"
    )


def quality_text(card: ModelCard) -> str:
    """Return the mean IoU in percent."""
    return NOTHING if card.mean_iou is None else percent(card.mean_iou, 0)


def card_html(card: ModelCard) -> str:
    """Return the card as HTML that Qt's text browser supports."""
    from markupsafe import Markup

    rows = [
        (tr("Classes"), [", ".join(card.classes)]),
        (tr("Pixel size"), [resolution_text(card)]),
        (tr("Trained on"), [f"{one.place}: {one.about}" if one.about else one.place for one in card.trained_on]),
        (tr("Quality (IoU)"), _quality_lines(card)),
        (tr("Suitable for"), card.good_for.splitlines()),
        (tr("Not suitable for"), card.not_for.splitlines()),
        (tr("License"), card.license.splitlines()),
        (tr("Training"), [_training_text(card)]),
        (tr("File"), [card.file]),
    ]
    if not (card.fault or card.trained_on):
        text = tr("The model does not state its training ground. Test it on a photo of a known place.")
        rows.insert(3, ("", [Markup("<i>{}</i>").format(text)]))
    known = [(title, [line for line in lines if line not in ("", NOTHING)]) for title, lines in rows]
    return str(macros().card(card_title(card), worded(card.fault) if card.fault else "", known, tr("not stated")))


def _training_text(card: ModelCard) -> str:
    minutes = "" if card.minutes is None else tr("{minutes:g} minutes").format(minutes=card.minutes)
    return ", ".join(part for part in (card.date, minutes) if part)


def _quality_lines(card: ModelCard) -> list[str]:
    from markupsafe import Markup

    beside = tr("{place}, validation ground")
    found = [
        (one.place if one.is_left_out else beside.format(place=one.place), one.iou) for one in card.tested_on if one.iou
    ]
    if card.validation_iou:
        found.append((tr("validation ground"), card.validation_iou))
    lines = []
    for place, iou in found:
        shares = [Markup("{} <b>{}</b>").format(name, percent(share, 0)) for name, share in iou.items()]
        lines.append(Markup("<i>{}</i>: {}").format(place, Markup(", ").join(shares)))
    if card.tested_on:
        lines.append(tr("Each place was tested with a network that was trained without this place."))
    return lines
