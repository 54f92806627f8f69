"""A local server of map tiles: squares of three colors in EPSG:3857, with known classes everywhere."""

from __future__ import annotations

import contextlib
import threading
from contextlib import contextmanager

import cv2
import numpy as np
from listening import Handler, serving
from made_models import painted

SQUARE = 150.0
"""Edge of a square, units of EPSG:3857."""

_WORLD = 2 * np.pi * 6378137.0
_TILE = 256


def labels_at(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return class 1, 2 or 3 at places of EPSG:3857."""
    return ((np.floor(x / SQUARE) + 2 * np.floor(y / SQUARE)) % 3 + 1).astype(int)


def tile_png(zoom: int, column: int, row: int, ground=labels_at) -> bytes:
    size = _WORLD / 2**zoom / _TILE
    steps = (np.arange(_TILE) + 0.5) * size
    x = column * size * _TILE - _WORLD / 2 + steps
    y = _WORLD / 2 - row * size * _TILE - steps
    pixels = painted(ground(*np.meshgrid(x, y)))
    return cv2.imencode(".png", pixels[:, :, ::-1])[1].tobytes()


@contextmanager
def tile_server(status: int = 200, delay_s: float = 0, ground=labels_at, redirect: str = "", sent: list | None = None):
    """Yield the URI of an XYZ layer.

    status: other than 200 answers every tile with it; delay_s: before each; ground: classes at (x, y) of EPSG:3857;
    redirect: an address for each tile, {path} being its own; sent: takes the sizes of the pieces of
    tiles that never end.
    """
    stop = threading.Event()

    class Tiles(Handler):
        def do_GET(self):
            stop.wait(delay_s)
            if redirect:
                self.send_response(302)
                self.send_header("Location", redirect.format(path=self.path))
                self.end_headers()
                return
            zoom, column, row = (int(part) for part in self.path.split(".")[0].strip("/").split("/"))
            self.send_response(status)
            self.send_header("Content-Type", "image/png")
            self.end_headers()
            if sent is not None:
                self.send_without_end()
            elif status == 200:
                self.wfile.write(tile_png(zoom, column, row, ground))

        def send_without_end(self):
            with contextlib.suppress(OSError):
                while not stop.is_set():
                    self.wfile.write(bytes(1 << 20))
                    sent.append(1 << 20)

    with serving(Tiles) as server:
        try:
            yield f"type=xyz&url={server.url}/{{z}}/{{x}}/{{y}}.png&zmin=0&zmax=18"
        finally:
            stop.set()
