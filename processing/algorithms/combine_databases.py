"""semref:combinedatabases – several reference databases, by sheet or by date, as one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.errors import ParameterError
from ..framework.base import REFERENCE_DATABASE, Declared, SemRefAlgorithm, cancelable
from ..framework.declarations import FileOutput, Files, NumberResult
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ..framework.outputs import Outputs
    from ..framework.values import Values


class CombineDatabases(SemRefAlgorithm):
    ID = "combinedatabases"
    GROUP = REFERENCE_DATABASE
    TAGS = ("set", "parts", "sheets", "tiles", "mosaic", "merge", "join", "combine", "update date", "several")

    DATABASES = "DATABASES"
    OUTPUT = "OUTPUT"
    LANDMARK_COUNT = "LANDMARK_COUNT"
    CUT_COUNT = "CUT_COUNT"

    def title(self) -> str:
        return tr("Use databases as one")

    def summary(self) -> str:
        return tr(
            "Writes a small text file that names several reference databases, by sheet or by date. Wherever a database "
            "is read, this file can be given, and all are used as one; updating a sheet changes its file alone.\n\n"
            "The databases must be built alike: in one CRS, with one pixel size, class table, window size, stride and "
            "minimum area, from maps whose corners are whole pixels of the overview apart. Where two show the same "
            "ground, the one that was built or updated last tells it. Sheets should overlap by more than their "
            "landmarks are long: what no sheet has whole is no part of a constellation."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            Files(
                self.DATABASES,
                tr("Reference databases"),
                tr("GeoPackages made by “Build reference database”, two or more. They stay where they are."),
            ),
            FileOutput(
                self.OUTPUT,
                tr("Database set"),
                tr(
                    "A text file with the paths of the databases from its own folder on, so that all can move together."
                ),
                filter=tr("Database sets (*.semrefset)"),
            ),
            NumberResult(self.LANDMARK_COUNT, tr("Number of landmarks")),
            NumberResult(self.CUT_COUNT, tr("Landmarks that no database has whole")),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.database.joined import cut_landmarks, joined_database
        from ...storage.database.reader import read_parts
        from ...storage.database.sets import SUFFIX, is_set, require_parts, set_text

        paths, target = values.files(self.DATABASES), values.target(self.OUTPUT)
        if len(paths) < 2:
            raise ParameterError("algorithms.too_few_databases", count=len(paths))
        if not is_set(target):
            raise ParameterError("algorithms.no_set_name", output=target, suffix=SUFFIX)
        require_parts(target, paths)
        feedback.setProgressText(tr("Reading the databases"))
        parts = cancelable(read_parts, paths, True, feedback=feedback)
        feedback.setProgress(70)
        database = cancelable(joined_database, parts, target, feedback=feedback)
        cut = cut_landmarks(database, [part.parameters for part in parts])
        outputs.text(self.OUTPUT, set_text(target, paths))
        counts = {"databases": len(parts), "landmarks": len(database.references), "windows": len(database.windows)}
        feedback.pushInfo(
            tr("{databases} databases together have {landmarks} landmarks and {windows} windows.").format(**counts)
        )
        if cut:
            warning = tr(
                "{count} landmarks go on beyond the edge of their database and are whole in none, so no constellation "
                "has them; let sheets overlap more where that is too many."
            )
            feedback.pushWarning(warning.format(count=cut))
        return {self.LANDMARK_COUNT: len(database.references), self.CUT_COUNT: cut}
