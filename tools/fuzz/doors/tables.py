"""Texts: class tables, camera tables, routes, the parameters of a database, key files."""

from __future__ import annotations

import json
import math
from random import Random
from typing import Any

import numpy as np

from ..contract import World, require
from ..door import Door, Placed, Tools
from ..mutations import json_bytes, mutated_bytes, mutated_json, mutated_table, one_of, word

CLASSES = (
    "value,name,color,role,draw_order,hsv_min,hsv_max\n"
    "1,building,#e31a1c,reference,,173 100 60,7 255 255\n"
    "2,bare_land,#a02db4,reference,2,139 60 60,155 255 255\n"
    "4,forest,#1f8b30,background,,,\n"
)
CAMERAS = (
    "image,roll,pitch,field_of_view,time\n"
    "a.jpg,-1.2,9.5,73.7,2025-06-30T14:05:09.250\n"
    "b.jpg,0.4,10.1,73.7,2025-06-30T14:05:11.250\n"
)
CAMERA_COLUMNS = ("image", "roll", "pitch", "focal_length_px", "focal_length_35mm", "field_of_view", "time")
FILE_ENDS = b"\n}\r\t,12"
"""Texts that end so go through a file as well; of others the reader of their text alone is tried, which is faster."""

HSV = ("180 255 255", "181 0 0", "² 1 1", "１ 1 1", "0 0", "-1 0 0", "1 2 3 4")
PLAN = {
    "fileType": "Plan",
    "mission": {
        "items": [
            {"type": "SimpleItem", "command": 22, "params": [15, 0, 0, None, 47.1, 9.5, 50]},
            {"type": "SimpleItem", "command": 16, "params": [0, 0, 0, None, 47.2, 9.6, 50]},
            {
                "type": "ComplexItem",
                "TransectStyleComplexItem": {"VisualTransectPoints": [[47.1, 9.5], [47.2, 9.5], [47.2, 9.6]]},
            },
            {"type": "ComplexItem", "landCoordinate": [47.1, 9.5, 0], "loiterCoordinate": [47.1, 9.6, 30]},
        ]
    },
}
WAYPOINTS = (
    "QGC WPL 110\n"
    "0\t1\t0\t16\t0\t0\t0\t0\t47.1\t9.5\t0\t1\n"
    "1\t0\t3\t16\t0\t0\t0\t0\t47.2\t9.5\t50\t1\n"
    "2\t0\t3\t16\t0\t0\t0\t0\t47.2\t9.6\t50\t1\n"
)
GPX = (
    '<?xml version="1.0"?><gpx version="1.1" creator="x"><rte><rtept lat="47.1" lon="9.5"/>'
    '<rtept lat="47.2" lon="9.6"/></rte><trk><trkseg><trkpt lat="47.1" lon="9.5"/><trkpt lat="47.3" lon="9.5"/>'
    "</trkseg></trk></gpx>"
)
KML = (
    '<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><LineString><coordinates>'
    "9.5,47.1,0 9.6,47.2,0 9.6,47.3,0</coordinates></LineString></Placemark><Placemark><Point><coordinates>9,47"
    "</coordinates></Point></Placemark></Document></kml>"
)


def class_tables(world: World) -> Tools:
    from semref.core.labels.class_table import class_table_from_csv
    from semref.storage.text_tables import read_class_table

    placed = Placed(world.folder, "classes.csv")

    def attempt(data: bytes) -> None:
        table = by_file(data) if data[-1:] in FILE_ENDS else class_table_from_csv(data.decode("utf-8", "replace"))
        require(all(0 <= c.value <= 255 and 0 < len(c.name) <= 255 for c in table), "a class that can't be")
        again = class_table_from_csv(table.to_csv()) if len(table) else table
        require(again == table, "what was read is written as something else")
        table.describe()

    def by_file(data: bytes) -> Any:
        with placed(data) as path:
            return read_class_table(path)

    def make(random: Random) -> bytes:
        return mutated_table(random, CLASSES, (*HSV, "value", "name", "color", "role", "draw_order", "hsv_min"))

    return make, attempt


def camera_tables(world: World) -> Tools:
    from semref.core.flight.cameras import read_cameras

    placed = Placed(world.folder, "cameras.csv")

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            cameras = read_cameras(["a.png", "/x/b.png", "c.png"], path)
        for camera in cameras:
            require(camera.time_s is None or math.isfinite(camera.time_s), "a time that is none")
            found = camera.leveling((90, 120))
            if found is not None:
                require(np.isfinite(found.homography).all(), "no numbers")
                require(all(1 <= size <= 20_000 for size in found.shape_hw), "a leveled image that can't be")

    def make(random: Random) -> bytes:
        dates = (
            "2025-13-45T99:99",
            "0000-01-01",
            "9999-12-31T23:59:59",
            "2025-06-30",
            "1970-1",
            "2025-06-30T14:05:09Z",
        )
        angles = ("90", "89.9", "-90", "45", "1e-9", "30", "179.999", "1e-300", "a.jpg", "A.JPG")
        return mutated_table(random, CAMERAS, (*CAMERA_COLUMNS, *dates, *angles))

    return make, attempt


def _routes(world: World, name: str, make: Any) -> Tools:
    from semref.storage.route_files import plan_positions, read_waypoint_file, waypoint_positions

    placed = Placed(world.folder, name)
    read_text = {"route.plan": plan_positions, "route.waypoints": waypoint_positions}.get(name)

    def attempt(data: bytes) -> None:
        if read_text is None or data[-1:] in FILE_ENDS:
            with placed(data) as path:
                lines = read_waypoint_file(path)
        else:
            lines = [read_text(data.decode("utf-8", "replace"), name)]
        for line in lines:
            require(line.ndim == 2 and line.shape[1] == 2 and line.dtype == np.float64, "no line")
            require(np.isfinite(line).all(), "a place that is none")
            require((np.abs(line) <= (180, 90)).all(), "a place off the Earth")

    return make, attempt


