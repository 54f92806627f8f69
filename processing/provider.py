"""The Processing provider."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsProcessingModelAlgorithm, QgsProcessingProvider, QgsProcessingRegistry
from qgis.PyQt.QtGui import QIcon

from .base import ICON_PATH, REFERENCE_DATABASE
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
from .translation import tr
from .update_database import UpdateDatabase
from .version import algorithm_help_url

MODELS = Path(__file__).resolve().parent.parent / "models"
"""Ready-made models (.model3) that are offered beside the algorithms."""

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
)


class ShippedModel(QgsProcessingModelAlgorithm):
    """A model file that stands beside the algorithms, in their group and in the user's language."""

    def displayName(self):
        return tr("Annotation to reference database")

    def group(self):
        return tr("Reference database")

    def groupId(self):
        return REFERENCE_DATABASE

    def helpUrl(self):
        return algorithm_help_url(self.name())

    def icon(self):
        return QIcon(str(ICON_PATH))

    def svgIconPath(self):
        return str(ICON_PATH)


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
            self._add_models()

    def _add_models(self) -> None:
        for path in sorted(MODELS.glob("*.model3")):
            model = ShippedModel()
            if model.fromFile(str(path)):
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
