"""Files that are no onboard files, by their kind."""

import gzip
import io
import pickle

import numpy as np
from onboard_blobs import npy, zipped


def zip_of(files: dict) -> bytes:
    file = io.BytesIO()
    zipped(file, files)
    return file.getvalue()


FOREIGN = {
    "empty": b"",
    "text": b"value,name\n",
    "sqlite": b"SQLite format 3\0" + bytes(500),
    "zeros": bytes(5000),
    "zip end": b"PK\x05\x06" + bytes(18),
    "zip start": b"PK\x03\x04" + bytes(500),
    "png": b"\x89PNG\r\n\x1a\n" + bytes(200),
    "jpeg": b"\xff\xd8\xff\xe0" + bytes(200),
    "tiff": b"II*\x00\x08\x00\x00\x00" + bytes(200),
    "gzip": gzip.compress(b"landmarks"),
    "npy": npy(np.arange(9)),
    "pickle": pickle.dumps({"header": 1}),
    "json": b'{"format": "semref onboard", "version": 1}',
    "elf": b"\x7fELF" + bytes(300),
    "one byte": b"P",
    "zip of nothing": zip_of({}),
    "zip of text": zip_of({"readme.txt": b"hello"}),
    "zip of header alone": zip_of({"header.npy": npy(np.zeros(3, np.uint8))}),
    **{f"noise {n}": np.random.default_rng(n).bytes(3000) for n in range(5)},
}
