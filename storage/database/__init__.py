"""Write, edit and read a reference database, which is one GeoPackage."""
