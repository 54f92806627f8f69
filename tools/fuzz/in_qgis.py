"""The readers that QGIS calls: parameters of every algorithm, annotation layers, projects."""

import contextlib
import functools
import hashlib
import math
import shutil
import sys
import time
from pathlib import Path
from random import Random
from typing import Any

from .contract import Refused, World, require
from .mutator import WORDS, changed_text
from .readers import SAMPLES, Reader, Trial, of_files

CANCELED_AFTER_S = 1.0
"""An algorithm may take long, but a cancel must end it. The limit of processor time counts all its threads."""

LEFT_OUT = ("trainmodel", "setuparea")
"""They need a Python with torch; tests/qgis/test_train_model.py tests bad inputs."""

TOOLS = Path(__file__).resolve().parents[1]
_SESSION = contextlib.ExitStack()
"""QGIS without windows, which lasts as long as the process."""


@functools.cache
def algorithms_by_name() -> dict[str, Any]:
    """Start QGIS and return SemRef's algorithms."""
    from qgis_session import qgis_session

    return {algorithm.name(): algorithm for algorithm in _SESSION.enter_context(qgis_session()).algorithms()}


def run(name: str, parameters: dict[str, Any], out: Path) -> None:
    """Run an algorithm like QGIS, but in this thread and with visible errors.

    Args:
        name: Name of the algorithm.
        parameters: Its parameters.
        out: Folder of its outputs, which exists only during the run.

    Raises:
        Refused: With QGIS's message; other errors are faults.
    """
    from qgis.core import QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

    class Impatient(QgsProcessingFeedback):
        begun = time.monotonic()

        def isCanceled(self) -> bool:
            return time.monotonic() - self.begun > CANCELED_AFTER_S

    out.mkdir()
    try:
        algorithm = algorithms_by_name()[name].create()
        context, feedback = QgsProcessingContext(), Impatient(False)
        possible, reason = algorithm.checkParameterValues(parameters, context)
        if not possible:
            raise Refused(reason)
        algorithm.prepareAlgorithm(parameters, context, feedback)
        results = algorithm.processAlgorithm(parameters, context, feedback)
        for value in results.values():
            require(not isinstance(value, float) or math.isfinite(value), f"a result is {value}")
    except QgsProcessingException as error:
        raise Refused(str(error)) from None
    finally:
        shutil.rmtree(out)


def algorithms(world: World) -> Trial:
    """The example calls of the reference page with changed values."""
    known, base, out = algorithms_by_name(), example_calls(), world.folder.parent / "out"
    inputs = [path for path in Path().rglob("*") if path.is_file() and path.suffix in (".tif", ".shp", ".csv", ".npz")]
    # QGIS opens GeoPackages with a journal, which touches them; GDAL keeps statistics beside rasters.
    state = {path: digest(path) for path in inputs}
    paths = (*map(str, inputs), "reference.gpkg", str(world.secret), "/dev/null", "/", "\\\\host\\share\\a.tif")
    numbers = (math.nan, math.inf, 1e308, -1.0, 0, 1e-320, 2**31, 2**53, 0.3)
    others = (None, [], [1], ["x", None], {}, True, "0,nan", "1,1 [EPSG:4326]")

    def make(random: Random) -> tuple[str, dict[str, Any]]:
        name = random.choice(sorted(base))
        changed = dict(base[name])
        for _ in range(random.randint(1, 3)):
            keys = [definition.name() for definition in known[name].parameterDefinitions()]
            changed[random.choice(keys)] = random.choice(random.choice((paths, numbers, others, WORDS)))
        # Other places of outputs: tests/qgis/test_outputs.py.
        for target in known[name].destinationParameterDefinitions():
            value = changed.get(target.name())
            if isinstance(value, str):
                changed[target.name()] = str(out / value.replace("/", "_").replace("\0", ""))
        return name, changed

    def attempt(made: tuple[str, dict[str, Any]]) -> None:
        try:
            run(*made, out)
        finally:
            if str(world.secret) in map(str, made[1].values()):
                world.excuse_reading()
        changed = [path for path, was in state.items() if digest(path) != was]
        state.update({path: digest(path) for path in changed})
        require(not changed, f"inputs changed: {changed}")

    return make, attempt


def example_calls() -> dict[str, dict[str, Any]]:
    """Return the parameters of the example calls, and write their inputs into the current folder."""
    import processing
    from osgeo import gdal

    sys.path.append(str(TOOLS / "docs"))
    from example_calls import EXAMPLES

    shutil.copytree(TOOLS.parent / "sample", "sample")
    shutil.copy(TOOLS.parent / "models" / "sample_area.onnx", ".")
    calls = {name: dict(call) for name, call in EXAMPLES.items() if name not in LEFT_OUT}
    photo = {"IMAGES": ["sample/photos/photo_01.jpg"]}
    calls["localizeimages"] |= photo
    calls["classifyopenstreetmap"] |= {"INPUT": "sample/landcover.shp", "LINES": "track.gpkg"}
    calls["evaluatelocalization"]["TRIALS"] = 1
    for name in ("rasterizeannotation", "builddatabase", "localizeimages"):
        processing.run(f"semref:{name}", calls[name])
    processing.run("semref:localizeflight", {**calls["localizeflight"], "IMAGES": photo["IMAGES"] * 2})
    for copy in ("predicted.tif", "corrected.tif"):
        shutil.copy("labels.tif", copy)
    gdal.Translate("colors.tif", "labels.tif", rgbExpand="rgb")
    return calls


def digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def layers(world: World) -> Trial:
    algorithms_by_name()  # starts QGIS
    out = world.folder.parent / "out"
    calls = (
        ("checkannotation", {"PIXEL_SIZE": 1, "ISSUES": str(out / "y.gpkg")}),
        ("rasterizeannotation", {"PIXEL_SIZE": 1, "OUTPUT": str(out / "x.tif")}),
        ("repairannotation", {"OUTPUT": str(out / "x.gpkg")}),
    )

    def read(path: str) -> None:
        name, outputs = calls[Path(path).stat().st_size % len(calls)]
        try:
            run(name, {"INPUT": path, "CLASS_FIELD": "class", **outputs}, out)
        finally:
            for left in set(world.folder.iterdir()) - {Path(path)}:
                left.unlink()

    return of_files(SAMPLES / "layers", read)(world)


def projects(world: World) -> Trial:
    """What the dock keeps in a project."""
    algorithms_by_name()  # starts QGIS
    from qgis.core import QgsProject

    from semref.ui.project_state import read_state

    project = QgsProject()

    def read(path: str) -> None:
        is_read, state = project.read(path), read_state(project)
        project.clear()
        if not is_read or state is None:
            raise Refused("QGIS refused the project.")
        require(all(isinstance(text, str) for text in (state.database, state.model, *state.images)), "a path")
        require(isinstance(state.method, int) and 0 <= state.method < 10, f"method {state.method}")
        known = state.prior[:4] if state.prior is not None else ()
        require(all(math.isfinite(value) and abs(value) < 1e10 for value in known), "an invalid search area")

    # QGIS itself crashes at XML with thousands of levels.
    return of_files(SAMPLES / "projects", read, changed_text)(world)


READERS = (Reader("layers", layers, 0.05), Reader("algorithms", algorithms, 0.05), Reader("projects", projects, 0.2))
