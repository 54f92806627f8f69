"""The only code of the plugin that reads and writes rasters, layers and GeoPackages."""
