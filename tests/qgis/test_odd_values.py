import os
from functools import partial

import pytest
from bad_input import BUILD, LABELS, WINDOWS
from made_inputs import NAMES, write_raster
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRange,
    QgsProcessingParameterString,
    QgsProject,
)

from semref.core import limits
from semref.core.errors import ParameterError, SemRefError
from semref.core.flight.cameras import read_cameras
from semref.processing.base.algorithm import SemRefAlgorithm
from semref.processing.base.values import Values
from semref.processing.compat import DOUBLE, INTEGER, SOURCE_FILE
from semref.storage.database.reader import read_database
from semref.storage.text_tables import read_class_table, read_rules
from semref.ui.project_state import read_state


@pytest.fixture
def check(create):
    """`check(algorithm, **parameters)` returns whether QGIS takes the values, and the reason."""
    return lambda name, **given: create(name).checkParameterValues(given, QgsProcessingContext())


@pytest.mark.parametrize("kind", ["cameras", "class table", "rules"])
def test_a_table_is_not_read_that_is_huge_or_no_file(qgis_app, tmp_path, kind):
    read = {"cameras": partial(read_cameras, ["a.png"]), "class table": read_class_table, "rules": read_rules}[kind]
    huge, pipe = tmp_path / "huge.csv", tmp_path / "pipe.csv"
    with open(huge, "wb") as file:
        file.truncate(limits.TABLE_BYTES + 1)
    os.mkfifo(pipe)
    refusals = {huge: "is larger than", pipe: "is not a file", tmp_path: "is not a file", "a\0b": "can't be read"}
    for path, said in refusals.items():
        with pytest.raises(SemRefError) as refused:
            read(str(path))
        assert said in refused.value.sentence.template


@pytest.fixture
def build(run_algorithm, tmp_path):
    given = {"LABELS": str(write_raster(tmp_path / "labels.tif", LABELS, names=NAMES)), **WINDOWS}
    given["DATABASE"] = str(tmp_path / "area.gpkg")
    return lambda **parameters: run_algorithm(BUILD, {**given, **parameters})["DATABASE"]


@pytest.mark.parametrize(
    "parameters",
    [
        *({key: value} for key in ("WINDOW_SIZE", "STRIDE") for value in (float("nan"), 1e308)),
        {"MINIMUM_AREA": float("nan")},
        *({"LEVELS": value} for value in ("nan", "1;1e308", "-1", "[" * 100_000)),
        {"DATABASE": f"/tmp/{'d' * 300}.gpkg"},
    ],
    ids=lambda parameters: " ".join(f"{key} {str(value)[:12]}" for key, value in parameters.items()),
)
def test_odd_windows_and_names_are_refused(build, parameters):
    with pytest.raises(QgsProcessingException) as refused:
        build(**parameters)
    assert "Traceback" not in str(refused.value) and len(str(refused.value)) < 900


def test_wrong_values_are_refused_in_a_batch_too(create, feedback, tmp_path):
    """QGIS's batches and models run an algorithm without its check of the values."""
    given = {"LABELS": str(write_raster(tmp_path / "a.tif", LABELS)), "WINDOW_SIZE": 10, "STRIDE": 20, "DATABASE": "b"}
    odd = {"would leave gaps": {}, "b.tif not found": {"LABELS": "b.tif"}, "”: -1": {"MINIMUM_AREA": -1}}
    for reason, values in odd.items():
        assert not create("builddatabase").run({**given, **values}, QgsProcessingContext(), feedback)[1]
        assert reason in feedback.textLog()


def test_a_level_that_is_given_twice_counts_once(build):
    once, thrice = len(read_database(build(LEVELS="1")).windows), read_database(build(LEVELS="1;1;1"))
    assert (len(thrice.windows), thrice.parameters.levels) == (once, (1.0,))


@pytest.mark.parametrize("value", [float("nan"), float("inf"), "nan", "-inf"])
@pytest.mark.parametrize(("name", "key"), [("evaluatelocalization", "MIRRORED"), ("rasterizeannotation", "PIXEL_SIZE")])
def test_every_algorithm_refuses_nan(check, name, key, value):
    """QGIS accepts NaN within any limits of a number."""
    assert [bool(one) for one in check(name, **{key: value})] == [False, True]


