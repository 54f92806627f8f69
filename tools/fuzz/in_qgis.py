"""The ways in that QGIS leads through: parameters of every algorithm, annotation layers, projects."""

from __future__ import annotations

import hashlib
import json
import math
import shutil
import time
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any

from .contract import Placed, Refused, World, require, require_one_sentence
from .doors import Door, Tools
from .mutations import NUMBERS, mutated_text, word

CANCELED_AFTER_S = 1.0
"""What a user may ask for can take long; a cancel must end it."""

_held: list[Any] = []


def started() -> Any:
    """QGIS without a window, with our provider, until the process ends."""
    from qgis_session import qgis_session

    if not _held:
        session = qgis_session()
        _held.extend((session, session.__enter__()))
    return _held[1]


class Runner:
    """Runs algorithms as QGIS does, in this thread, so that what they raise is seen."""

    def __init__(self, world: World) -> None:
        from qgis.core import QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

        class Impatient(QgsProcessingFeedback):
            """Canceled after a while."""

            def __init__(self) -> None:
                super().__init__(False)
                self.begun = time.monotonic()

            def isCanceled(self) -> bool:
                return time.monotonic() - self.begun > CANCELED_AFTER_S

        self._context, self._feedback, self._refusal = QgsProcessingContext, Impatient, QgsProcessingException
        self.algorithms = {algorithm.name(): algorithm for algorithm in started().algorithms()}
        self.out = world.folder.parent / "out"

    def __call__(self, name: str, parameters: dict[str, Any]) -> None:
        """Raises Refused with QGIS's sentence; anything else is a fault."""
        self.out.mkdir()
        try:
            algorithm, context = self.algorithms[name].create(), self._context()
            possible, reason = algorithm.checkParameterValues(parameters, context)
            if not possible:
                require_one_sentence(reason)
                raise Refused(reason)
            feedback = self._feedback()
            try:
                algorithm.prepareAlgorithm(parameters, context, feedback)
                results = algorithm.processAlgorithm(parameters, context, feedback)
            except self._refusal as error:
                require_one_sentence(str(error))
                raise Refused(str(error)) from None
            for value in results.values():
                require(not isinstance(value, float) or math.isfinite(value), f"a result that is none: {value}")
        finally:
            shutil.rmtree(self.out)


def algorithms(world: World) -> Tools:
    from .cases import all_parameters, make_inputs

    run, given = Runner(world), world.folder.parent / "in"
    make_inputs(given)
    base = all_parameters(started(), given, run.out)
    targets = {
        name: {definition.name() for definition in run.algorithms[name].destinationParameterDefinitions()}
        for name in base
    }
    # GDAL keeps statistics beside rasters.
    inputs = [path for path in given.rglob("*") if path.is_file() and path.suffix != ".xml"]
    # QGIS opens GeoPackages with a journal, which touches them.
    state = {path: _digest(path) for path in inputs if path.suffix != ".gpkg" or path.stem == "area"}
    paths = (*map(str, inputs), str(world.secret), "/dev/null", str(world.folder), "/", "\\\\host\\share\\a.tif")
    world.forget()

    def value(random: Random) -> Any:
        numbers = (math.nan, math.inf, 1e308, -1.0, 0, 1e-320, 2**31, 2**53, 0.3)
        others = (None, [], [1], ["x", None], {}, True, "0,nan", "1,1 [EPSG:4326]")
        return random.choice((word(random), random.choice(paths), random.choice(numbers), random.choice(others)))

    def make(random: Random) -> tuple[str, dict[str, Any]]:
        name = random.choice(sorted(base))
        changed = dict(base[name])
        for _ in range(random.randint(1, 3)):
            keys = [definition.name() for definition in run.algorithms[name].parameterDefinitions()]
            changed[random.choice(keys)] = value(random)
        # Outputs go where a user may write; where they may not, tests/qgis/test_outputs.py looks.
        return name, {key: _inside(entry, run.out, key in targets[name]) for key, entry in changed.items()}

    def attempt(made: tuple[str, dict[str, Any]]) -> None:
        try:
            run(*made)
        finally:
            if str(world.secret) in map(str, made[1].values()):
                world.excuse_reading()
        changed = [path for path, was in state.items() if _digest(path) != was]
        state.update({path: _digest(path) for path in changed})
        require(not changed, f"inputs changed: {changed}")

    return make, attempt


def _inside(value: Any, out: Path, is_target: bool) -> Any:
    """A destination's path brought below ``out``; other values as they are."""
    if not is_target or not isinstance(value, str) or value.startswith(str(out)):
        return value
    return str(out / value.replace("/", "_").replace("\0", ""))


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def layers(world: World) -> Tools:
    run, placed = Runner(world), Placed(world.folder, "layer.geojson")
    rings = [[[x, 5e6], [x + 30, 5e6], [x + 30, 5000025.0], [x, 5e6]] for x in (550000.0, 550020.0)]
    features = [
        {"type": "Feature", "properties": {"class": name}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
        for name, ring in zip(("building", "water"), rings)
    ]
    crs = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}}
    good = json.dumps({"type": "FeatureCollection", "crs": crs, "features": features})
    words = ("Point", "MultiPolygon", "GeometryCollection", "CurvePolygon", "550000", "1e9", "null", "[]")

    def make(random: Random) -> tuple[str, bytes]:
        name = random.choice(("checkannotation", "rasterizeannotation", "repairannotation"))
        return name, mutated_text(random, good, words)

    def attempt(made: tuple[str, bytes]) -> None:
        name, data = made
        target = {"OUTPUT": str(run.out / ("x.tif" if name == "rasterizeannotation" else "x.gpkg"))}
        more = {"PIXEL_SIZE": 1} if name != "repairannotation" else {}
        try:
            with placed(data) as path:
                issues = {"ISSUES": str(run.out / "y.gpkg")} if name == "checkannotation" else target
                run(name, {"INPUT": path, "CLASS_FIELD": "class", **more, **issues})
        finally:
            for left in world.folder.glob("layer*"):
                left.unlink()

    return make, attempt


PROJECT = """<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis projectname="" version="3.22.0"><title></title><properties><SemRef>
<database type="QString">./area.gpkg</database><model type="QString">./model.onnx</model>
<images type="QStringList"><value>./a.png</value><value>./b</value></images><method type="int">1</method>
<opacity type="int">60</opacity><prior type="QStringList"><value>1.5</value><value>2.5</value><value>3.5</value>
<value>4.5</value><value>EPSG:32632</value></prior></SemRef></properties></qgis>
"""


def projects(world: World) -> Tools:
    started()
    from qgis.core import QgsProject

    from semref.ui.project_state import read_state

    project, placed = QgsProject(), Placed(world.folder, "project.qgs")

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            read = project.read(path)
            state = read_state(project)
        project.clear()
        if not read or state is None:
            raise Refused("QGIS refused the project.")
        require(all(isinstance(text, str) for text in (state.database, state.model, *state.images)), "a path")
        require(isinstance(state.method, int) and 0 <= state.method < 10, f"method {state.method}")
        known: Sequence[float] = state.prior[:4] if state.prior is not None else ()
        require(all(math.isfinite(value) and abs(value) < 1e10 for value in known), "a circle that is none")

    return lambda random: mutated_text(random, PROJECT, ("QStringList", "int", *NUMBERS[:12])), attempt


DOORS = (
    Door("layers", "annotation layers (GeoJSON)", layers, 0.05),
    Door("algorithms", "parameters of the algorithms", algorithms, 0.05),
    Door("projects", "what the dock keeps in a project", projects, 0.2),
)
