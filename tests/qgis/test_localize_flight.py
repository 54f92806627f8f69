import threading
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_inputs import NAMES, NORTH, WEST, read_rows, scattered_objects, write_raster, write_text
from qgis.core import QgsProcessingException, QgsProcessingFeedback, QgsVectorLayer

from semref.core.flight import settings
from semref.core.geometry.frame import MapFrame
from semref.core.simulation.views import View, cut

FLIGHT = "semref:localizeflight"
SIZE, STEP = 200, 90
MAP = scattered_objects(900, 1400, 800, seed=5)
COUNT = 8
VIEWS = [
    View(WEST + 300 + STEP * n, NORTH - 350 - 30 * np.sin(n / 2), 80 + 3 * n, 1 + 0.005 * n, SIZE, SIZE)
    for n in range(COUNT)
]
BLANK = 5
"""Number of the image without content, from 0: only the flight can place it."""
OTHER_MOTION = "image,dx_m,dy_m,dheading_deg\nother1,,,\nother2,1,1,0\n"


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """Return a folder of label images, with tables of their times and motion."""
    folder = tmp_path_factory.mktemp("images") / "flight"
    folder.mkdir()
    for number, view in enumerate(VIEWS, start=5):
        image = cut(MAP, MapFrame.at((WEST, NORTH), 1.0), view)
        write_raster(folder / f"image{number}.png", image if number - 5 != BLANK else image * 0, transform=None)
    times = [f"image{n}.png,2025-05-09T10:00:{2 * n:02d}" for n in range(5, 5 + COUNT)]
    write_text(folder.parent / "TIMES.CSV", "\n".join(["image,time", *times]))
    write_text(folder.parent / "motion.csv", odometry())
    return folder


def odometry(spoilt: float = 0.0) -> str:
    """Write a table of the true motion; ``spoilt``: error of each step in m."""
    lines = ["image,dx_m,dy_m,dheading_deg,sigma_m", "image5,,,,"]
    for number, (before, after) in enumerate(zip(VIEWS, VIEWS[1:]), start=6):
        step = complex(after.x - before.x, after.y - before.y) * np.exp(1j * np.radians(before.heading_deg))
        turn = after.heading_deg - before.heading_deg
        lines.append(f"image{number}.png,{step.real + spoilt:.3f},{step.imag:.3f},{turn:.3f},2")
    return "\n".join(lines)


@pytest.fixture(scope="module")
def localize(run_algorithm, build_area, flight, tmp_path_factory):
    """`localize(feedback=None, **parameters)` returns (rows of OUTPUT, results)."""
    database = build_area(MAP, NAMES, SIZE, SIZE / 2)

    def run(feedback=None, **parameters):
        folder = tmp_path_factory.mktemp("outputs")
        given = {"DATABASE": database, "IMAGES": str(flight), "METHOD": 2}
        given["ODOMETRY"] = str(flight.parent / "motion.csv")
        for key, name in {"OUTPUT": "positions.gpkg", "TRACK": "track.gpkg", "REPORT": "report.html"}.items():
            given[key] = str(folder / name)
        results = run_algorithm(FLIGHT, {**given, **parameters}, feedback)
        return read_rows(results["OUTPUT"]), results

    return run


@pytest.fixture(scope="module")
def found(localize, flight):
    return localize(ATTITUDE=str(flight.parent / "TIMES.CSV"))


def test_the_flight_is_placed_on_one_track_with_its_image_without_content(found):
    rows, results = found
    assert [Path(row["image"]).stem for row in rows] == [f"image{n}" for n in range(5, 5 + COUNT)]
    assert [row["number"] for row in rows] == list(range(1, COUNT + 1))
    placed = [(row, view) for row, view in zip(rows, VIEWS) if row["status"] == "fix"]
    assert results["FIX_COUNT"] == len(placed) >= COUNT - 3 and results["TRACK_COUNT"] == 1
    for row, view in placed:
        assert np.hypot(row["x"] - view.x, row["y"] - view.y) < max(3 * row["error_95"], 2)
        assert (row["heading"] - view.heading_deg + 180) % 360 - 180 == pytest.approx(0, abs=5)
        assert row["track"] == 1 and row["source"] in ("own", "flight") and row["confidence"] > 0.999
        assert row["sigma_east"] > 0 and -1 <= row["correlation"] <= 1
    row, view = rows[BLANK], VIEWS[BLANK]
    assert (row["status"], row["source"], row["outvoted"]) == ("fix", "flight", 0)
    assert np.hypot(row["x"] - view.x, row["y"] - view.y) < 10
    assert row["error_95"] > rows[BLANK - 1]["error_95"]


def test_the_track_goes_through_its_images_and_its_times_are_dates_that_qgis_can_play(found):
    rows, results = found
    (line,) = read_rows(results["TRACK"])
    placed = [(row["x"], row["y"]) for row in rows if row["status"] == "fix"]
    np.testing.assert_allclose([p[:2] for p in line["geometry"].GetPoints()], placed, atol=1e-6)
    own = sum(row["source"] == "own" for row in rows)
    assert (line["track"], line["images"], line["own"]) == (1, len(placed), own)
    assert line["length"] == pytest.approx(line["geometry"].Length())
    assert [row["time"][:19] for row in rows[:2]] == ["2025/05/09 10:00:10", "2025/05/09 10:00:12"]
    layer = QgsVectorLayer(results["OUTPUT"], "flight", "ogr")
    # QGIS 3.22 does not read the times of a default style when it opens a file.
    layer.loadDefaultStyle()
    played = layer.temporalProperties()
    assert played.isActive() and played.startField() == "time" and played.accumulateFeatures()


