"""Screenshots as small PNG files: a palette of the colors that are in the picture, fewer of them until it fits."""

from __future__ import annotations

import struct
import sys
import zlib
from pathlib import Path

import cv2
import numpy as np

COLOR_COUNTS = (256, 192, 128, 96, 64)
SAMPLE = 12_000
"""Pixels of the picture, and as many of its distinct colors, by which the palette is chosen: so thin lines count."""

FRAME_GRAY = 160
_ASSIGNED_AT_ONCE = 20_000


def shrink(source: Path, target: Path, largest_bytes: int) -> None:
    """Writes the picture with a thin frame and a palette; with fewer colors when it would be larger than that."""
    picture = cv2.imread(str(source), cv2.IMREAD_COLOR)
    if picture is None:
        raise ValueError(f"{source} is no picture")
    picture = framed(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB))
    for count in COLOR_COUNTS:
        palette, indices = reduce_colors(picture, count)
        content = png(indices, palette)
        if len(content) <= largest_bytes:
            break
    else:
        print(f"{target} has {len(content) / 1000:.0f} kB, more than {largest_bytes / 1000:.0f}", file=sys.stderr)
    target.write_bytes(content)


def framed(picture_hw3: np.ndarray) -> np.ndarray:
    """One gray pixel around it: without a frame a light window runs into a light page."""
    result = picture_hw3.copy()
    result[[0, -1], :] = result[:, [0, -1]] = FRAME_GRAY
    return result


def reduce_colors(picture_hw3: np.ndarray, count: int):
    """((K, 3) uint8 palette of at most ``count`` colors, (H, W) uint8 indices); exact where there are no more."""
    colors, inverse, frequency = np.unique(picture_hw3.reshape(-1, 3), axis=0, return_inverse=True, return_counts=True)
    if len(colors) > count:
        random = np.random.default_rng(0)
        by_pixel = random.choice(len(colors), SAMPLE, p=frequency / frequency.sum())
        by_color = random.choice(len(colors), SAMPLE)
        sample = colors[np.concatenate([by_pixel, by_color])].astype(np.float32)
        cv2.setRNGSeed(0)
        criteria = (cv2.TERM_CRITERIA_MAX_ITER + cv2.TERM_CRITERIA_EPS, 20, 0.5)
        _, _, centers = cv2.kmeans(sample, count, None, criteria, 1, cv2.KMEANS_RANDOM_CENTERS)
        palette = np.rint(centers).astype(np.uint8)
        inverse = nearest(colors, palette)[inverse.reshape(-1)]
    else:
        palette = colors
    return palette, inverse.reshape(picture_hw3.shape[:2]).astype(np.uint8)


def nearest(colors_n3: np.ndarray, palette_k3: np.ndarray) -> np.ndarray:
    """(N,) index of the nearest palette color of each color."""
    palette = palette_k3.astype(np.float32)
    found = np.empty(len(colors_n3), np.uint8)
    for start in range(0, len(colors_n3), _ASSIGNED_AT_ONCE):
        part = colors_n3[start : start + _ASSIGNED_AT_ONCE].astype(np.float32)
        # |c - p|² without |c|², which is the same for all of the palette.
        found[start : start + _ASSIGNED_AT_ONCE] = np.argmin((palette**2).sum(1) - 2 * part @ palette.T, axis=1)
    return found


def png(indices_hw: np.ndarray, palette_k3: np.ndarray) -> bytes:
    """A PNG file with a palette of 8 bits."""
    height, width = indices_hw.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), indices_hw], axis=1)
    parts = (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)),
        (b"PLTE", palette_k3.tobytes()),
        (b"IDAT", zlib.compress(rows.tobytes(), 9)),
        (b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, data) for kind, data in parts)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
