"""What SemRef puts into QGIS's window; it starts the algorithms by id and reads no files."""