@pytest.mark.parametrize("key", ["INPUT", "CLASS_FIELD", "EXTENT", "TARGET_CRS"])
def test_a_value_of_any_length_does_not_make_a_sentence_of_any_length(check, key):
    said = check("rasterizeannotation", **{key: "[\n" * 50_000})
    assert not said[0] and len(said[1]) < 1000 and "\n" not in said[1]


def test_infinite_places_of_a_layer_are_refused(run_algorithm, tmp_path):
    ring = "[[Infinity, 5000000], [550030, 5000000], [550030, 5000025], [Infinity, 5000000]]"
    feature = '{"type": "Feature", "properties": {"class": "a"}, "geometry": {"type": "Polygon", "coordinates": [%s]}}'
    crs = '"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}}'
    text = f'{{"type": "FeatureCollection", {crs}, "features": [{feature % ring}]}}'
    (tmp_path / "odd.geojson").write_text(text, encoding="ascii")
    given = {"INPUT": str(tmp_path / "odd.geojson"), "CLASS_FIELD": "class", "OUTPUT": str(tmp_path / "x.gpkg")}
    with pytest.raises(QgsProcessingException) as refused:
        run_algorithm("semref:repairannotation", given)
    assert "Traceback" not in str(refused.value)


IMAGES = {"DATABASE": "a.gpkg", "IMAGES": ["a.png"], "OUTPUT": "memory:"}
PRIORS = (["nan", "1", "2", "3", "EPSG:32632"], ["1e308", "1", "2", "3", "EPSG:32632"], ["inf"] * 4 + [""], ["1"] * 4)


@pytest.mark.parametrize("prior", PRIORS)
def test_a_project_keeps_no_impossible_circle(qgis_app, prior):
    project = QgsProject()
    for key, value in (("database", "a.gpkg"), ("prior", prior), ("method", 99)):
        project.writeEntry("SemRef", f"/{key}", value)
    state = read_state(project)
    assert (state.prior, state.method) == (None, 0)


@pytest.mark.parametrize("given", [{"CLASS_TABLE": "classes.\0csv"}, {"OUTPUT": "x\0.tif"}, {"INPUT": "colors\0.tif"}])
def test_a_text_with_a_character_0_is_refused(run_algorithm, tmp_path, given):
    """Python's files raise ValueError for it, and GDAL reads a name only up to it."""
    write_raster(tmp_path / "colors.tif", LABELS)
    (tmp_path / "classes.csv").write_text("value,name\n1,building\n", encoding="ascii")
    paths = {"INPUT": "colors.tif", "CLASS_TABLE": "classes.csv", "OUTPUT": "x.tif", **given}
    with pytest.raises(QgsProcessingException) as refused:
        run_algorithm("semref:decodecolorlabels", {key: str(tmp_path / path) for key, path in paths.items()})
    titles = {"CLASS_TABLE": "Class table", "OUTPUT": "Label map", "INPUT": "Color label image"}
    assert f"\n“{titles[next(iter(given))]}” is “" in str(refused.value) and "null character" in str(refused.value)


def test_images_with_a_character_0_and_an_output_in_no_folder_are_refused_before_work(check):
    for odd in ("IMAGES", ["b\0.png"], "“Images” is “b\\x00.png”"), ("OUTPUT", "none/a.gpkg", "The folder none"):
        assert check("localizeimages", **{**IMAGES, odd[0]: odd[1]})[1].startswith(odd[2])


@pytest.mark.parametrize("text", ["/folder/area.gpkg", "1,5", "x", "0x10", "1_000"])
def test_a_text_that_is_no_number_is_refused_even_for_optional_numbers(check, text):
    """QGIS reads it as 0, which is no valid scale."""
    possible, reason = check("localizeimages", **IMAGES, SCALE_MINIMUM=text)
    assert not possible and reason == f"“Minimum scale” is {text}, which is not a number. Enter a number."
    for number in ("1.5", " 2", "1e-1", ".5", "2."):
        assert check("localizeimages", **IMAGES, SCALE_MINIMUM=number)[0]


