"""Inputs from samples: bytes, texts, tables and JSON changed by a seeded random, with the words that hurt."""

from __future__ import annotations

import copy
import json
import struct
from collections.abc import Sequence
from random import Random
from typing import Any, Callable

NUMBERS = (
    *("NaN", "nan", "-nan", "inf", "-inf", "Infinity", "1e308", "-1e308", "1e400", "1e-320", "0", "-0", "-1", "0.5"),
    *("1", "2", "127", "128", "180", "181", "-181", "255", "256", "300", "65535", "65536", "2147483647", "2147483648"),
    *("-2147483649", "4294967296", "9007199254740993", "9223372036854775808", "1" * 70, "1" * 500, "9" * 5000, "0x10"),
    *("1_000", "1,5", "٣", "１", "½", "²", "1e", "+", "-", ".", "1e999999999", "00", "007", "3.0", "1 000"),
)
TEXTS = (
    *(
        "",
        " ",
        "\t",
        "null",
        "None",
        "true",
        "True",
        "[]",
        "{}",
        "[[]]",
        '{"":0}',
        '"',
        "'",
        '""',
        "`",
        "\0",
        "\x1b[2J",
    ),
    *(
        "é",
        "e\u0301",
        "日本",
        "\U0001f300",
        "\u202e",
        "\u2028",
        "\x85",
        "\x1c",
        "\ufeff",
        "\r",
        "\n",
        "\r\n",
        "%s",
        "%n",
    ),
    *("{", "}", "{0}", "{name}", "{path!r}", "<b>", "<a href='x'>y</a>", "&amp;", "../../../etc/passwd", "/dev/zero"),
    *(
        "C:\\x",
        "//host/share",
        "a/b",
        ".",
        "..",
        ";",
        ",",
        "=1+1",
        "@SUM(A1)",
        "#ffffff",
        "#FFF",
        "reference",
        "--",
        "-",
    ),
    *("x" * 255, "x" * 256, "[" * 40, "é" * 255),
)
HUGE = ("x" * 10_001, "x" * 140_000, "[" * 100_000, "(" * 900, "{'a':" * 300)
"""Taken now and then only, for they cost time."""
WHOLE = (0, 1, -1, 2, 3, 7, 8, 16, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1, 2**63)
JSON_VALUES = (
    *(None, True, False, 0, -1, 1, 255, 2**31, 2**63, 10**60, 10**400, 0.5, -0.0, 1e308, 1e-320, float("nan")),
    *(float("inf"), float("-inf"), "", "x", "NaN", "x" * 300, [], {}, [[]], [0], [None], {"": None}),
    *([1e308] * 6, [float("nan")] * 6, [0] * 256, "\0", "\ud800", "{0}", "é", [[[[[[[[1]]]]]]]]),
)


_FACTORS = (-1, 0, 1.0000001, 1e9, 1e-9, 2, 0.5)


def mutated_bytes(random: Random, data: bytes, tokens: Sequence[bytes] = (), most: int = 6) -> bytes:
    """The data with one to ``most`` changes: bits, bytes, numbers, tokens, pieces lost, doubled, moved."""
    found = bytearray(data)
    for _ in range(random.choice((1, 1, 1, 2, 3, most))):
        place = random.randrange(len(found) + 1)
        kind = random.randrange(10)
        if kind == 0 or not found:
            found[place:place] = random.choice(tokens) if tokens else random.randbytes(4)
        elif kind in (1, 2):
            found[place % len(found)] ^= 1 << random.randrange(8)
        elif kind == 3:
            found[place % len(found)] = random.randrange(256)
        elif kind == 4:
            code = random.choice(("<H", ">H", "<I", ">I", "<Q", ">Q", "<d", ">d"))
            value = random.choice(WHOLE) & ((1 << 8 * struct.calcsize(code)) - 1)
            packed = struct.pack(code, float(value) if code[1] == "d" else value)
            found[place : place + len(packed)] = packed
        elif kind == 5:
            del found[place : place + random.choice((1, 2, 4, 16, 64, 1000))]
        elif kind == 6:
            end = place + random.choice((1, 4, 16, 64, 256))
            found[place:place] = found[place:end] * random.choice((1, 1, 2, 50))
        elif kind == 7:
            del found[place:]
        elif kind == 8:
            other, length = random.randrange(len(found)), random.choice((1, 4, 8, 32))
            found[place : place + length] = found[other : other + length]
        elif tokens:
            token = random.choice(tokens)
            found[place : place + len(token)] = token
    return bytes(found)


