"""Hide the packages of SemRef from Python, like a plain QGIS; this folder is first on PYTHONPATH.

What SemRef installs into a profile is found; the same packages of the system or a virtual environment are not.
"""

import sys
from importlib.machinery import PathFinder

HIDDEN = {"cv2", "shapely", "onnxruntime", "onnx", "distributed", "dask", "torch", "scipy", "PIL"}
INSTALLED = "semref_components"


class BareFinder(PathFinder):
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        if path is None and name in HIDDEN:
            path = [entry for entry in sys.path if INSTALLED in entry]
        return super().find_spec(name, path, target)


sys.meta_path[:] = [BareFinder if finder is PathFinder else finder for finder in sys.meta_path]
