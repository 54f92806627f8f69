import numpy as np
import pytest
from made_inputs import NAMES, scattered_objects, write_raster, write_text
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingParameterDefinition

from semref.core.errors import SemRefError
from semref.core.evaluation.evaluation import TrialRanges
from semref.core.localization import Method
from semref.core.simulation.conditions import ASSUMED, LARGEST_LENS, LARGEST_TILT_DEG, conditions_of
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import LabelNoise
from semref.processing.algorithms.evaluate_localization import ORDER, RANGES
from semref.processing.base.values import Values
from semref.processing.jobs.assessing import USUAL
from semref.processing.reports import page
from semref.processing.reports.network_noise import network_meta

AS_GIVEN, GOOD, USABLE, POOR = range(4)
NOISE = LabelNoise(missed=0.25, jitter=1.0)


@pytest.fixture(scope="module")
def report(run_algorithm, tmp_path_factory):
    """Return the report of a map with missed landmarks and boundary jitter."""
    folder = tmp_path_factory.mktemp("compared")
    labels = scattered_objects(900, 900, 450, seed=3)
    spoiled = spoil_labels(labels, NOISE, np.random.default_rng(2), (1, 2, 3), minimum_area_px=50)
    given = {
        "REFERENCE": str(write_raster(folder / "annotated.tif", labels, names=NAMES)),
        "PREDICTED": str(write_raster(folder / "predicted.tif", spoiled, names=NAMES)),
        "DISAGREEMENTS": "memory:",
        "MINIMUM_AREA": 60,
        "REPORT": str(folder / "report.html"),
    }
    run_algorithm("semref:comparelabels", given)
    return given["REPORT"]


@pytest.fixture
def conditions(qgis_app):
    def of(name: str, parameters: dict):
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(name)
        return algorithm.conditions(Values(algorithm, parameters, QgsProcessingContext()))

    return of


@pytest.mark.parametrize("name", ["semref:assessdatabase", "semref:assessroute"])
def test_a_preset_is_a_multiple_of_what_is_assumed_and_leaves_map_and_camera(conditions, name):
    given = conditions(name, {})
    assert conditions(name, {"NETWORK": USABLE, "MISSED": 77}) == given
    for preset, factor in ((GOOD, 0.5), (POOR, 2.0)):
        found = conditions(name, {"NETWORK": preset, "TILT": 7})
        network = (found.noise.missed, found.noise.spurious, found.noise.mislabeled, found.noise.jitter)
        assert network == pytest.approx((0.2 * factor, 0.2 * factor, 0.05 * factor, factor))
        assert found.class_shift == pytest.approx(factor * given.class_shift)
        assert (found.lens, found.noise.displaced, found.tilt_deg) == (given.lens, given.noise.displaced, 7)


def test_numbers_count_where_no_preset_is_chosen(conditions):
    found = conditions("semref:assessroute", {"MISSED": 33, "NETWORK": AS_GIVEN})
    assert found.noise.missed == pytest.approx(0.33) and found.noise.spurious == pytest.approx(0.2)


@pytest.mark.parametrize(("name", "most"), [("assessroute", 6), ("assessdatabase", 4)])
def test_only_what_matters_is_unfolded(qgis_app, name, most):
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")
    folded = QgsProcessingParameterDefinition.FlagAdvanced
    shown = [p.name() for p in algorithm.parameterDefinitions() if not p.isDestination() and not p.flags() & folded]
    assert len(shown) == most and shown[-2:] == ["NETWORK", "COMPARISON"]


@pytest.mark.parametrize("name", ["semref:assessdatabase", "semref:assessroute"])
def test_an_assessment_assumes_what_the_comparison_found(conditions, report, name):
    found, usual = conditions(name, {"COMPARISON": report, "NETWORK": 3, "MISSED": 1}), conditions(name, {})
    assert found.noise.missed == pytest.approx(0.25, abs=0.08)
    assert found.noise.jitter == pytest.approx(1.0, rel=0.4)
    assert found.noise.mislabeled < 0.03 and found.noise.spurious < 0.08
    assert (found.lens, found.tilt_deg, found.noise.displaced) == (usual.lens, usual.tilt_deg, usual.noise.displaced)