def test_the_report_lists_images_times_and_reasons(found):
    page = Path(found[1]["REPORT"]).read_text(encoding="utf-8")
    assert "Localization of a flight" in page and page.count("<ellipse") >= found[1]["FIX_COUNT"]
    assert "image10.png" in page and "from the odometry table" in page and "2025-05-09 10:00:10" in page


def test_a_flight_that_is_not_certain_enough_has_likely_positions_and_no_track(localize, feedback, monkeypatch):
    forgetful = replace(settings.FLIGHT, window=1, evidence_curve=(-2.0, 1.2, -2.0, 2.0))
    monkeypatch.setattr(settings, "FLIGHT", forgetful)
    rows, results = localize(feedback, RISK=1e-12)
    likely = [(row, view) for row, view in zip(rows, VIEWS) if row["status"] == "likely"]
    assert len(likely) >= COUNT - 3 and results["FIX_COUNT"] == results["TRACK_COUNT"] == 0
    for row, view in likely:
        assert np.hypot(row["x"] - view.x, row["y"] - view.y) < max(3 * row["error_95"], 2)
        assert (row["track"], row["source"]) in ((None, "own"), (None, "flight"))
        assert 0.8 <= row["confidence"] < 1 - 1e-12 and "only likely" in row["reason"]
    assert f"Likely positions: {len(likely)}. Tracks: 0." in feedback.textLog()
    page = Path(results["REPORT"]).read_text(encoding="utf-8")
    assert page.count("likely position<") == len(likely)


@pytest.mark.slow
def test_what_can_not_be_read_is_a_row_with_its_reason_and_the_flight_goes_on(localize, flight, tmp_path, feedback):
    broken = tmp_path / "image7.png"
    broken.write_bytes(b"no image")
    images = [str(broken), *(str(flight / f"image{n}.png") for n in (5, 6, 8, 9))]
    rows, _ = localize(feedback, IMAGES=images)
    assert [Path(row["image"]).stem for row in rows] == ["image5", "image6", "image7", "image8", "image9"]
    assert rows[2]["status"] == "error" and "image7.png" in rows[2]["reason"] and rows[2]["source"] is None
    assert [row["status"] for row in rows[3:]] == ["fix", "fix"]


@pytest.mark.slow
def test_a_flight_over_other_ground_has_no_track(localize, tmp_path):
    elsewhere = scattered_objects(900, 1400, 800, seed=6)
    for number, view in enumerate(VIEWS, start=5):
        image = cut(elsewhere, MapFrame.at((WEST, NORTH), 1.0), view)
        write_raster(tmp_path / f"image{number}.png", image, transform=None)
    rows, results = localize(IMAGES=str(tmp_path))
    assert results["FIX_COUNT"] == results["TRACK_COUNT"] == 0
    assert all(row["x"] is None and row["reason"] for row in rows)
    assert "None" not in Path(results["REPORT"]).read_text(encoding="utf-8")


def geo(names: Sequence[str], turned: float = 0.0) -> str:
    """Write OpenDroneMap's geo.txt with the true headings; ``turned``: error in degrees."""
    lines = [f"{name} 9 47 300 {view.heading_deg + turned} 0 0" for name, view in zip(names, VIEWS)]
    return "\n".join(["EPSG:4326", *lines])


@pytest.mark.slow
def test_headings_of_a_log_narrow_the_search(localize, flight, tmp_path):
    names = [f"image{n}.png" for n in range(5, 5 + COUNT)]
    _, right = localize(LOG=str(write_text(tmp_path / "GEO.TXT", geo(names))))
    assert right["FIX_COUNT"] >= COUNT - 3
    _, wrong = localize(LOG=str(write_text(tmp_path / "turned.txt", geo(names, 90))))
    assert wrong["FIX_COUNT"] == 0


@pytest.mark.parametrize(
    ("key", "text", "sentence"),
    [
        ("LOG", "no log", "not a supported flight log"),
        ("LOG", geo(["other.png"]), "contains no entry for these images"),
        ("ODOMETRY", OTHER_MOTION, "no motion between two of these images"),
    ],
)
def test_what_is_no_log_or_odometry_table_of_this_flight_is_refused(localize, tmp_path, key, text, sentence):
    with pytest.raises(QgsProcessingException, match=sentence):
        localize(**{key: str(write_text(tmp_path / "table.txt", text))})


@pytest.mark.slow
def test_reading_a_long_log_ends_at_a_cancel_and_its_thread_with_it(localize, tmp_path):
    zeros = b"ULog\x01\x12\x35\x01" + bytes(60_000_000)
    (tmp_path / "zeros.ulg").write_bytes(zeros)
    feedback = QgsProcessingFeedback(False)
    canceled_at = []
    threading.Timer(1.5, lambda: (feedback.cancel(), canceled_at.append(time.process_time()))).start()
    before = threading.active_count()
    with pytest.raises(QgsProcessingException, match="Canceled"):
        localize(feedback, LOG=str(tmp_path / "zeros.ulg"))
    while threading.active_count() > before and time.process_time() < canceled_at[0] + 30:
        time.sleep(0.02)
    assert time.process_time() - canceled_at[0] < 1.0
