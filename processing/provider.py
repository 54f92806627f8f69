"""The Processing provider."""

from __future__ import annotations

from qgis.core import QgsApplication, QgsProcessingProvider, QgsProcessingRegistry

from .algorithms.add_model import AddModel
from .algorithms.assess_database import AssessDatabase
from .algorithms.assess_route import AssessRoute
from .algorithms.build_database import BuildDatabase
from .algorithms.check_annotation import CheckAnnotation
from .algorithms.classify_openstreetmap import ClassifyOpenStreetMap
from .algorithms.compare_labels import CompareLabels
from .algorithms.decode_color_labels import DecodeColorLabels
from .algorithms.describe_image import DescribeImage
from .algorithms.evaluate_localization import EvaluateLocalization
from .algorithms.export_onboard import ExportOnboard
from .algorithms.export_training_tiles import ExportTrainingTiles
from .algorithms.georeference_images import GeoreferenceImages
from .algorithms.localize_flight import LocalizeFlight
from .algorithms.localize_images import LocalizeImages
from .algorithms.make_class_table import MakeClassTable
from .algorithms.rasterize_annotation import RasterizeAnnotation
from .algorithms.repair_annotation import RepairAnnotation
from .algorithms.segment_image import SegmentImage
from .algorithms.set_up_area import SetUpArea
from .algorithms.train_model import TrainModel
from .algorithms.update_database import UpdateDatabase
from .base.algorithm import WithIcon
from .base.destinations import RASTER_SUFFIXES
from .base.shipped_models import shipped_models

ALGORITHMS = (
    ClassifyOpenStreetMap,
    CheckAnnotation,
    RepairAnnotation,
    RasterizeAnnotation,
    DecodeColorLabels,
    CompareLabels,
    ExportTrainingTiles,
    TrainModel,
    AddModel,
    SegmentImage,
    BuildDatabase,
    UpdateDatabase,
    ExportOnboard,
    DescribeImage,
    SetUpArea,
    LocalizeImages,
    LocalizeFlight,
    GeoreferenceImages,
    EvaluateLocalization,
    AssessDatabase,
    AssessRoute,
    MakeClassTable,
)


class SemRefProvider(WithIcon, QgsProcessingProvider):
    """Id ``semref``; the ids and keys of its algorithms are public."""

    def id(self) -> str:
        return "semref"

    def name(self) -> str:
        return "SemRef"

    def loadAlgorithms(self) -> None:
        for algorithm in ALGORITHMS:
            self.addAlgorithm(algorithm())
        # A model can be read only after its algorithms are registered, so not the first time.
        if QgsApplication.processingRegistry().providerById(self.id()) is not None:
            for model in shipped_models():
                self.addAlgorithm(model)

    def defaultVectorFileExtension(self, has_geometry: bool = True) -> str:
        return "gpkg"

    def defaultRasterFileExtension(self) -> str:
        return "tif"

    def supportedOutputRasterLayerExtensions(self) -> list[str]:
        return [suffix[1:] for suffix in RASTER_SUFFIXES]


def register_provider(registry: QgsProcessingRegistry) -> QgsProcessingProvider:
    """Return a registered SemRefProvider with its models; the caller keeps it and removes it from the registry.

    Returns an already registered provider: QGIS crashes if one id is registered twice.
    """
    registered = registry.providerById("semref")
    if registered is not None:
        return registered
    provider = SemRefProvider()
    registry.addProvider(provider)
    # Again, now with the models; the toolbox is updated.
    provider.refreshAlgorithms()
    return provider
