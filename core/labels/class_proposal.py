"""Propose a class table for the classes of a land-cover layer: values, colors and roles by style, preset and name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .class_colors import chosen_colors, is_usual_landmark
from .class_table import BACKGROUND, MAXIMUM_VALUE, REFERENCE, ClassTable, LandCoverClass, require_class_count


@dataclass(frozen=True)
class FoundClass:
    """A class of a layer.

    Attributes:
        text: Value of the class field.
        title: Label in the layer's style; the text without a style.
        color: ``#rrggbb`` of the layer's style; empty without one.
        value: Number in the class field, 1–255; None if it has texts or other numbers.
    """

    text: str
    title: str
    color: str = ""
    value: int | None = None


def proposed_table(found: Sequence[FoundClass], preset: ClassTable | None = None) -> ClassTable:
    """Return a class table for a layer, with the layer's own texts as names, so that the table fits the layer.

    A class with a number keeps it as its value and gets its name from the style. Other classes get the values of the
    nomenclature if it contains them, and the next free values otherwise.

    Args:
        found: Each class once.
        preset: Class table of a nomenclature, if any.

    Raises:
        ClassTableError: There are more classes than a label map has values.
    """
    require_class_count(len(found))
    known = [preset.find(one.text) if preset else None for one in found]
    values = _values(found, known)
    named = _names(found, known)
    chosen = chosen_colors(zip(values, named))
    return ClassTable(
        tuple(
            LandCoverClass(value, name, one.color or (same.color if same else color), _role(name, same))
            for one, same, value, name, color in zip(found, known, values, named, chosen)
        )
    )


def _role(name: str, same: LandCoverClass | None) -> str:
    return same.role if same else REFERENCE if is_usual_landmark(name) else BACKGROUND


def _values(found: Sequence[FoundClass], known: Sequence[LandCoverClass | None]) -> list[int]:
    """Return distinct class values: the layer's own, else the nomenclature's, else free ones in order."""
    taken: set[int] = set()
    wanted = []
    for one, same in zip(found, known):
        value = one.value if one.value is not None else same.value if same else None
        wanted.append(None if value in taken or value == 0 else value)
        taken.add(value or 0)
    # Values above the others first, so that whole nomenclatures keep their order.
    first = max(taken, default=0) + 1
    free = [n for n in (*range(first, MAXIMUM_VALUE + 1), *range(1, first)) if n not in taken]
    return [free.pop(0) if value is None else value for value in wanted]


def _names(found: Sequence[FoundClass], known: Sequence[LandCoverClass | None]) -> list[str]:
    """Return names by which the layer's texts find their classes; numbers may get names from style or nomenclature."""
    names = []
    for one, same in zip(found, known):
        name = one.text
        if one.value is not None:
            name = same.name if same and one.title == one.text else one.title
        elif same and same.name.startswith(f"{one.text} "):
            # The text is a code, which finds the name that starts with it.
            name = same.name
        names.append(name)
    doubled = {name for name in names if names.count(name) > 1}
    return [one.text if name in doubled else name for one, name in zip(found, names)]
