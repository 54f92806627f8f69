"""Files by GDAL and SQLite alone: label maps, images, the reference database's GeoPackage."""
