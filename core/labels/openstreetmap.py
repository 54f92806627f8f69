"""Rules from OpenStreetMap's tags to land-cover classes (docs/reference/file_formats.md#openstreetmap-rules)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from .. import limits
from ..errors import ParameterError
from ..tables import Row, rows_of_text
from ..values import read_json

ANY = "*"
"""Value of a rule that fits any value of its key."""

THEME_KEYS = ("fclass", "type")
"""Columns of current and older shapefiles that have a tag's value without its key."""

TAG_COLUMNS = ("other_tags", "all_tags", "tags")
"""Columns with further tags, as GDAL's hstore or as JSON."""

LARGEST_WIDTH_M = 100.0
"""Wider lines are errors: wide rivers are mapped as areas."""

LANE_M = 3.5
FOOT_M, INCH_M = 0.3048, 0.0254

_COLUMNS = ("key", "value", "class", "priority")
_WIDTH = re.compile(r"""(\d{1,4}(?:[.,]\d*)?)\s*(?:m|met(?:er|re)s?|(ft|feet|'(?:\s*(\d\d?)")?))?""", re.IGNORECASE)
"""Meters, or feet and inches."""
_LANES = re.compile(r"[1-9]\d?")
_QUOTED = r'"((?:[^"\\]|\\.?)*)("?)'
_HSTORE = re.compile(rf"{_QUOTED}(?:\s*=>\s*(?:{_QUOTED}|NULL))?", re.DOTALL)
"""Pairs, and texts that are not pairs. The pattern can't fail and never backtracks, so the search is linear."""
_ESCAPED = re.compile(r"\\(.)", re.DOTALL)


@dataclass(frozen=True)
class Rule:
    """Class of a tag.

    Attributes:
        value: Value of the tag, or ANY.
        class_name: The land-cover class; empty to skip the polygons.
        priority: The highest fitting rule counts; polygons of higher priority are drawn on top.
        width_m: Width of lines; None for a rule that gives them no area.
    """

    key: str
    value: str
    class_name: str
    priority: int
    width_m: float | None = None

    @property
    def tag(self) -> str:
        """``key=value``."""
        return f"{self.key}={self.value}"


class Rules:
    """Rules, looked up by tag."""

    def __init__(self, rules: Iterable[Rule]) -> None:
        """Index the rules; the first one for a tag counts."""
        self._rules: dict[tuple[str, str], Rule] = {}
        self._by_theme: dict[str, Rule] = {}
        for rule in rules:
            self._rules.setdefault((rule.key, rule.value), rule)
            theme = rule.key if rule.value == ANY else rule.value
            self._by_theme.setdefault(theme, rule)

    @property
    def for_lines(self) -> Rules:
        """The rules that apply to lines: those with a width or without a class."""
        return Rules(rule for rule in self._rules.values() if rule.width_m or not rule.class_name)

    def __len__(self) -> int:
        return len(self._rules)

    @property
    def classes(self) -> tuple[str, ...]:
        """Names of the classes, those drawn on top first."""
        named = [rule for rule in self._rules.values() if rule.class_name]
        return tuple(dict.fromkeys(rule.class_name for rule in sorted(named, key=lambda rule: -rule.priority)))

    def of(self, tags: Mapping[str, str]) -> Rule | None:
        """Return the rule of the highest priority that fits one of the tags; None without one.

        A rule for the exact value of a tag replaces one for any value of its key.
        """
        fitting = [self._of_tag(key, value) for key, value in tags.items()]
        return max((rule for rule in fitting if rule), key=lambda rule: rule.priority, default=None)

    def _of_tag(self, key: str, value: str) -> Rule | None:
        if key in THEME_KEYS:
            return self._by_theme.get(value)
        return self._rules.get((key, value)) or self._rules.get((key, ANY))


def rules_from_csv(text: str, source: str) -> Rules:
    """Read ``key,value,class,priority`` and an optional ``width``, separated by ``,``, ``;`` or tab.

    Args:
        source: The file, for messages.

    Raises:
        ParameterError: The table is malformed; the message names ``source`` and the line.
    """
    found = [_rule(row) for row in rows_of_text(text, source, lambda columns: columns.need(_COLUMNS))]
    if not 1 <= len(found) <= limits.RULES:
        raise ParameterError(
            "{source} is not a table of rules. It needs a header key,value,class,priority, then 1 to {most} lines.",
            source=source,
            most=limits.RULES,
        )
    return Rules(found)


def tags_of(columns: Mapping[str, object]) -> dict[str, str]:
    """Return the tags of a feature.

    Args:
        columns: Value by column: one column per tag, as from GDAL and QuickOSM, and columns of TAG_COLUMNS.

    Returns:
        Value by key, without empty ones; a tag with its own column overrides one in TAG_COLUMNS.
    """
    tags: dict[str, str] = {}
    for name in TAG_COLUMNS:
        tags.update(_packed(columns.get(name)))
    own = {key: str(value).strip() for key, value in columns.items() if key not in TAG_COLUMNS and value is not None}
    return {**tags, **{key: value for key, value in own.items() if value}}


def line_width_m(tags: Mapping[str, str], rule: Rule) -> float:
    """Return the width of a line: of its tag ``width`` or ``lanes`` if it is clear, otherwise that of the rule."""
    found = _WIDTH.fullmatch(tags.get("width", "").strip())
    if found:
        number, feet, inches = found.groups()
        width = float(number.replace(",", ".")) * (FOOT_M if feet else 1.0) + INCH_M * int(inches or 0)
        if 0 < width <= LARGEST_WIDTH_M:
            return width
    lanes = tags.get("lanes", "").strip()
    return LANE_M * int(lanes) if _LANES.fullmatch(lanes) else rule.width_m or 0.0


def _packed(text: object) -> dict[str, str]:
    """Return the tags in one text: hstore ``"key"=>"value"`` or a JSON object; empty for anything else."""
    if not isinstance(text, str):
        return {}
    if text.lstrip().startswith("{"):
        try:
            found = read_json(text)
        except (ValueError, RecursionError):
            return {}
        return {key: str(value) for key, value in found.items() if isinstance(value, (str, int, float))}
    return {
        _ESCAPED.sub(r"\1", key): _ESCAPED.sub(r"\1", value)
        for key, _, value, end in _HSTORE.findall(text)
        if value and end
    }


def _rule(row: Row) -> Rule:
    where = row.place
    key, value, name, priority, width = (row.texts.get(column, "") for column in (*_COLUMNS, "width"))
    if not key or not value:
        raise ParameterError("{where}: a rule needs a key and a value; use * for any value.", where=where)
    if len(name) > limits.NAME_CHARACTERS:
        raise ParameterError(
            "{where}: the name of the class has more than {most} characters; use a shorter name.",
            where=where,
            most=limits.NAME_CHARACTERS,
        )
    if not re.fullmatch(r"-?[0-9]{1,6}", priority):
        raise ParameterError(
            "{where}: “{text}” is not a whole number; the column priority needs one.", where=where, text=priority
        )
    if width and not (re.fullmatch(r"\d{1,3}(\.\d*)?", width) and 0 < float(width) <= LARGEST_WIDTH_M):
        raise ParameterError(
            "{where}: “{text}” is not a width of lines; the column width needs a number of meters above 0 and up to "
            "{most:g}, or nothing.",
            where=where,
            text=width,
            most=LARGEST_WIDTH_M,
        )
    return Rule(key, value, name, int(priority), float(width) if width else None)
