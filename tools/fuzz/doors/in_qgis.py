"""In QGIS: annotation layers, the parameters of every algorithm, projects."""

from __future__ import annotations

import json
import math
import os
import shutil
import time
from pathlib import Path
from random import Random
from typing import Any, Callable

from ..contract import Refused, World, require, require_one_sentence
from ..door import Door, Placed, Tools
from ..mutations import NUMBERS, TEXTS, mutated_bytes, mutated_json, word
from .algorithm_inputs import LAYER, base_parameters, inputs, write_plan

_CANCELED_AFTER_S = 1.0
"""What a user may ask for can take long; a cancel must end it."""

_held: list[Any] = []

POINTS = ([[550000, 5e6]], [550000, 5e6], [math.nan, 0], [1e308, 5e6], [550000, 5e6, 3], [[[550000, 5e6]]], [1e9, 1e9])
GEOMETRIES = (
    *({"type": kind, "coordinates": []} for kind in ("Polygon", "MultiPolygon", "Point", "LineString", "CurvePolygon")),
    *(None, {"type": "Point", "coordinates": [550000, 5e6]}, {"type": "GeometryCollection", "geometries": []}),
    {"type": "Polygon", "coordinates": [[[550000, 5e6], [550001, 5e6], [550000, 5e6]]]},
)


def started() -> Any:
    """QGIS without a window, with our provider; kept until the process ends, and the one that runs already if any."""
    from qgis.core import QgsApplication

    if QgsApplication.instance() is not None:
        return QgsApplication.processingRegistry().providerById("semref")
    from qgis_session import qgis_session

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
                return time.monotonic() - self.begun > _CANCELED_AFTER_S

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


def layers(world: World) -> Tools:
    run = Runner(world)
    suffixes = (".geojson", ".gpkg", ".shp")
    shapes = _binary_layers(world)
    world.forget()
    table = world.folder.parent / "classes.csv"
    table.write_text("value,name\n1,building\n2,water\n", encoding="ascii")

    def make(random: Random) -> Any:
        kind = random.random()
        name = random.choice(("checkannotation", "rasterizeannotation", "repairannotation"))
        if kind < 0.75:
            words = (*GEOMETRIES, *POINTS, "x" * 300, "building", "", None)
            data = json.dumps(mutated_json(random, LAYER, words)).encode("utf-8", "surrogatepass")
            return name, suffixes[0], mutated_bytes(random, data, most=2) if random.random() < 0.1 else data
        suffix = random.choice(suffixes[1:])
        return name, suffix, mutated_bytes(random, shapes[suffix], [b"GP\0\x01", b"\0" * 8, b"\xff" * 8], 3)

    def attempt(made: Any) -> None:
        name, suffix, data = made
        path = world.folder / f"layer{suffix}"
        if suffix == ".shp":
            for part in (".shx", ".dbf", ".prj"):
                path.with_suffix(part).write_bytes(shapes[part])
        try:
            with Placed(world.folder, path.name)(data) as given:
                parameters = {"INPUT": given, "CLASS_FIELD": "class", "CLASS_TABLE": str(table)}
                more = {"checkannotation": {"ISSUES": "TEMPORARY_OUTPUT"}, "repairannotation": {}}
                more["rasterizeannotation"] = {"PIXEL_SIZE": 1}
                target = {"OUTPUT": str(run.out / ("x.tif" if name == "rasterizeannotation" else "x.gpkg"))}
                run(name, {**parameters, **more[name], **target})
        finally:
            # GDAL writes indexes and statistics beside shapefiles and GeoPackages that it opens.
            for left in world.folder.glob("layer*"):
                left.unlink()

    return make, attempt


def _binary_layers(world: World) -> dict[str, bytes]:
    from osgeo import gdal

    source = world.folder / "source.geojson"
    source.write_text(json.dumps(LAYER), encoding="ascii")
    found = {}
    for suffix, driver in ((".gpkg", "GPKG"), (".shp", "ESRI Shapefile")):
        path = world.folder / f"layer{suffix}"
        gdal.VectorTranslate(str(path), str(source), format=driver)
        for part in sorted(world.folder.glob("layer*")):
            found[part.suffix] = part.read_bytes()
            part.unlink()
    source.unlink()
    return found


