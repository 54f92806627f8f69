"""The mutator: change a valid file of any format, with correct checksums where the format has them."""

import contextlib
import io
import re
import sqlite3
import struct
import zipfile
import zlib
from pathlib import Path
from random import Random

import numpy as np

WORDS = Path(__file__).with_name("samples").joinpath("words.txt").read_text(encoding="utf-8").split("\n")
WORDS += [*"\0\u202e\ufeff \t\r\n\u2028\x85", "\x1b[2J", "1" * 500, "9" * 5000, "[" * 100_000, "(" * 900, "x" * 140_000]
"""Numbers and texts at the limits of what readers expect."""

NUMBERS = (0, 1, 2, 3, 7, 8, 16, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1, 2**31, 2**32 - 1)
LONG_BYTES = 3_000_000
_TOKEN = re.compile(r"[\w.+-]+|\s|.", re.DOTALL)
_PNG = b"\x89PNG\r\n\x1a\n"


def mutated(random: Random, data: bytes) -> bytes:
    """Return a changed file: parts of its format, its words, or its bytes; rarely a long one."""
    kinds = {
        _PNG: changed_png,
        b"II*\0": changed_tiff,
        b"PK\x03\x04": changed_zip,
        b"SQLite format 3": changed_database,
    }
    change = next((change for magic, change in kinds.items() if data.startswith(magic)), changed_bytes)
    if b"\0" not in data:
        change = changed_text
    roll = random.randrange(40)
    return (lengthened if roll == 0 else changed_bytes if roll < 8 else change)(random, data)


