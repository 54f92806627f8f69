"""SemRef: semantic reference databases for positions without satellite navigation."""


def classFactory(iface):
    """Return the plugin. QGIS calls this; ``iface`` is None in qgis_process."""
    from .plugin import SemRefPlugin

    return SemRefPlugin(iface)