@pytest.fixture
def read(qgis_app):
    """`read(number=…)` returns the Values of an algorithm with one parameter of each kind."""

    class Everything(SemRefAlgorithm):
        ID = GROUP = "everything"

        def parameters(self):
            return (
                QgsProcessingParameterNumber("number", "", DOUBLE, 2.5, optional=True),
                QgsProcessingParameterNumber("left_out", "", DOUBLE, optional=True),
                QgsProcessingParameterNumber("integer", "", INTEGER, 3),
                QgsProcessingParameterBoolean("switch", "", True),
                QgsProcessingParameterEnum("choice", "", ["a", "b", "c"], defaultValue=1),
                QgsProcessingParameterRange("range", "", DOUBLE, "0,0.5", optional=True),
                QgsProcessingParameterString("text", "", optional=True),
                QgsProcessingParameterPoint("point", "", optional=True),
                QgsProcessingParameterFile("file", "", optional=True),
                QgsProcessingParameterMultipleLayers("files", "", SOURCE_FILE, optional=True),
                QgsProcessingParameterFeatureSource("source", "", optional=True),
            )

    algorithm = Everything()
    algorithm.initAlgorithm()
    context = QgsProcessingContext()
    return lambda **given: Values(algorithm, given, context)


@pytest.mark.parametrize("nothing", [{}, {"left_out": None}, {"left_out": ""}])
def test_an_optional_number_that_is_left_out_is_none_or_the_default_asked_for_and_may_be_zero(read, nothing):
    values = read(**nothing)
    assert not values.has("left_out") and values.optional_number("left_out") is None
    assert values.optional_number("left_out", 7.0) == 7.0
    assert read(left_out=0).optional_number("left_out", 7.0) == 0.0


@pytest.mark.parametrize("given", [4, 4.0, "4"])
def test_numbers_may_be_given_as_text(read, given):
    values = read(number=given, integer=given, left_out=given)
    assert (values.number("number"), values.integer("integer"), values.optional_number("left_out")) == (4.0, 4, 4.0)


def test_what_is_left_out_is_the_default(read):
    values = read()
    assert (values.number("number"), values.integer("integer"), values.choice("choice")) == (2.5, 3, 1)
    assert values.switch("switch") and values.range("range") == (0.0, 0.5)
    assert (values.text("text"), values.file("file"), values.class_table("file")) == ("", "", None)


def test_lists_are_separated_by_semicolons_without_empty_parts_and_other_than_numbers_are_refused(read):
    assert read().parts("text") == []
    assert read(text=" building; water;;").parts("text") == ["building", "water"]
    assert read(text="1; 2,5").numbers("text") == [1.0, 2.5]
    for text, said in (("1;x", "“1;x”, which is not a list of numbers"), ("1;1e400", "inf, which is not a number")):
        with pytest.raises(ParameterError, match=f"“text” is {said}"):
            read(text=text).numbers("text")


def test_files_are_a_list_one_path_or_several_as_text(read, tmp_path):
    first, second = (tmp_path / name for name in ("a; b.png", "c.png"))
    first.touch()
    assert read(files=[str(first), str(second)]).files("files") == [str(first), str(second)]
    # A name that contains the separator is one file, if that file exists.
    assert read(files=str(first)).files("files") == [str(first)]
    assert read(files=f"{second}; d.png").files("files") == [str(second), "d.png"]


def test_a_point_comes_in_the_crs_asked_for_and_an_unreadable_source_is_refused(read):
    crs = QgsCoordinateReferenceSystem("EPSG:32632")
    assert read().point("point", crs) is None
    x, y = read(point="9,47 [EPSG:4326]").point("point", crs)
    assert (round(x), round(y)) == (500000, 5205164)
    assert read().source("source") is None
    with pytest.raises(ParameterError):
        read(source="no/such/layer.gpkg").source("source")
