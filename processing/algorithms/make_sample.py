"""semref:makesample – a made-up area to try everything on: annotation, class table, photos."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
)

from ...core.sample import DEFAULT_SEED
from ..framework.base import REFERENCE_DATABASE, SemRefAlgorithm, cancelable, follow
from ..packages.components import OPENCV, SHAPELY
from ..translation import tr

LANDSCAPE_PERCENT, PHOTO_PERCENT = 35, 80
"""Progress when the landscape is made, and when it is rendered."""


class MakeSample(SemRefAlgorithm):
    ID = "makesample"
    GROUP = REFERENCE_DATABASE
    TAGS = ("sample", "example", "demo", "test data", "tutorial", "synthetic", "simulation", "photos", "try")
    PACKAGES = (OPENCV, SHAPELY)

    OUTPUT = "OUTPUT"
    SEED = "SEED"
    PHOTO_COUNT = "PHOTO_COUNT"

    def title(self):
        return tr("Make sample area")

    def summary(self):
        return tr(
            "Makes up a piece of land of 4 × 3 km to try SemRef on: its land-cover polygons (landcover.shp), their "
            "class table (classes.csv), an orthophoto, and photos taken anywhere above it, with where they were "
            "really taken (photos.csv).\n\n"
            "The model that ships with SemRef can read these photos."
        )

    def initAlgorithm(self, config=None):
        self.offer(
            QgsProcessingParameterFolderDestination(self.OUTPUT, tr("Folder for the sample")),
            tr("A new or empty folder; one that holds files is left alone."),
        )
        self.offer(
            QgsProcessingParameterNumber(
                self.SEED, tr("Seed"), QgsProcessingParameterNumber.Integer, DEFAULT_SEED, minValue=0
            ),
            tr("The same number gives the same area; another one makes up another."),
            advanced=True,
        )
        self.addOutput(QgsProcessingOutputNumber(self.PHOTO_COUNT, tr("Number of photos")))

    def work(self, parameters, context, feedback):
        from ...core.sample.landscape import make_landscape
        from ...core.sample.pictures import PHOTO_COUNT
        from ...storage.files import folder_written_beside
        from ...storage.sample_files import PIXEL_SIZE_M, render_photo, sample_steps

        output = self.parameterAsString(parameters, self.OUTPUT, context)
        with folder_written_beside(output) as temporary:
            feedback.setProgressText(tr("Making up the landscape"))
            seed = self.parameterAsInt(parameters, self.SEED, context)
            landscape = cancelable(make_landscape, seed, feedback=feedback)
            feedback.setProgress(LANDSCAPE_PERCENT)
            feedback.setProgressText(tr("Rendering it as a photo"))
            photo_hw3 = cancelable(render_photo, landscape, PIXEL_SIZE_M, feedback=feedback)
            steps = sample_steps(Path(temporary), landscape, photo_hw3, PIXEL_SIZE_M)
            follow(steps, feedback, PHOTO_PERCENT, 100)
        feedback.pushInfo(tr("{count} photos in {folder}").format(count=PHOTO_COUNT, folder=output))
        return {self.OUTPUT: output, self.PHOTO_COUNT: PHOTO_COUNT}
