"""TIFF files with any tags: OpenCV and Pillow write neither all palettes nor opacity, nodata or georeferences."""

import struct

import numpy as np

CODES = {3: "H", 4: "I", 5: "I", 12: "d"}


def tiff(entries, order: str = "<", at: int = 8) -> bytes:
    """Return a TIFF with only a directory at an offset; entries are (tag, kind, values): bytes, numbers, pairs."""
    place = at + 2 + 12 * len(entries) + 4
    head, content = b"", b""
    for tag, kind, values in entries:
        data = values if isinstance(values, bytes) else struct.pack(f"{order}{len(values)}{CODES[kind]}", *values)
        head += struct.pack(order + "HHI", tag, kind, len(values) // (2 if kind == 5 else 1))
        head += data.ljust(4, b"\0") if len(data) <= 4 else struct.pack(order + "I", place + len(content))
        content += b"" if len(data) <= 4 else data
    magic = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", at)
    return magic.ljust(at, b"\0") + struct.pack(order + "H", len(entries)) + head + bytes(4) + content


def image_tiff(samples: np.ndarray, photometric: int, **tags) -> bytes:
    """Return a TIFF of (height, width) or (height, width, bands) uint8; tags by number, as text or 16-bit numbers."""
    height, width = samples.shape[:2]
    bands = samples.shape[2] if samples.ndim == 3 else 1
    entries = {
        256: (width,), 257: (height,), 258: (8,) * bands, 259: (1,), 262: (photometric,), 273: (100_000,),
        277: (bands,), 278: (height,), 279: (samples.size,), **{int(name[1:]): value for name, value in tags.items()},
    }  # fmt: skip
    kinds = {273: 4, 279: 4, 34853: 4}
    listed = [(tag, kinds.get(tag, 2 if isinstance(v, bytes) else 3), v) for tag, v in sorted(entries.items())]
    return tiff(listed).ljust(100_000, b"\0") + samples.tobytes()