def test_an_evaluation_assumes_the_same(conditions, report):
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("semref:evaluatelocalization")
    ranges = algorithm._ranges(Values(algorithm, {"COMPARISON": report, "MISSED": "1,2"}, QgsProcessingContext()))
    noise = conditions("semref:assessdatabase", {"COMPARISON": report}).noise
    assert ranges.missed == (pytest.approx(100 * noise.missed),) * 2
    assert ranges.ragged == (noise.jitter, noise.jitter)


def test_the_report_shows_the_landmarks_of_each_class_and_what_to_do(report):
    with open(report, encoding="utf-8") as file:
        text = file.read()
    assert "<h2>Landmarks</h2>" in text and "missed" in text and "Assess reference database" in text


@pytest.mark.parametrize(
    "content",
    ["", "a page", "<![if x y[", *(f'<meta name="semref-network" content="{text}">' for text in ("no JSON", "[1]"))],
)
def test_another_file_is_refused_in_a_sentence(create, tmp_path, content):
    file = write_text(tmp_path / "page.html", content)
    given = {"DATABASE": str(tmp_path / "a.gpkg"), "COMPARISON": str(file), "OUTPUT": "memory:"}
    able, said = create("assessdatabase").checkParameterValues(given, QgsProcessingContext())
    assert not able and said.startswith(f"{file} is not a report of “Compare label maps” with landmarks.")


@pytest.fixture
def page_of(tmp_path):
    """`page_of(numbers, landmarks)` writes a report with these numbers of a comparison; returns its path."""

    def write(numbers, landmarks=50):
        text = page.page("t", "s", meta=network_meta(numbers, landmarks))
        return str(write_text(tmp_path / "page.html", text))

    return write


def test_lengths_not_measured_by_the_comparison_keep_their_numbers(conditions, page_of):
    given = {"COMPARISON": page_of({"MISSED": 7.0, "RAGGED": None}), "RAGGED": 2.5}
    found = conditions("semref:assessdatabase", given)
    assert (found.noise.missed, found.noise.jitter) == (0.07, 2.5)


@pytest.mark.parametrize(
    ("numbers", "landmarks"), [({"MISSED": 20.0}, 5), ({"MISSED": 500.0}, 50), ({"MISNAMED": 101.0}, 50)]
)
def test_few_landmarks_and_numbers_beyond_what_the_dialogs_take_are_refused(conditions, page_of, numbers, landmarks):
    with pytest.raises(SemRefError):
        conditions("semref:assessdatabase", {"COMPARISON": page_of(numbers, landmarks)})


def test_usual_values_are_those_that_assessments_assume_and_the_largest_those_of_cameras():
    found = conditions_of({key.lower(): value for key, (value, _) in USUAL.items()})
    for name in ("missed", "spurious", "mislabeled", "jitter", "background", "leaning"):
        assert getattr(found.noise, name) == pytest.approx(getattr(ASSUMED.noise, name)), name
    assert found.noise.displaced == pytest.approx(ASSUMED.noise.displaced, abs=0.05)
    assert (found.class_shift, found.lens, found.tilt_deg) == (ASSUMED.class_shift, ASSUMED.lens, ASSUMED.tilt_deg)
    assert (USUAL["LENS"][1], USUAL["TILT"][1]) == (LARGEST_LENS, LARGEST_TILT_DEG)
    assert all(most is None or 0 <= value <= most for value, most in USUAL.values())


def test_every_range_is_one_of_an_evaluation_and_every_method_has_its_place():
    ranges = {key.lower(): limits for key, limits in RANGES.items()}
    assert vars(TrialRanges(**ranges)) == ranges
    assert set(ORDER) == set(Method) and len(ORDER) == len(Method) and ORDER[-1] is Method.TOPOLOGY_VECTOR
