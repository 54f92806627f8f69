"""A reference database as one GeoPackage: its schema, and how it is written, edited and read."""
