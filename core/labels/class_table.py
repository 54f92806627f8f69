"""The class table: value, name, color and role of every class (docs/reference/file_formats.md#class-table)."""

from __future__ import annotations

import csv
import hashlib
import io
import math
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from .. import limits
from ..errors import ClassTableError, ParameterError
from ..sentences import Sentence
from ..tables import Row, rows_of_text
from ..values import shown
from .class_colors import chosen_colors, default_color

UNLABELED = 0
"""Label of pixels without a class ("unlabeled/other")."""

MAXIMUM_VALUE = 255
"""Largest class value of a uint8 label map."""

REFERENCE = "reference"
BACKGROUND = "background"
ROLES = (REFERENCE, BACKGROUND)

BENEATH_ALL = -1_000_000.0
"""Draw order of a class that covers the ground without polygons."""

OTHER = "other"
"""Name of such a class, also in networks that learned unlabeled ground as a class."""

LIST_SEPARATOR = ";"
"""Separates the items of lists given as text (REFERENCE_CLASSES=building;water)."""

_NEEDED = ("value", "name")
_COLUMNS = (*_NEEDED, "color", "role", "draw_order", "hsv_min", "hsv_max")

Hsv = tuple[int, int, int]
Rgb = tuple[int, int, int]


@dataclass(frozen=True)
class LandCoverClass:
    """One row of the class table.

    Attributes:
        value: Of its pixels in a label map, 0 to 255.
        name: For people.
        color: ``#rrggbb``.
        role: ``reference`` or ``background``.
        draw_order: Higher ones are drawn over lower ones; None if undefined.
        hsv_min: Lower limit (h, s, v) in OpenCV's ranges, h 0–180, s and v 0–255; None without a range.
        hsv_max: Upper limit (h, s, v); the hue range may wrap (h_min > h_max).

    Raises:
        ClassTableError: A value is outside these ranges.
    """

    value: int
    name: str
    color: str
    role: str = BACKGROUND
    draw_order: float | None = None
    hsv_min: Hsv | None = None
    hsv_max: Hsv | None = None

    def __post_init__(self) -> None:
        if self.draw_order is not None and not math.isfinite(self.draw_order):
            raise ClassTableError(
                "Class “{name}” has a draw_order that is not a finite number; use a number such as 3.",
                name=shown(self.name),
            )
        if not 0 <= self.value <= MAXIMUM_VALUE:
            raise ClassTableError(
                "Class “{name}” has the value {value}; class values go from 0 to {most}.",
                name=self.name,
                value=shown(self.value),
                most=MAXIMUM_VALUE,
            )
        if len(self.name) > limits.NAME_CHARACTERS:
            raise ClassTableError(
                "The name of class {value} has more than {most} characters; use a shorter name.",
                value=self.value,
                most=limits.NAME_CHARACTERS,
            )
        if not self.name:
            raise ClassTableError("The class with value {value} has no name; add one.", value=self.value)
        if not re.fullmatch(r"#[0-9a-fA-F]{6}", self.color):
            raise ClassTableError(
                "Class “{name}” has the color “{color}”; write it as #rrggbb.", name=self.name, color=self.color
            )
        if self.role not in ROLES:
            raise ClassTableError(
                "Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.",
                name=self.name,
                role=self.role,
                reference=REFERENCE,
                background=BACKGROUND,
            )
        if self.value == UNLABELED and self.role == REFERENCE:
            raise ClassTableError(
                "Class “{name}” has the value 0, which means unlabeled; it can't be a reference class.", name=self.name
            )
        if (self.hsv_min is None) != (self.hsv_max is None):
            raise ClassTableError(
                "Class “{name}” has only one of hsv_min and hsv_max; fill in both, or leave both empty.", name=self.name
            )

    @property
    def is_reference(self) -> bool:
        """Whether its regions are landmarks."""
        return self.role == REFERENCE

    @property
    def rgb(self) -> Rgb:
        """The color as (red, green, blue), 0–255."""
        return int(self.color[1:3], 16), int(self.color[3:5], 16), int(self.color[5:7], 16)


