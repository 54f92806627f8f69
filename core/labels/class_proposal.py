"""A class table for the classes that an annotation has: values, colors and roles by style, nomenclature and name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .class_colors import is_usual_landmark
from .class_table import (
    BACKGROUND,
    MAXIMUM_VALUE,
    REFERENCE,
    ClassTable,
    LandCoverClass,
    chosen_colors,
    require_class_count,
)


@dataclass(frozen=True)
class FoundClass:
    """A class as a layer has it.

    Attributes:
        text: What the class field holds.
        title: What the layer's style calls it; the text without a style.
        color: ``#rrggbb`` of the layer's style; empty without one.
        value: The class field's number, 1–255; None where it holds texts or other numbers.
    """

    text: str
    title: str
    color: str = ""
    value: int | None = None


def proposed_table(found: Sequence[FoundClass], preset: ClassTable | None = None) -> ClassTable:
    """Return a class for each that was found, under the text that the layer has, so that the table is the layer's.

    A class that is known by its number keeps it as its value and is named by the style. Of the others those that the
    nomenclature knows have its values; the rest take the next free ones.

    Args:
        found: Each once.
        preset: Of a nomenclature; None for none.

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
    """Class values, each once: the layer's own, the nomenclature's, else free ones in order."""
    taken: set[int] = set()
    wanted = []
    for one, same in zip(found, known):
        value = one.value if one.value is not None else same.value if same else None
        wanted.append(None if value in taken or value == 0 else value)
        taken.add(value or 0)
    # Behind the others first, so that whole nomenclatures keep their order.
    first = max(taken, default=0) + 1
    free = [n for n in (*range(first, MAXIMUM_VALUE + 1), *range(1, first)) if n not in taken]
    return [free.pop(0) if value is None else value for value in wanted]


def _names(found: Sequence[FoundClass], known: Sequence[LandCoverClass | None]) -> list[str]:
    """Return names by which the layer's own texts find their classes: numbers may be named by style or nomenclature."""
    names = []
    for one, same in zip(found, known):
        name = one.text
        if one.value is not None:
            name = same.name if same and one.title == one.text else one.title
        elif same and same.name.startswith(f"{one.text} "):
            # A code: the name that begins with it is found by it.
            name = same.name
        names.append(name)
    doubled = {name for name in names if names.count(name) > 1}
    return [one.text if name in doubled else name for one, name in zip(found, names)]
