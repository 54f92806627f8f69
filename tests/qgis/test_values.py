"""Values of parameters are read the same way from numbers, texts, lists and missing values."""

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingContext,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
    QgsProcessingParameterRange,
    QgsProcessingParameterString,
)

from semref.core.errors import ParameterError
from semref.processing.base.algorithm import SemRefAlgorithm
from semref.processing.base.parameters import with_help
from semref.processing.base.values import Values
from semref.processing.compat import DOUBLE, INTEGER, SOURCE_FILE


@pytest.fixture
def read(qgis_app):
    """`read(number=…)` returns the Values of an algorithm with one parameter of each kind."""

    class Everything(SemRefAlgorithm):
        ID = GROUP = "everything"

        def parameters(self):
            number = QgsProcessingParameterNumber("number", "A title", DOUBLE, 2.5, optional=True)
            return (
                with_help(number, "What it is for.", advanced=True),
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
                QgsProcessingOutputNumber("count", "How many"),
            )

    algorithm = Everything()
    algorithm.initAlgorithm()
    context = QgsProcessingContext()
    return lambda **given: Values(algorithm, given, context)


def test_an_algorithm_has_its_parameters_with_their_help_and_its_outputs(read):
    algorithm = read()._algorithm
    number = algorithm.parameterDefinition("number")
    assert (number.description(), number.help()) == ("A title", "What it is for.")
    assert number.flags() & number.FlagAdvanced and number.flags() & number.FlagOptional
    assert [output.name() for output in algorithm.outputDefinitions()] == ["count"]


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
    with pytest.raises(ParameterError, match="“text” is “1;x”, which is not a list of numbers"):
        read(text="1;x").numbers("text")


def test_files_are_a_list_one_path_or_several_as_text(read, tmp_path):
    first, second = (tmp_path / name for name in ("a; b.png", "c.png"))
    first.touch()
    assert read(files=[str(first), str(second)]).files("files") == [str(first), str(second)]
    # A name that contains the separator is one file, if that file exists.
    assert read(files=str(first)).files("files") == [str(first)]
    assert read(files=f"{second}; d.png").files("files") == [str(second), "d.png"]


def test_a_point_comes_in_the_crs_asked_for(read):
    crs = QgsCoordinateReferenceSystem("EPSG:32632")
    assert read().point("point", crs) is None
    x, y = read(point="9,47 [EPSG:4326]").point("point", crs)
    assert (round(x), round(y)) == (500000, 5205164)


def test_an_unreadable_source_is_refused_and_a_missing_one_is_none(read):
    assert read().source("source") is None
    with pytest.raises(ParameterError):
        read(source="no/such/layer.gpkg").source("source")
