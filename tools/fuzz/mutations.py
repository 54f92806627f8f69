"""Inputs from samples: bytes and words changed by a random that hypothesis shrinks, with the words that hurt."""

from __future__ import annotations

import contextlib
import io
import re
import sqlite3
import struct
import zipfile
import zlib
from collections.abc import Sequence
from random import Random

NUMBERS = (
    *("NaN", "-nan", "inf", "-inf", "Infinity", "1e308", "-1e308", "1e400", "1e-320", "0", "-0", "-1", "0.5", "2"),
    *("127", "128", "180", "181", "-181", "255", "256", "300", "65536", "2147483648", "-2147483649", "4294967296"),
    *("9223372036854775808", "1" * 500, "9" * 5000, "0x10", "1_000", "1,5", "٣", "½", "²", "1e999999999", "007"),
)
TEXTS = (
    *("", " ", "\t", "null", "None", "true", "[]", "{}", "[[]]", '{"":0}', '"', "'", "`", "\0", "\x1b[2J", "é", "日本"),
    *("\U0001f300", "\u202e", "\u2028", "\x85", "\ufeff", "\r", "\n", "%s", "%n", "{0}", "{path!r}", "<b>", "&amp;"),
    *(
        "../../../etc/passwd",
        "/dev/zero",
        "C:\\x",
        "\\\\host\\share\\x",
        "//host/share/x",
        "file:///etc/passwd",
        "..",
        ";",
    ),
    *("=1+1", "#ffffff", "reference", "x" * 256, "é" * 255, "x" * 10_001, "x" * 140_000, "[" * 100_000, "(" * 900),
    *("__import__('os')", "1+1j", "2025-13-45T99:99", "9999-12-31T23:59:59", "0000-01-01", "1;2;nan", "EPSG:0"),
)
WHOLE = (0, 1, 2, 3, 7, 8, 16, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1)
_TOKEN = re.compile(r"[\w.+-]+|\s|.", re.DOTALL)
_PNG = b"\x89PNG\r\n\x1a\n"


def mutated_bytes(random: Random, data: bytes, tokens: Sequence[bytes] = (), most: int = 5) -> bytes:
    """The data with one to ``most`` changes: bits, bytes, numbers, tokens, pieces lost, doubled, moved."""
    found = bytearray(data)
    for _ in range(random.randint(1, most)):
        place, kind = random.randrange(len(found) + 1), random.randrange(8)
        if kind == 0 or not found:
            found[place:place] = random.choice(tokens) if tokens else b"\xff\0\xff\x7f"
        elif kind == 1:
            found[place % len(found)] ^= 1 << random.randrange(8)
        elif kind == 2:
            found[place % len(found)] = random.randrange(256)
        elif kind == 3:
            code = random.choice(("<H", ">H", "<I", ">I", "<d", ">d"))
            value = random.choice(WHOLE) & ((1 << 8 * struct.calcsize(code)) - 1)
            packed = struct.pack(code, float(value) if code[1] == "d" else value)
            found[place : place + len(packed)] = packed
        elif kind == 4:
            del found[place : place + random.choice((1, 4, 16, 64, 1000))]
        elif kind == 5:
            found[place:place] = found[place : place + random.choice((1, 4, 16, 64, 256))] * random.choice((1, 2, 50))
        elif kind == 6:
            del found[place:]
        elif tokens:
            token = random.choice(tokens)
            found[place : place + len(token)] = token
    return bytes(found)


def mutated_text(random: Random, text: str, words: Sequence[str] = ()) -> bytes:
    """A text (CSV, JSON, XML, a route) with words replaced, lost, doubled and exchanged; now and then its bytes."""
    parts = _TOKEN.findall(text)
    for _ in range(random.choice((1, 1, 1, 2, 4))):
        place, kind = random.randrange(len(parts) or 1), random.randrange(6)
        if not parts:
            parts = [word(random, words)]
        elif kind <= 2:
            parts[place] = word(random, words)
        elif kind == 3:
            parts[place : place + random.choice((1, 1, 8))] = []
        elif kind == 4:
            parts[place:place] = parts[place : place + random.choice((1, 10, 40))] * random.choice((1, 1, 30))
        else:
            other = random.randrange(len(parts))
            parts[place], parts[other] = parts[other], parts[place]
    encoding = random.choice(("utf-8",) * 16 + ("utf-8-sig", "latin-1", "utf-16"))
    data = "".join(parts).encode(encoding, "replace")
    return mutated_bytes(random, data, most=2) if random.randrange(5) == 0 else data


