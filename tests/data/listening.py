"""A web server on loopback without files that records requests: untrusted files must not cause requests."""

import http.server
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count

_NUMBERS = count()
"""GDAL caches missing files of a host, so each test needs new names."""


@contextmanager
def listening() -> Iterator[http.server.ThreadingHTTPServer]:
    """Return a server: ``asked`` has the paths, ``url`` is its address, ``name()`` is GDAL's name of a raster on it."""

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            server.asked.append(self.path)
            self.send_error(404)

        do_HEAD = do_GET

        def log_message(self, *arguments):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.asked = []
    server.url = f"http://127.0.0.1:{server.server_port}"
    server.name = lambda: f"/vsicurl/{server.url}/{next(_NUMBERS)}.tif"
    threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
    try:
        yield server
    finally:
        server.shutdown()
        server.server_close()