def lengthened(random: Random, data: bytes) -> bytes:
    """Return a file of 3 MB that repeats a piece of the data after its first bytes."""
    place = random.randrange(len(data))
    piece = data[place : place + random.choice((1, 8, 100))]
    return (data[:place] + piece * (LONG_BYTES // len(piece)))[:LONG_BYTES]


def changed_bytes(random: Random, data: bytes) -> bytes:
    """Return the data with one to five changes of bits, bytes, numbers and pieces."""
    found = bytearray(data)
    for _ in range(random.randint(1, 5)):
        place, kind = random.randrange(len(found) + 1), random.randrange(7)
        if kind == 0 or not found:
            found[place:place] = random.choice(WORDS).encode()[:1000]
        elif kind == 1:
            found[place % len(found)] ^= 1 << random.randrange(8)
        elif kind == 2:
            found[place % len(found)] = random.randrange(256)
        elif kind == 3:
            code = random.choice(("<H", ">H", "<I", ">I", "<d", ">d"))
            value = random.choice(NUMBERS) & ((1 << 8 * struct.calcsize(code)) - 1)
            packed = struct.pack(code, float(value) if code[1] == "d" else value)
            found[place : place + len(packed)] = packed
        elif kind == 4:
            del found[place : place + random.choice((1, 4, 16, 64, 1000))]
        elif kind == 5:
            found[place:place] = found[place : place + random.choice((1, 16, 256))] * random.choice((1, 2, 50))
        else:
            del found[place:]
    return bytes(found)


def changed_text(random: Random, data: bytes) -> bytes:
    """Return a text (CSV, JSON, XML) with words replaced, removed, repeated, exchanged or in another encoding."""
    parts = _TOKEN.findall(data.decode("utf-8", "replace")) or [""]
    for _ in range(random.choice((1, 1, 1, 2, 4))):
        place, kind = random.randrange(len(parts)), random.randrange(6)
        if kind <= 1:
            parts[place] = random.choice(WORDS)
        elif kind == 2:
            parts[place] = random.choice(parts)
        elif kind == 3:
            parts[place : place + random.choice((1, 1, 8))] = [""]
        elif kind == 4:
            parts[place:place] = parts[place : place + random.choice((1, 10, 40))] * random.choice((1, 1, 30))
        else:
            other = random.randrange(len(parts))
            parts[place], parts[other] = parts[other], parts[place]
    return "".join(parts).encode(random.choice(("utf-8",) * 16 + ("utf-8-sig", "latin-1", "utf-16")), "replace")


def changed_png(random: Random, data: bytes) -> bytes:
    """Return a PNG with a changed chunk and its correct checksum."""
    chunks, place = [], len(_PNG)
    while place + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        chunks.append([name, data[place + 8 : place + 8 + length]])
        place += 12 + length
    chunk, kind = random.choice(chunks), random.randrange(5)
    if kind == 0:
        chunks.remove(chunk)
    elif kind == 1:
        chunks.insert(1, [random.choice((b"tRNS", b"PLTE", b"iCCP", b"tEXt", b"eXIf", b"zTXt")), chunk[1]])
    elif chunk[0] == b"IHDR":
        size = [random.choice((0, 1, 30, 24, 20_000, 65536, 2**31 - 1)) for _ in range(2)]
        chunk[1] = struct.pack(">IIBBBBB", *size, random.choice((1, 8, 16, 3)), random.randrange(7), 0, 0, 0)
    else:
        chunk[1] = changed_bytes(random, chunk[1])
    parts = (name + content for name, content in chunks)
    return _PNG + b"".join(struct.pack(">I", len(p) - 4) + p + struct.pack(">I", zlib.crc32(p)) for p in parts)


def changed_tiff(random: Random, data: bytes) -> bytes:
    """Return a TIFF with another tag, type, count or value in an entry of its first directory."""
    found = bytearray(data)
    (first,) = struct.unpack_from("<I", found, 4)
    (count,) = struct.unpack_from("<H", found, first)
    place, which = first + 2 + 12 * random.randrange(count), random.randrange(4)
    entry = list(struct.unpack_from("<HHII", found, place))
    entry[which] = random.choice(NUMBERS[:14]) if which < 2 else random.choice((*NUMBERS, first, len(found)))
    struct.pack_into("<HHII", found, place, *entry)
    return bytes(found)


def changed_zip(random: Random, data: bytes) -> bytes:
    """Return a zip with a member changed, removed, added or exchanged; texts stored as arrays stay arrays."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    name, kind = random.choice(sorted(members)), random.randrange(6)
    if kind == 0:
        del members[name]
    elif kind == 1:
        members[name] = members[random.choice(sorted(members))]
    elif kind == 2:
        members[random.choice(("../out.npy", "/out.npy", "extra.npy"))] = b"x"
    elif kind == 3 and "header.npy" in members:
        members["header.npy"] = npy(changed_text(random, np.load(io.BytesIO(members["header.npy"])).tobytes()))
    else:
        members[name] = changed_bytes(random, members[name])
    return zip_of(members)


def npy(content: bytes) -> bytes:
    file = io.BytesIO()
    np.save(file, np.frombuffer(content, np.uint8))
    return file.getvalue()


def zip_of(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return file.getvalue()


def changed_database(random: Random, data: bytes) -> bytes:
    """Return an SQLite file with changed cells or tables, without triggers and without the checksums of SemRef."""
    with contextlib.closing(sqlite3.connect(":memory:")) as connection:
        connection.deserialize(data)
        master = connection.execute("SELECT type, name FROM sqlite_master WHERE name NOT LIKE '%rtree%'").fetchall()
        for name in [name for kind, name in master if kind == "trigger"]:
            connection.execute(f'DROP TRIGGER "{name}"')
        connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
        for _ in range(random.randint(1, 3)):
            with contextlib.suppress(sqlite3.Error, OverflowError, IndexError):
                _change_table(random, connection, random.choice([name for kind, name in master if kind == "table"]))
        connection.commit()
        return connection.serialize()


def _change_table(random: Random, connection: sqlite3.Connection, table: str) -> None:
    if random.randrange(8) == 0:
        statement = random.choice(('DELETE FROM "{0}"', 'DROP TABLE "{0}"', 'UPDATE "{0}" SET rowid = -rowid'))
        connection.execute(statement.format(table))
        return
    column = random.choice([row[1] for row in connection.execute(f'PRAGMA table_info("{table}")')])
    row, now = random.choice(connection.execute(f'SELECT rowid, "{column}" FROM "{table}"').fetchmany(50))
    new = random.choice((None, b"", random.choice(NUMBERS), float("inf"), 1e308, -1e308, random.choice(WORDS)))
    if isinstance(now, bytes) and random.randrange(3):
        new = changed_bytes(random, now)
    elif isinstance(now, str) and random.randrange(3):
        new = changed_text(random, now.encode()).decode("utf-8", "replace")
    connection.execute(f'UPDATE "{table}" SET "{column}" = ? WHERE rowid = ?', (new, row))