def word(random: Random, more: Sequence[str] = ()) -> str:
    """A text that hurts."""
    kind = random.randrange(4)
    if random.random() < 0.01:
        return random.choice(HUGE)
    if kind == 0 and more:
        return random.choice(more)
    if kind == 1:
        return random.choice(TEXTS)
    if kind == 2:
        return "".join(chr(random.choice((random.randrange(128), random.randrange(0xD7FF)))) for _ in range(5))
    return random.choice(NUMBERS)


def mutated_table(random: Random, text: str, words: Sequence[str] = ()) -> bytes:
    """A CSV with cells, columns and lines changed, in one of several encodings."""
    separator = random.choice((",", ",", ",", ";", "\t"))
    rows = [line.split(",") for line in text.splitlines()]
    for _ in range(random.choice((1, 1, 2, 4))):
        kind, row = random.randrange(9), random.choice(rows) if rows else []
        if kind <= 3 and row:
            row[random.randrange(len(row))] = word(random, words)
        elif kind == 4 and len(row) > 1:
            a, b = random.sample(range(len(row)), 2)
            row[a], row[b] = row[b], row[a]
        elif kind == 5 and rows:
            rows.insert(random.randrange(len(rows) + 1), list(row))
        elif kind == 6 and rows:
            rows.remove(row)
        elif kind == 7 and row:
            row.insert(random.randrange(len(row) + 1), word(random, words))
        elif row:
            del row[random.randrange(len(row))]
    if random.random() < 0.2:
        rows = [[f'"{cell}"' for cell in row] for row in rows]
    found = random.choice(("\n", "\n", "\r\n", "\r")).join(separator.join(row) for row in rows)
    data = found.encode(random.choice(("utf-8",) * 6 + ("utf-8-sig", "latin-1", "utf-16")), "replace")
    return mutated_bytes(random, data) if random.random() < 0.2 else data


def mutated_json(random: Random, value: Any, words: Sequence[Any] = ()) -> Any:
    """A copy of a JSON value with one to four of its parts replaced, lost, doubled or wrapped."""
    holder = [copy.deepcopy(value)]
    for _ in range(random.choice((1, 1, 2, 4))):
        _change_part(random, holder, words)
    return holder[0]


def _change_part(random: Random, holder: list, words: Sequence[Any]) -> None:
    places = list(_places(holder))
    parent, key = random.choice(places)
    kind = random.randrange(8)
    if kind <= 3:
        found = random.choice(words) if words and kind == 0 else random.choice(JSON_VALUES)
        # Copied: what is put in may be changed in turn.
        parent[key] = copy.deepcopy(found) if random.random() < 0.995 else random.choice(HUGE)
    elif kind == 4 and parent is not holder:
        del parent[key]
    elif kind == 5:
        parent[key] = [parent[key]]
    elif kind == 6:
        other, place = random.choice(places)
        parent[key] = copy.deepcopy(other[place]) if other is not holder else parent[key]
    elif isinstance(parent[key], (int, float)) and not isinstance(parent[key], bool):
        parent[key] = parent[key] * random.choice((-1, 0, 2, 10**9) if abs(parent[key]) > 1e300 else _FACTORS)
    elif isinstance(parent[key], str):
        parent[key] = word(random)


def _places(value: Any, most: int = 200) -> list[tuple]:
    """(parent, key) of all parts of a value."""
    found, waiting = [], [value]
    while waiting and len(found) < most:
        parent = waiting.pop()
        keys = range(len(parent)) if isinstance(parent, list) else list(parent) if isinstance(parent, dict) else ()
        for key in keys:
            found.append((parent, key))
            waiting.append(parent[key])
    return found


def json_bytes(random: Random, value: Any) -> bytes:
    """JSON as text, now and then damaged."""
    data = json.dumps(value, ensure_ascii=random.random() < 0.5).encode("utf-8", "surrogatepass")
    if random.random() < 0.15:
        return mutated_bytes(random, data, [b"[" * 5000, b"1e400", b"NaN", b"\\ud800", b'"', b"{", b"9" * 5000])
    return data


def one_of(random: Random, *makers: Callable[[Random], Any]) -> Any:
    """What one of the makers gives."""
    return random.choice(makers)(random)
