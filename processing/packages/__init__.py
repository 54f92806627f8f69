"""Python packages that QGIS does not bring: which, what for, and how to get them."""
