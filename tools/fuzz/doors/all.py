"""The table of doors."""

from __future__ import annotations

from . import databases, flights, images, in_qgis, models, on_board, tables

DOORS = (*databases.DOORS, *on_board.DOORS, *tables.DOORS, *flights.DOORS, *images.DOORS, *models.DOORS, *in_qgis.DOORS)
