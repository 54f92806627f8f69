"""The Processing provider."""

from __future__ import annotations

from qgis.core import QgsApplication, QgsProcessingProvider, QgsProcessingRegistry
from qgis.PyQt.QtGui import QIcon

from .assess_database import AssessDatabase
from .assess_route import AssessRoute
from .base import ICON_PATH
from .build_database import BuildDatabase
from .check_annotation import CheckAnnotation
from .compare_labels import CompareLabels
from .decode_color_labels import DecodeColorLabels
from .describe_image import DescribeImage
from .evaluate_localization import EvaluateLocalization
from .export_onboard import ExportOnboard
from .export_training_tiles import ExportTrainingTiles
from .localize_images import LocalizeImages
from .make_sample import MakeSample
from .rasterize_annotation import RasterizeAnnotation
from .repair_annotation import RepairAnnotation
from .segment_image import SegmentImage
from .shipped_models import shipped_models
from .update_database import UpdateDatabase

ALGORITHMS = (
    CheckAnnotation,
    RepairAnnotation,
    RasterizeAnnotation,
    DecodeColorLabels,
    CompareLabels,
    ExportTrainingTiles,
    SegmentImage,
    MakeSample,
    BuildDatabase,
    UpdateDatabase,
    ExportOnboard,
    DescribeImage,
    LocalizeImages,
    EvaluateLocalization,
    AssessDatabase,
    AssessRoute,
)


class SemRefProvider(QgsProcessingProvider):
    """Id ``semref``; the ids and keys of its algorithms are public."""

    def id(self):
        return "semref"

    def name(self):
        return "SemRef"

    def icon(self):
        return QIcon(str(ICON_PATH))

    def svgIconPath(self):
        return str(ICON_PATH)

    def loadAlgorithms(self):
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
        # A model can be read only when the algorithms in it are registered: not the first time.
        if QgsApplication.processingRegistry().providerById(self.id()) is not None:
            for model in shipped_models():
                self.addAlgorithm(model)

    def defaultVectorFileExtension(self, has_geometry=True):
        return "gpkg"

    def defaultRasterFileExtension(self):
        return "tif"


def register_provider(registry: QgsProcessingRegistry):
    """A registered SemRefProvider with its models; the caller keeps it and removes it from the registry.

    Returns the provider that is there already when one is: QGIS crashes when one id is registered twice.
    """
    registered = registry.providerById("semref")
    if registered is not None:
        return registered
    provider = SemRefProvider()
    registry.addProvider(provider)
    # Once more, now with the models; the toolbox hears of it.
    provider.refreshAlgorithms()
    return provider
