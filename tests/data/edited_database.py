"""The database of tests/data/kept, and databases as another program edits them."""

import contextlib
import gzip
import sqlite3
from pathlib import Path

KEPT = Path(__file__).parent / "kept" / "v1"


def kept_database(path: Path) -> str:
    """Write the database of format 1, which has 417 landmarks and 36 windows."""
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(gzip.decompress((KEPT / "database.gpkg.gz").read_bytes()))
    return str(path)


def edit(path, *statements: str) -> None:
    """Run the statements, at least one row each, without GDAL's triggers, which need its functions."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
            connection.execute(f'DROP TRIGGER "{name}"')
        for statement in statements:
            assert connection.execute(statement).rowcount