def plans(world: World) -> Tools:
    return _routes(world, "route.plan", lambda random: json_bytes(random, mutated_json(random, PLAN)))


def waypoint_lists(world: World) -> Tools:
    def make(random: Random) -> bytes:
        lines = [line.split("\t") for line in WAYPOINTS.splitlines()]
        for _ in range(random.choice((1, 2, 3))):
            line = random.choice(lines)
            line[random.randrange(len(line))] = word(random, ("QGC WPL 110", "16", "22", "47.1"))
        return mutated_bytes(random, "\n".join("\t".join(line) for line in lines).encode("utf-8", "replace"), most=2)

    return _routes(world, "route.waypoints", make)


def _xml(random: Random, text: str) -> bytes:
    parts = text.replace(">", ">\x01").replace('"', '"\x01').split("\x01")
    for _ in range(random.choice((1, 1, 2, 4))):
        place = random.randrange(len(parts))
        kind = random.randrange(4)
        if kind == 0:
            parts[place] = word(random) + '"'
        elif kind == 1:
            parts.insert(place, random.choice(parts))
        elif kind == 2:
            del parts[place]
        else:
            parts[place] = parts[place].replace("9", random.choice(("1e308", "NaN", "inf", "-999", "", "9")))
    data = "".join(parts).encode("utf-8", "replace")
    entity = b'<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;"><!ENTITY c SYSTEM "file:///etc/passwd">]>'
    return mutated_bytes(random, data, [entity, b"&b;", b"&c;", b"<trkpt lat='1' lon='2'/>"], 3)


def route_layers(world: World) -> Tools:
    gpx, attempt_gpx = _routes(world, "route.gpx", lambda random: _xml(random, GPX))
    kml, attempt_kml = _routes(world, "route.kml", lambda random: _xml(random, KML))

    def make(random: Random) -> Any:
        return one_of(random, lambda r: (attempt_gpx, gpx(r)), lambda r: (attempt_kml, kml(r)))

    return make, lambda made: made[0](made[1])


def build_parameters(world: World) -> Tools:
    from semref.core.database.parameters import build_parameters as read
    from semref.core.errors import DatabaseError
    from semref.core.values import read_json
    from semref.storage import sentences  # noqa: F401 -- adds them to the table

    good = {
        "crs": 'PROJCS["a metric CRS"]',
        "geotransform": [600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0],
        "map_width_px": 400,
        "map_height_px": 320,
        "pixel_size": 2.0,
        "window_size": 120.0,
        "stride": 40.0,
        "levels": [1.0, 2.0],
        "references_per_vector": 10,
        "minimum_area": 28.0,
        "overview_factor": 4,
        "map_hash": "ab" * 32,
        "class_table_hash": "cd" * 32,
        "plugin_version": "1.2.3",
        "format_version": 1,
        "block_hashes": ["0123456789abcdef"],
    }

    def attempt(text: str) -> None:
        try:
            found = read(read_json(text), "x.gpkg")
        except (KeyError, ValueError, TypeError) as error:
            # What the two readers of files catch around it.
            raise DatabaseError(
                "storage.database_damaged", path="x", reason=str(error)[:200].replace("\n", " ")
            ) from None
        numbers = (*found.geotransform, *found.levels, found.pixel_size, found.stride, *found.extent)
        require(np.isfinite(np.array(numbers, np.float64)).all(), "a number that is none")
        require(all(size > 0 for size in found.overview_frame.shape_hw), "an overview without pixels")
        json.dumps(found.levels)

    def make(random: Random) -> str:
        words = ([1e9, 1, 0, 1e9, 0, -1], [0, 1e-300, 0, 0, 0, -1e-300], {"a": 1}, "1", [1] * 300)
        return json_bytes(random, mutated_json(random, good, words)).decode("utf-8", "replace")

    return make, attempt


def keys(world: World) -> Tools:
    from semref.core.onboard.signature import is_signed_with, read_key, signature

    placed = Placed(world.folder, "fleet.key")
    files = {"header": b"x" * 40, "windows_rows": b"y" * 30}
    right = signature(files, bytes(range(32)))

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            key = read_key(path)
        # HMAC fills keys up with zeros.
        require(key == data and 16 <= len(key) <= 4096, "a key that is none")
        require(
            is_signed_with(files, right, key) == (key.rstrip(b"\0") == bytes(range(32))), "another key signs as well"
        )

    def make(random: Random) -> bytes:
        if random.random() < 0.3:
            return random.randbytes(random.choice((0, 1, 15, 16, 17, 32, 64, 4095, 4096, 4097, 70_000)))
        return mutated_bytes(random, bytes(range(32)))

    return make, attempt


DOORS = (
    Door("classes", "class tables (CSV)", class_tables, 250_000),
    Door("cameras", "camera tables: attitude, lens, time (CSV)", camera_tables, 60_000),
    Door("plans", "routes: `.plan`", plans, 100_000),
    Door("waypoints", "routes: `.waypoints`", waypoint_lists, 200_000),
    Door("route_layers", "routes: GPX, KML", route_layers, 5_000, 5000),
    Door("parameters", "parameters of a database (JSON)", build_parameters, 150_000),
    Door("keys", "key files, signatures", keys, 30_000),
)