@dataclass(frozen=True)
class ClassTable:
    """The classes of a map.

    Attributes:
        classes: In ascending order of value.

    Raises:
        ClassTableError: Values or names repeat.
    """

    classes: tuple[LandCoverClass, ...]

    def __post_init__(self) -> None:
        """Sort the classes and refuse repeated ones."""
        object.__setattr__(self, "classes", tuple(sorted(self.classes, key=lambda c: c.value)))
        for column in ("value", "name"):
            keys = [str(getattr(c, column)) for c in self.classes]
            repeated = sorted({key for key in keys if keys.count(key) > 1})
            if repeated:
                raise ClassTableError(
                    "The class table has the {column} {repeated} more than once; values and names must be unique.",
                    column=column,
                    repeated=repeated,
                )

    def __iter__(self) -> Iterator[LandCoverClass]:
        """Iterate in order of value."""
        return iter(self.classes)

    def __len__(self) -> int:
        return len(self.classes)

    @property
    def references(self) -> tuple[LandCoverClass, ...]:
        """The reference classes in order of value; the rank of a class is its 1-based index here."""
        return tuple(c for c in self.classes if c.is_reference)

    @property
    def reference_values(self) -> tuple[int, ...]:
        """Values of the reference classes, ascending."""
        return tuple(c.value for c in self.references)

    def by_value(self, value: int) -> LandCoverClass | None:
        """Return the class with a value; None without one."""
        return next((c for c in self.classes if c.value == value), None)

    @property
    def filling(self) -> LandCoverClass | None:
        """The class that covers the ground without polygons; None without one."""
        return next((c for c in self.classes if c.value != UNLABELED and c.draw_order == BENEATH_ALL), None)

    def with_filling(self) -> ClassTable:
        """Return the table with a class that covers the ground without polygons: ``other``, unless it has one.

        Raises:
            ClassTableError: All values are in use.
        """
        if self.filling is not None:
            return self
        kept = [c for c in self.classes if c.name.casefold() != OTHER]
        known = next((c for c in self.classes if c.name.casefold() == OTHER and c.value != UNLABELED), None)
        if known is None:
            taken = {c.value for c in kept}
            free = [value for value in range(1, MAXIMUM_VALUE + 1) if value not in taken]
            require_class_count(MAXIMUM_VALUE if free else MAXIMUM_VALUE + 1)
            known = LandCoverClass(free[0], OTHER, chosen_colors([(free[0], OTHER)])[0])
        return ClassTable((*kept, replace(known, draw_order=BENEATH_ALL)))

    def find(self, text: str) -> LandCoverClass | None:
        """Return the class for a text: its name (else ignoring case), its code or title, or its value.

        Names in nomenclatures start with a code of three digits or more: “311” and “Broad-leaved forest” both find
        “311 Broad-leaved forest”.
        """
        wanted = text.strip()
        folded = wanted.casefold()
        for key in (
            lambda c: c.name == wanted,
            lambda c: c.name.casefold() == folded,
            lambda c: folded in [part.casefold() for part in _code_and_title(c.name)],
        ):
            found = [c for c in self.classes if key(c)]
            if len(found) == 1:
                return found[0]
        return self.by_value(int(wanted)) if re.fullmatch(r"\d{1,3}", wanted) else None

    def with_references(self, names_or_values: Sequence[str]) -> ClassTable:
        """Return the table with exactly the named classes as reference classes.

        Args:
            names_or_values: Texts for ``find``.

        Raises:
            ClassTableError: A name is unknown.
        """
        chosen = set()
        for text in names_or_values:
            found = self.find(text)
            if found is None:
                raise ClassTableError(
                    "There is no class “{text}”; the classes are {classes}.", text=text, classes=self.describe()
                )
            chosen.add(found.value)
        return ClassTable(tuple(replace(c, role=REFERENCE if c.value in chosen else BACKGROUND) for c in self.classes))

    def require_references(self) -> ClassTable:
        """Return the table itself. Raises ClassTableError: it has no reference class."""
        if not self.classes:
            raise ClassTableError("There are no classes. Choose a label map with labeled pixels, or a class table.")
        if not self.references:
            raise ClassTableError(
                "No class is a reference class. Choose at least one of {classes}, or give it the role “reference” in "
                "the class table.",
                classes=self.describe(),
            )
        return self

    def describe(self) -> tuple[str, ...] | Sentence:
        """Return “1 building, 2 bare_land” as a value of a sentence."""
        return shortened([f"{c.value} {c.name}" for c in self.classes])

    def digest(self) -> str:
        """Return the SHA-256 of the table's CSV text: equal tables have equal digests."""
        return hashlib.sha256(self.to_csv().encode("utf-8")).hexdigest()

    def to_csv(self) -> str:
        """Return CSV text with the header ``value,name,color,role,draw_order,hsv_min,hsv_max``."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(_COLUMNS)
        for c in self.classes:
            order = "" if c.draw_order is None else _number_text(c.draw_order)
            writer.writerow([c.value, c.name, c.color, c.role, order, _hsv_text(c.hsv_min), _hsv_text(c.hsv_max)])
        return text.getvalue()


def class_table_from_csv(text: str, source: str = "the class table") -> ClassTable:
    """Read ``value,name,color,role[,draw_order][,hsv_min,hsv_max]``, separated by ``,``, ``;`` or tab.

    ``color`` and ``role`` are optional: the defaults are a chosen color and ``background``.

    Args:
        source: The file, for messages.

    Raises:
        ClassTableError: The table is malformed; the message names ``source`` and the line.
    """
    try:
        found = [_class_from_row(row) for row in rows_of_text(text, source, lambda columns: columns.need(_NEEDED))]
    except ParameterError as error:
        raise ClassTableError(error.sentence) from None
    if not found:
        raise ClassTableError(
            "{source} has no classes. It needs a header value,name,color,role and one line per class.", source=source
        )
    if len(found) > MAXIMUM_VALUE + 1:  # value 0 may have a name, too
        require_class_count(len(found))
    colorless = [one for one, has_color in found if not has_color]
    chosen = dict(zip(map(id, colorless), chosen_colors((one.value, one.name) for one in colorless)))
    return ClassTable(tuple(replace(one, color=chosen.get(id(one), one.color)) for one, _ in found))


def class_table_from_names(names: Iterable[str]) -> ClassTable:
    """Return a table for class names only: values 1, 2, … in the given order, chosen colors, all background."""
    found = list(names)
    require_class_count(len(found))
    colors = chosen_colors(enumerate(found, start=1))
    return ClassTable(tuple(LandCoverClass(i, *both) for i, both in enumerate(zip(found, colors), start=1)))


def require_class_count(count: int) -> None:
    """Raise ClassTableError for more classes than a label map has values."""
    if count > MAXIMUM_VALUE:
        raise ClassTableError(
            "There are {count} classes, but a label map can store {most}. Choose another class field, or merge classes "
            "with a class table.",
            count=count,
            most=MAXIMUM_VALUE,
        )


def class_table_from_values(values: Iterable[int]) -> ClassTable:
    """Return a table for class values only: named by their value, chosen colors, all background."""
    return ClassTable(tuple(LandCoverClass(v, str(v), default_color(v)) for v in sorted(set(values))))


def _code_and_title(name: str) -> tuple[str, ...]:
    """Return the code at the beginning of a name and the rest; empty for a name without a code."""
    found = re.fullmatch(r"(\d{3,})\s+(.+)", name)
    return found.groups() if found else ()


def split_list(text: str | None) -> list[str]:
    """Return the items of a list given as text, without empty ones: ``"building; water"`` → ["building", "water"]."""
    return [item.strip() for item in (text or "").split(LIST_SEPARATOR) if item.strip()]


def shortened(items: Sequence[str], most: int = 12) -> tuple[str, ...] | Sentence:
    """Return the items as a value of a sentence; of many the first ``most``, and the number of the rest."""
    if len(items) <= most:
        return tuple(items)
    return Sentence("{shown} and {count} more", shown=items[:most], count=len(items) - most)


def _class_from_row(row: Row) -> tuple[LandCoverClass, bool]:
    """Return a class, and whether its row states a color."""
    cell, where = defaultdict(str, row.texts), row.place
    try:
        value = int(cell["value"])
    except ValueError:
        raise ClassTableError(
            "{where}: “{text}” is not a whole number; the column value needs 0 to 255.", where=where, text=cell["value"]
        ) from None
    try:
        order = float(cell["draw_order"]) if cell.get("draw_order") else None
    except ValueError:
        raise ClassTableError(
            "{where}: “{text}” is not a number; draw_order needs a number or nothing.",
            where=where,
            text=cell["draw_order"],
        ) from None
    hsv_min, hsv_max = (_hsv(cell[name], where) for name in ("hsv_min", "hsv_max"))
    try:
        made = LandCoverClass(
            value=value,
            name=cell["name"],
            color=(cell.get("color") or default_color(value)).lower(),
            role=(cell.get("role") or BACKGROUND).lower(),
            draw_order=order,
            hsv_min=hsv_min,
            hsv_max=hsv_max,
        )
    except ClassTableError as error:
        raise ClassTableError("{where}: {fault}", where=where, fault=error.sentence) from None
    return made, bool(cell.get("color"))


def _hsv(text: str, where: Sentence) -> Hsv | None:
    if not text:
        return None
    parts = text.split()
    limits = (180, 255, 255)
    # Python refuses to convert thousands of digits.
    are_short = all(part.isdecimal() and len(part) < 10 for part in parts)
    if len(parts) != 3 or not are_short or any(int(p) > m for p, m in zip(parts, limits)):
        raise ClassTableError(
            "{where}: “{text}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).",
            where=where,
            text=text,
        )
    return int(parts[0]), int(parts[1]), int(parts[2])


def _number_text(number: float) -> str:
    """Return the shortest text that reads back as the same number: 3, 0.1, 1234567.0."""
    short = f"{number:g}"
    return short if float(short) == number else repr(number)


def _hsv_text(hsv: Hsv | None) -> str:
    return "" if hsv is None else " ".join(str(part) for part in hsv)
