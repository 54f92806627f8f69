"""SemRef in QGIS's window. It starts algorithms by id and computes nothing itself."""