def word(random: Random, more: Sequence[str] = ()) -> str:
    """A text that hurts."""
    return random.choice((random.choice(NUMBERS), random.choice(TEXTS), random.choice(more or NUMBERS)))


def chunk(name: bytes, data: bytes) -> bytes:
    """A chunk of a PNG with its right checksum."""
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def mutated_png(random: Random, data: bytes) -> bytes:
    """Chunks changed, with right checksums: what gets past the first look."""
    parts, place = [], len(_PNG)
    while place + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        parts.append([name, data[place + 8 : place + 8 + length]])
        place += 12 + length
    part = random.choice(parts)
    if random.randrange(5) == 0:
        parts.remove(part)
    elif random.randrange(5) == 0:
        parts.insert(1, [random.choice((b"tRNS", b"PLTE", b"iCCP", b"tEXt", b"eXIf", b"zTXt")), part[1]])
    elif part[0] == b"IHDR":
        width, height = (random.choice((0, 1, 30, 24, 20_000, 65536, 2**31 - 1)) for _ in range(2))
        part[1] = struct.pack(">IIBBBBB", width, height, random.choice((1, 8, 16, 3)), random.randrange(7), 0, 0, 0)
    else:
        part[1] = mutated_bytes(random, part[1])
    return _PNG + b"".join(chunk(*part) for part in parts)


def mutated_tiff(random: Random, data: bytes) -> bytes:
    """An entry of the first directory changed: tag, kind, count or value."""
    found, order = bytearray(data), "<" if data[:2] == b"II" else ">"
    (first,) = struct.unpack_from(order + "I", found, 4)
    (count,) = struct.unpack_from(order + "H", found, first)
    place = first + 2 + 12 * random.randrange(count)
    entry = list(struct.unpack_from(order + "HHII", found, place))
    which = random.randrange(4)
    entry[which] = random.choice(WHOLE[:14]) if which < 2 else random.choice((*WHOLE, first, len(found)))
    struct.pack_into(order + "HHII", found, place, *entry)
    return bytes(found)


def mutated_zip(random: Random, data: bytes) -> bytes:
    """A member changed, lost or exchanged, with right checksums of the zip; or a zip that says so of itself."""
    if random.randrange(6) == 0:
        return mutated_bytes(random, data, [b"PK\x05\x06", b"PK\x01\x02", b"PK\x03\x04", b"\xff" * 4])
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    name, kind = random.choice(sorted(members)), random.randrange(6)
    if kind == 0:
        del members[name]
    elif kind == 1:
        members[name] = members[random.choice(sorted(members))]
    elif kind == 2:
        members[random.choice(("../out.npy", "/out.npy", "extra.npy"))] = b"x"
    else:
        tokens = [b"\xff" * 8, b"\0" * 8, b"(1, 1)", b"(-1,)", b"(4294967296, 4294967296)", b"|O", b"<f8", b"1e400"]
        members[name] = mutated_bytes(random, members[name], tokens)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return file.getvalue()


def mutated_database(random: Random, data: bytes, tables: Sequence[str]) -> bytes:
    """Cells of a GeoPackage changed in SQL as its maker could, or its schema, without its checksums."""
    if random.randrange(7) == 0:
        return mutated_bytes(random, data)
    with contextlib.closing(sqlite3.connect(":memory:")) as connection:
        connection.deserialize(data)
        for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
            connection.execute(f'DROP TRIGGER "{name}"')
        connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
        for _ in range(random.randint(1, 3)):
            with contextlib.suppress(sqlite3.Error, OverflowError):
                _change(random, connection, random.choice(tables))
        connection.commit()
        return connection.serialize()


def _change(random: Random, connection: sqlite3.Connection, table: str) -> None:
    column = random.choice([row[1] for row in connection.execute(f'PRAGMA table_info("{table}")')])
    if random.randrange(8) == 0:
        statement = random.choice(('DELETE FROM "{0}"', 'DROP TABLE "{0}"', 'UPDATE "{0}" SET rowid = -rowid'))
        connection.execute(statement.format(table))
        return
    row, now = random.choice(connection.execute(f'SELECT rowid, "{column}" FROM "{table}"').fetchmany(50))
    new = random.choice((None, b"", random.choice(WHOLE), float("inf"), 1e308, -1e308, word(random)))
    if isinstance(now, bytes) and random.randrange(3):
        new = mutated_bytes(random, now, [b"\xff\xff\xff\x7f", b"\0\0\xc0\x7f", b"GP\0\x01"])
    elif isinstance(now, str) and random.randrange(3):
        new = mutated_text(random, now).decode("utf-8", "replace")
    connection.execute(f'UPDATE "{table}" SET "{column}" = ? WHERE rowid = ?', (new, row))
