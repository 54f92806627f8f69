"""Web servers on loopback; one records requests, because untrusted files must not cause any."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from itertools import count

_NUMBERS = count()
"""GDAL caches missing files of a host, so each test needs new names."""


class Handler(BaseHTTPRequestHandler):
    """Handler of requests that logs nothing."""

    def log_message(self, *arguments):
        pass


@contextmanager
def serving(handler: type[Handler]) -> Iterator[ThreadingHTTPServer]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    server.url = f"http://127.0.0.1:{server.server_port}"
    threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
    try:
        yield server
    finally:
        server.shutdown()
        server.server_close()


@contextmanager
def listening() -> Iterator[ThreadingHTTPServer]:
    """Return a server without files: ``asked`` has the paths, ``name()`` is GDAL's name of a raster on it."""

    class Missing(Handler):
        def do_GET(self):
            server.asked.append(self.path)
            self.send_error(404)

        do_HEAD = do_GET

    with serving(Missing) as server:
        server.asked = []
        server.name = lambda: f"/vsicurl/{server.url}/{next(_NUMBERS)}.tif"
        yield server
