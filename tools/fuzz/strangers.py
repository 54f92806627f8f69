"""What strangers plant: files beside a raster, names of files inside a file, logs that are slow to read."""

from __future__ import annotations

import os
import struct
from pathlib import Path
from random import Random

import numpy as np

from .contract import Placed, World, require
from .doors import Door, Tools
from .mutations import mutated_bytes

EDGE = 64
SUFFIXES = (".aux.xml", ".ovr", ".msk", ".ovr.aux.xml", ".msk.ovr", ".aux", ".AUX.XML", ".OVR")
METADATA = (
    '<PAMDataset><Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">{name}</MDI></Metadata>'
    '<PAMRasterBand band="1"><Metadata><MDI key="STATISTICS_MAXIMUM">4</MDI></Metadata></PAMRasterBand></PAMDataset>'
)
DESCRIPTION = (
    '<VRTDataset rasterXSize="32" rasterYSize="32"><VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
    '<SourceFilename relativeToVRT="0">{name}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>'
    "</VRTRasterBand></VRTDataset>"
)
MOST_LOG_BYTES = 3_000_000
_ULOG = b"ULog\x01\x12\x35\x01" + bytes(8)

Planted = list[tuple[str, bytes]]
"""(suffix, content) of each file beside the raster."""


def side_cars(world: World) -> Tools:
    from osgeo import gdal

    from semref.storage.rasters import open_raster, require_own_pixels

    # The host never answers: what asks it is found soon. This process tries nothing else.
    gdal.SetConfigOption("GDAL_HTTP_TIMEOUT", "1")
    raster = str(world.folder / "labels.tif")
    memory = gdal.GetDriverByName("MEM").Create("", EDGE, EDGE, 1)
    memory.GetRasterBand(1).WriteArray(np.random.default_rng(1).integers(0, 5, (EDGE, EDGE), np.uint8))
    gdal.GetDriverByName("GTiff").CreateCopy(raster, memory)
    whole = Path(raster).read_bytes()

    def attempt(planted: Planted) -> None:
        written = [f"{raster}{suffix}" for suffix, _ in planted]
        try:
            for path, (_, content) in zip(written, planted):
                Path(path).write_bytes(content)
            require_own_pixels(raster)
            dataset = open_raster(raster)
            band = dataset.GetRasterBand(1)
            band.GetOverviewCount()
            band.GetMaskFlags()
            # Half the size: from overviews, where there are any.
            band.ReadAsArray(0, 0, EDGE, EDGE, EDGE // 2, EDGE // 2)
        finally:
            for path in set(written):
                os.unlink(path)

    def content(random: Random) -> bytes:
        # GDAL remembers what a host lacks, so each input has an address of its own.
        remote = f"/vsicurl/{world.url}{random.getrandbits(60)}.tif"
        name = random.choice([remote, str(world.secret), r"\\127.0.0.1\share\a.tif", ":::BASE:::labels.tif.ovr"])
        text = random.choice([METADATA, DESCRIPTION]).format(name=name).encode()
        if random.random() < 0.2:
            return whole if random.random() < 0.5 else mutated_bytes(random, whole, [text], 2)
        return text if random.random() < 0.7 else mutated_bytes(random, text, [b"<MDI", b"OVERVIEWS"], 3)

    def make(random: Random) -> Planted:
        return [(random.choice(SUFFIXES), content(random)) for _ in range(random.randint(1, 3))]

    return make, attempt


def names(world: World) -> Tools:
    from semref.core.named_files import named_file

    chosen = world.folder / "chosen"
    (chosen / "inner").mkdir(parents=True)
    (chosen / "inner" / "a.tif").write_bytes(b"a")
    os.symlink(world.secret, chosen / "link.asc")
    os.symlink(world.secret.parent, chosen / "up")
    parts = (
        *(
            "..",
            "/",
            "\\",
            "//",
            "\\\\",
            "inner",
            "a.tif",
            "link.asc",
            "up",
            "secret.asc",
            ".",
            "",
            "\0",
            "~",
            "C:",
            "%2e",
        ),
        *(
            "/vsicurl/",
            "/vsizip/",
            "http://",
            "file:///",
            "GPKG:",
            str(chosen),
            str(world.secret),
            world.url,
            "é",
            "x" * 300,
        ),
    )

    def make(random: Random) -> str:
        joint = random.choice(["", "/", "\\"])
        return joint.join(random.choice(parts) for _ in range(random.randint(1, 6)))

    def attempt(name: str) -> None:
        found = named_file(name, [str(chosen)])
        inside = os.path.join(os.path.realpath(chosen), "")
        require(not found or (os.path.realpath(found) + os.sep).startswith(inside), "a name leads out of the folder")

    return make, attempt


def slow_logs(world: World) -> Tools:
    from semref.core.flight.logs.files import read_log

    placed = Placed(world.folder, "flight.log")

    def fields(kind: bytes) -> bytes:
        return b"vehicle_attitude:" + b"".join(b"%s a%d;" % (kind, n) for n in range(300))

    starts = (
        b"00:00:00,000 --> ",
        b"\xa3\x95\x80",
        _ULOG,
        _ULOG + _message("F", fields(b"float[0]")) + _message("A", b"\0\0\0vehicle_attitude"),
        _ULOG + _message("F", fields(b"double[9999]")) * 100,
        bytes(8) + b"\xfe" + bytes(8) + bytes(8) + b"\xfe" + bytes(8),
        b"EPSG:4326\n",
    )
    pieces = (
        *(b"\0", b" ", b"\n", b"gb_yaw", b"gb_pitch:", b"-->", b"00:00:00,000", b"rel_alt (", b", H ", b"1", b"."),
        *(b"\xa3\x95", b"\xa3\x95\x80", b"\xfe\xff\0\0\0\x1e\0", b"\xfd\x09\0\0\0\0\0\x1e\0\0", b"\xff"),
        *(b"\x03\0D\0\0x", b"a 1 2 3 4 5\n"),
    )

    def make(random: Random) -> bytes:
        unit = b"".join(random.choice(pieces) * random.choice([1, 3, 1300]) for _ in range(random.randint(1, 4)))
        return (random.choice(starts) + unit * (MOST_LOG_BYTES // len(unit)))[:MOST_LOG_BYTES]

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            found = read_log(path)
        require(len(found.times_s) <= 16 * 200_000, "more entries than are kept")

    return make, attempt


def _message(kind: str, content: bytes) -> bytes:
    """A message of a PX4 log."""
    return struct.pack("<HB", len(content), ord(kind)) + content


DOORS = (
    Door("side_cars", "files beside a raster: `.aux.xml`, `.ovr`, `.msk`", side_cars),
    Door("names", "names of files inside a file", names),
    Door("slow_logs", "flight logs of 3 MB that repeat a piece", slow_logs, 0.1),
)
