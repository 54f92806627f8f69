"""Files by GDAL and SQLite alone: label maps, images, the reference database's GeoPackage."""

from ..core.sentences import add
from .sentences import SENTENCES

add(SENTENCES)
