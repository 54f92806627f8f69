"""How a CRS is written down, by GDAL and PROJ alone, in the words that QGIS has for it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from osgeo import osr

from .gdal_errors import gdal_failures

_Found = TypeVar("_Found")

_FORMAT = ["FORMAT=WKT2_2019"]

_AXES = ["IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES"]
"""Which axis a file gives first says nothing about the CRS."""

_SURE = 70
"""Percent from which PROJ's guess of which CRS is meant is looked at; QGIS draws the line there, too."""


def crs_wkt(srs: osr.SpatialReference) -> str:
    """WKT of a CRS: what PROJ's catalogue says of it where it is one of those, else what the file says.

    A file may word the same CRS in an older way, such as without the members of a datum ensemble, or without its code.
    QGIS looks it up, too, so that both write the same.
    """
    told = srs.ExportToWkt(_FORMAT)
    # One that brings its own way to WGS 84 is no CRS of the catalogue.
    names = [] if told.startswith("BOUNDCRS") else _afresh(_names, told)
    return _afresh(_catalogued, told, names)


def _afresh(work: Callable[..., _Found], *arguments: object) -> _Found:
    """In a thread of its own: PROJ keeps what it made of a code for as long as the thread lasts.

    Once a GeoTIFF was opened, or a CRS was guessed, there are datums without ensembles among that.
    """
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(work, *arguments).result()


def _names(told: str) -> list[str]:
    """Authority and code that a CRS calls itself, or that PROJ takes it for, the likeliest first."""
    with gdal_failures():
        srs = osr.SpatialReference(told)
        if srs.GetAuthorityCode(None):
            return [_name(srs)]
        return [_name(found) for found, confidence in srs.FindMatches() or () if confidence >= _SURE]
    return []


def _name(srs: osr.SpatialReference) -> str:
    return f"{srs.GetAuthorityName(None)}:{srs.GetAuthorityCode(None)}"


def _catalogued(told: str, names: Sequence[str]) -> str:
    """WKT of the first of the names that is the same CRS; of what was told where none is."""
    # Looked up before anything else is made of it.
    found = [one for one in map(_from_catalogue, names) if one is not None]
    srs = osr.SpatialReference(told)
    return next((one for one in found if one.IsSame(srs, _AXES)), srs).ExportToWkt(_FORMAT)


def _from_catalogue(name: str) -> osr.SpatialReference | None:
    found = osr.SpatialReference()
    with gdal_failures() as failures:
        if found.SetFromUserInput(name) != 0:
            return None
    return None if failures else found
