"""Write a model's card as a Markdown page next to the model file."""

from __future__ import annotations

from pathlib import Path

from semref.core.segmentation.model_card import Ground, ModelCard


def card_page(card: ModelCard) -> str:
    """Return the whole page in English."""
    pixels = "" if card.resolution_m is None else f"{card.resolution_m:g} m a pixel"
    minutes = "" if card.minutes is None else f", {card.minutes:g} minutes of one processor"
    rows = [
        ("classes", ", ".join(card.classes)),
        ("trained at", pixels),
        ("trained on", "<br>".join(f"{one.place}: {one.about}" for one in card.trained_on)),
        ("good for", card.good_for),
        ("not good for", card.not_for),
        ("license", card.license),
        ("made", f"{card.date}{minutes}"),
    ]
    lines = [f"# {card.name or Path(card.file).stem}", "", f"`{Path(card.file).name}`", "", "| | |", "|---|---|"]
    lines += [f"| {title} | {text} |" for title, text in rows if text]
    return "\n".join([*lines, "", *quality_table(card)]) + "\n"


def quality_table(card: ModelCard) -> list[str]:
    """Return lines with the IoU per class by place; an empty list without figures."""
    tested = [one for one in card.tested_on if one.iou]
    if card.validation_iou:
        tested.append(Ground("parts set aside of the ground trained on", iou=card.validation_iou))
    if not tested:
        return []
    names = list(dict.fromkeys(name for one in tested for name in one.iou))
    lines = [f"| IoU on | {' | '.join(names)} |", "|---|" + "---|" * len(names)]
    for one in tested:
        shown = (f"{one.iou[name]:.3f}" if name in one.iou else "–" for name in names)
        lines.append(f"| {one.place}{', left out of training' if one.is_left_out else ''} | {' | '.join(shown)} |")
    return lines
