"""semref:makesample – a made-up area to try everything on: annotation, class table, photos."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ...core.sample import DEFAULT_SEED
from ..framework import offers
from ..framework.base import REFERENCE_DATABASE, Declared, SemRefAlgorithm, cancelable, follow
from ..framework.declarations import FolderOutput, NumberResult
from ..packages.components import OPENCV, SHAPELY
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ..framework.outputs import Outputs
    from ..framework.values import Values

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

    def title(self) -> str:
        return tr("Make sample area")

    def summary(self) -> str:
        return tr(
            "Makes up a piece of land of 4 × 3 km to try SemRef on: its land-cover polygons (landcover.shp), their "
            "class table (classes.csv), an orthophoto, photos taken anywhere above it, with where they were really "
            "taken (photos.csv), and the photos of one flight, with that and their times (flight.csv).\n\n"
            "The model that ships with SemRef can read these photos."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            FolderOutput(
                self.OUTPUT,
                tr("Folder for the sample"),
                tr("A new or empty folder; one that holds files is left alone."),
            ),
            offers.seed(tr("The same number gives the same area; another one makes up another."), DEFAULT_SEED),
            NumberResult(self.PHOTO_COUNT, tr("Number of photos")),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.sample.landscape import make_landscape
        from ...core.sample.pictures import PHOTO_COUNT
        from ...storage.sample_files import PIXEL_SIZE_M, render_photo, sample_steps

        with outputs.folder(self.OUTPUT) as folder:
            feedback.setProgressText(tr("Making up the landscape"))
            landscape = cancelable(make_landscape, values.integer(self.SEED), feedback=feedback)
            feedback.setProgress(LANDSCAPE_PERCENT)
            feedback.setProgressText(tr("Rendering it as a photo"))
            photo_hw3 = cancelable(render_photo, landscape, PIXEL_SIZE_M, feedback=feedback)
            steps = sample_steps(Path(folder), landscape, photo_hw3, PIXEL_SIZE_M)
            follow(steps, feedback, PHOTO_PERCENT, 100)
        made = outputs.results[self.OUTPUT]
        feedback.pushInfo(tr("{count} photos in {folder}").format(count=PHOTO_COUNT, folder=made))
        return {self.PHOTO_COUNT: PHOTO_COUNT}
