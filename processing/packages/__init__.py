"""Python packages that QGIS does not contain, and their installation."""
