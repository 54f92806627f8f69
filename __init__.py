"""SemRef: semantic reference databases for positions without satellite navigation."""


def classFactory(iface):
    """QGIS's entry point; ``iface`` is None under qgis_process."""
    from .plugin import SemRefPlugin

    return SemRefPlugin(iface)
