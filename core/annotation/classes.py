"""Class of a feature of a land-cover layer: from its class field, with a class table or without."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from ..errors import AnnotationError
from ..labels.class_colors import chosen_colors
from ..labels.class_table import BACKGROUND, REFERENCE, ClassTable, LandCoverClass, require_class_count, shortened

StyledClass = tuple[tuple[object, ...], str, str]
"""Raw values of the class field for one class, its name, and its color or an empty text."""

_NAMED_AT_MOST = 5
"""Largest number of unknown class values in a message."""


class ClassLookup:
    """Class values by raw attribute value."""

    def __init__(self, table: ClassTable, by_raw: dict[str, int] | None = None) -> None:
        """Store the table.

        Args:
            by_raw: Class values by the text of the raw value; without it the table's own names and values.
        """
        self.table = table
        self.draw_orders = {c.value: c.draw_order for c in table if c.draw_order is not None}
        self._known: dict[str, int | None] = {**(by_raw or {})}
        self._fixed = by_raw is not None

    def value(self, raw: object) -> int | None:
        """Return the class value of an attribute, or None if the table lacks it."""
        text = raw_text(raw)
        if text not in self._known:
            found = None if self._fixed else self.table.find(text)
            self._known[text] = found.value if found else None
        return self._known[text]

    def raw_values(self, value: int, as_numbers: bool) -> list[object]:
        """Return the possible values of the class field for a class value: numbers, or texts."""
        one = self.table.by_value(value)
        names = [one.name] if one and not as_numbers else []
        known_raws = [raw for raw, known in self._known.items() if known == value]
        texts = known_raws if self._fixed else [*names, str(value)]
        if as_numbers:
            return [int(text) for text in texts if is_whole(text)]
        return list(texts)


def raw_text(raw: object) -> str:
    """Return an attribute as text; whole numbers without decimal point."""
    if isinstance(raw, float) and raw.is_integer():
        return str(int(raw))
    return str(raw).strip()


def is_whole(text: str) -> bool:
    """Return whether a text is a whole number that ``int`` reads: not “²”, not thousands of digits."""
    return re.fullmatch(r"-?\d{1,20}", text) is not None


def distinct(raws: Iterable[object]) -> list[object]:
    """Return each attribute once, in the order of their numbers or texts, without empty ones."""
    found: dict[str, object] = {}
    for raw in raws:
        if raw_text(raw):
            found.setdefault(raw_text(raw), raw)
    numeric = all(map(is_whole, found))
    return [found[text] for text in sorted(found, key=int if numeric else None)]


def lookup_of(found: Sequence[StyledClass], is_number: bool) -> ClassLookup:
    """Return the classes of a layer without a class table.

    Args:
        found: Classes of its features, in order.
        is_number: Whether the class field has numbers.

    Raises:
        ClassTableError: There are too many classes.
    """
    require_class_count(len(found))
    texts = [raw_text(values[0]) for values, _, _ in found]
    as_values = is_number and all(is_whole(t) and 1 <= int(t) <= 255 for t in texts)
    labels = [label for _, label, _ in found]
    if len(set(labels)) < len(labels):
        labels = texts
    numbers = [int(t) for t in texts] if as_values else list(range(1, len(texts) + 1))
    chosen = chosen_colors(zip(numbers, labels))
    # The only class must be the landmark class.
    role = REFERENCE if len(found) == 1 else BACKGROUND
    classes = [
        LandCoverClass(number, label, color or other, role)
        for number, label, (_, _, color), other in zip(numbers, labels, found, chosen)
    ]
    by_raw = {raw_text(value): number for number, (values, _, _) in zip(numbers, found) for value in values}
    return ClassLookup(ClassTable(tuple(classes)), by_raw)


def require_known_classes(unknown: Mapping[str, int], source: str, table: ClassTable) -> None:
    """Raise AnnotationError with the class values that the table lacks.

    Args:
        unknown: Number of features by such a value.
    """
    if not unknown:
        return
    counted = [f"“{text}” ({number})" for text, number in Counter(unknown).most_common()]
    raise AnnotationError(
        "“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or "
        "leave those features out.",
        source=source,
        unknown=shortened(counted, _NAMED_AT_MOST),
        classes=table.describe(),
    )