def parameters(world: World) -> Tools:
    run = Runner(world)
    files = inputs(world.folder.parent / "in")
    base = base_parameters({**files, "database": "", "again": ""}, run.out)
    run.out.mkdir()
    import processing

    database = str(world.folder.parent / "in" / "area.gpkg")
    processing.run("semref:builddatabase", {**base["builddatabase"], "DATABASE": database})
    shutil.rmtree(run.out)
    files["database"] = database
    files["again"] = str(shutil.copy(database, world.folder.parent / "in" / "again.gpkg"))
    write_plan(files, database)
    base = base_parameters(files, run.out)
    keys = {
        name: [definition.name() for definition in algorithm.parameterDefinitions()]
        for name, algorithm in run.algorithms.items()
    }
    targets = {
        name: [definition.name() for definition in algorithm.destinationParameterDefinitions()]
        for name, algorithm in run.algorithms.items()
    }
    paths = (*files.values(), str(world.secret), "/dev/null", str(world.folder), "/", files["labels"] + "|layername=x")
    state = _state(files)

    def value(random: Random, now: Any) -> Any:
        kind = random.randrange(6)
        if kind == 0:
            return random.choice(paths)
        if kind == 1:
            return random.choice(NUMBERS)
        if kind == 2:
            return random.choice((math.nan, math.inf, -math.inf, 1e308, -1.0, 0, 1e-320, 2**31, -(2**31), 2**53, 0.3))
        if kind == 3:
            return random.choice(
                (None, [], [1], ["x", None], {}, True, "1;2;nan", "0,nan", "1,1 [EPSG:4326]", "EPSG:0")
            )
        if kind == 4 and isinstance(now, str):
            return mutated_bytes(random, now.encode(), most=2).decode("utf-8", "replace")
        return word(random, TEXTS)

    def make(random: Random) -> Any:
        name = random.choice(sorted(base))
        given = dict(base[name])
        for _ in range(random.choice((1, 1, 1, 2, 3))):
            key = random.choice(keys[name])
            given[key] = value(random, given.get(key))
        # Outputs go where a user may write; where they may not is tools/faults' business.
        return name, {key: _kept_inside(entry, run.out, key, targets[name]) for key, entry in given.items()}

    def attempt(made: Any) -> None:
        try:
            run(*made)
        finally:
            if str(world.secret) in made[1].values():
                world.excuse_reading()
        changed = [path for path, was in state.items() if _stat(path) != was]
        require(not changed, f"inputs changed: {changed}")

    return make, attempt


def _kept_inside(value: Any, out: Path, key: str, targets: list[str]) -> Any:
    """A destination's path brought below ``out``; other values as they are."""
    if key in targets:
        if not isinstance(value, str) or value.startswith(str(out)) or value == "TEMPORARY_OUTPUT":
            return value
        return str(out / value.replace("/", "_").replace("\0", ""))
    return value


def _state(files: dict[str, str]) -> dict[str, tuple]:
    return {path: _stat(path) for path in files.values()}


def _stat(path: str) -> tuple:
    found = os.stat(path)
    return found.st_size, found.st_mtime_ns, found.st_ino


PROJECT = """<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis projectname="" version="3.22.0"><title></title><properties><SemRef>
<database type="QString">./area.gpkg</database><model type="QString">./model.onnx</model>
<results type="QString"></results>
<images type="QStringList"><value>./a.png</value><value>./b</value></images><method type="int">1</method>
<opacity type="int">60</opacity><prior type="QStringList"><value>1.5</value><value>2.5</value><value>3.5</value>
<value>4.5</value><value>EPSG:32632</value></prior></SemRef></properties></qgis>
"""


def projects(world: World) -> Tools:
    started()
    from qgis.core import QgsProject

    from semref.ui.project_state import read_state

    project, placed = QgsProject(), Placed(world.folder, "project.qgs")
    pieces = PROJECT.replace(">", ">\x01").replace("</", "\x01</").split("\x01")

    def make(random: Random) -> bytes:
        parts = list(pieces)
        for _ in range(random.choice((1, 1, 2, 3))):
            place, kind = random.randrange(3, len(parts)), random.randrange(4)
            if kind <= 1:
                parts[place] = word(random).replace("\0", "") if not parts[place].startswith("<") else parts[place]
            elif kind == 2:
                parts[place] = parts[place].replace("QStringList", "int").replace("QString", "QStringList")
            else:
                parts.insert(place, random.choice(parts))
        return (
            mutated_bytes(random, "".join(parts).encode("utf-8", "replace"), most=1)
            if random.random() < 0.2
            else ("".join(parts).encode("utf-8", "replace"))
        )

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            read = project.read(path)
            state = read_state(project)
        project.clear()
        if not read or state is None:
            raise Refused("QGIS tells why.")
        texts = (state.database, state.model, state.results, *state.images)
        require(all(isinstance(text, str) for text in texts), "a path that is none")
        require(isinstance(state.method, int) and 0 <= state.method < 10, f"method {state.method}")
        require(0 <= state.opacity <= 100, f"opacity {state.opacity}")
        if state.prior is not None:
            require(
                all(math.isfinite(value) and abs(value) < 1e10 for value in state.prior[:4]), "a circle that is none"
            )

    return make, attempt


DOORS = (
    Door("layers", "annotation layers (GeoJSON, GeoPackage, shapefile)", layers, 500, 1000),
    Door("algorithms", "parameters of the algorithms", parameters, 400, 500),
    Door("projects", "what the dock keeps in a project", projects, 4_000, 2500),
)
_Attempt = Callable[[Any], None]
