"""Examples of the guide and of CONTRIBUTING have valid parameters and run."""

import ast
import importlib
import re
import shlex
import shutil
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingParameterDefinition

pytestmark = pytest.mark.newer

TRAINING = "trainmodel"
PLACES = (".shp", ".csv", ".tif", ".gpkg", ".onnx", ".html", ".npz", ".pdf", ".png", ".jpg")


@pytest.fixture(scope="module")
def calls(repository):
    sys.path.append(str(repository / "tools" / "docs"))
    yield importlib.import_module("example_calls")
    sys.path.remove(str(repository / "tools" / "docs"))


@pytest.fixture
def algorithms(qgis_app):
    return {one.name(): one for one in QgsApplication.processingRegistry().providerById("semref").algorithms()}


def test_every_algorithm_has_an_example(calls, algorithms):
    assert set(calls.EXAMPLES) == set(algorithms)


def test_examples_name_parameters_that_are_there_and_all_that_must_be(calls, algorithms):
    for name, values in calls.EXAMPLES.items():
        definitions = {one.name(): one for one in algorithms[name].parameterDefinitions()}
        assert set(values) <= set(definitions), name
        for key, one in definitions.items():
            is_left_out = one.flags() & QgsProcessingParameterDefinition.FlagOptional and key not in values
            # Without a context QGIS does not look for the files.
            is_good = is_left_out or one.checkValueIsAcceptable(values.get(key, one.defaultValue()))
            assert is_good, f"{name}: {key}"


def test_what_an_example_reads_is_of_the_sample_or_of_an_example_before_it(calls, algorithms):
    written, given = {"sample", calls.MODEL}, {"area.osm.pbf", "colors.tif"}
    for name, values in calls.EXAMPLES.items():
        outputs = {one.name() for one in algorithms[name].destinationParameterDefinitions()}
        for key, value in values.items():
            for path in value if isinstance(value, list) else [value]:
                if key in outputs or not isinstance(path, str) or not path.endswith((*PLACES, ".pbf")):
                    continue
                assert path.partition("/")[0] in written | given, f"{name}: {key}={path}"
        written |= {str(value).partition("/")[0] for key, value in values.items() if key in outputs}


def test_both_calls_have_the_same_parameters(calls):
    for name, values in calls.EXAMPLES.items():
        words = shlex.split(calls.in_terminal(name).replace("\\\n", " "))
        assert words[:4] == ["qgis_process", "run", f"semref:{name}", "--"]
        assert [word.partition("=")[0] for word in words[4:]] == list(values)
        spoken = ast.parse(calls.in_python(name), mode="eval").body
        assert ast.unparse(spoken.func) == "processing.run"
        assert [ast.literal_eval(one) for one in spoken.args] == [f"semref:{name}", values]


@pytest.mark.slow
def test_the_examples_run_in_turn_on_the_sample_area(calls, run_algorithm, repository, sample, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(repository / "models" / calls.MODEL, tmp_path)
    shutil.copytree(sample, tmp_path / "sample")
    for name in calls.EXAMPLES:
        if name in (TRAINING, "classifyopenstreetmap"):
            continue
        if name == "decodecolorlabels":
            gdal.Translate("colors.tif", "labels.tif", rgbExpand="rgb")
        results = run_algorithm(f"semref:{name}", calls.EXAMPLES[name])
        for key, value in calls.EXAMPLES[name].items():
            is_file = isinstance(value, str) and re.search(r"\.\w+$", value)
            assert key not in results or not is_file or Path(value).stat().st_size, f"{name} left {value} empty"
        if name == "localizeimages":
            assert results["FIX_COUNT"] == 12


def test_the_algorithm_of_the_walk_counts_landmarks(repository, build_area, feedback, tmp_path):
    (example,) = re.findall(r"```python\n(.*?)```", (repository / "CONTRIBUTING.md").read_text("utf-8"), re.DOTALL)
    package = "semref.processing.algorithms"
    module = {"__name__": f"{package}.count_landmarks", "__package__": package}
    exec(compile(textwrap.dedent(example), "CONTRIBUTING.md", "exec"), module)
    labels = np.full((100, 100), 4, np.uint8)
    labels[10:20, 10:20] = labels[50:60, 30:42] = 1
    labels[70:90, 70:90] = 2
    area = build_area(labels, ["unlabeled", "building", "water", "bare_land", "field"], 50, 25)
    given = {"DATABASE": area, "OUTPUT": str(tmp_path / "count.txt")}
    results, succeeded = module["CountLandmarks"]().create().run(given, QgsProcessingContext(), feedback)
    assert succeeded, feedback.textLog()
    assert results == {"OUTPUT": given["OUTPUT"], "COUNT": 3}
    assert (tmp_path / "count.txt").read_text() == "3"
