"""What is said of an image on board, whatever is wrong with it."""

from __future__ import annotations

import os
from dataclasses import replace

import cv2
import pytest
from onboard_area import CENTER, HERE, write_area

from semref.core.geometry.camera import Camera
from semref.core.geometry.leveling import Attitude
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.search import Search
from semref.core.onboard.finder import ERROR, FinderSettings, label_reader
from semref.core.onboard.read import read_onboard
from semref.core.pipeline import Pipeline


@pytest.fixture(scope="module")
def finding(tmp_path_factory):
    path = str(tmp_path_factory.mktemp("onboard") / "area.npz")
    write_area(path)
    onboard = read_onboard(path)
    labels = label_reader(None, 1, onboard.database.class_table)
    return FinderSettings(onboard, Pipeline(Localizer(onboard.database), Search(Method.CONSTELLATION), labels))


class Tilted:
    """A camera that looks ahead."""

    def of(self, path):
        return Camera(Attitude(10.0, 5.0))


@pytest.fixture
def image(tmp_path):
    path = str(tmp_path / "a.png")
    cv2.imwrite(path, HERE)
    return path


def test_a_fix_has_its_place_in_both_systems_and_its_time(finding, image):
    os.utime(image, (0, 86_400))
    found = finding(image)
    assert (found["image"], found["status"], found["time"]) == (image, "fix", "1970-01-02T00:00:00+00:00")
    assert (found["x"], found["y"]) == pytest.approx(CENTER, abs=1)
    assert (found["longitude"], found["latitude"]) == pytest.approx((9.003125, 46.996396), abs=1e-4)


def test_without_longitude_and_latitude_the_map_is_all_there_is(finding, image):
    bare = replace(finding, onboard=replace(finding.onboard, lon_lat=None))
    found = bare(image)
    assert found["status"] == "fix" and "longitude" not in found


def test_what_can_not_be_read_is_an_error_with_its_reason(finding, tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(b"no image")
    assert finding(str(path))["status"] == ERROR and "a.png" in finding(str(path))["reason"]
    assert finding(str(tmp_path / "gone.png"))["status"] == ERROR


def test_a_fault_of_the_program_stops_no_other_image(finding, image, monkeypatch):
    def broken(self, path):
        raise ZeroDivisionError("a fault")

    monkeypatch.setattr(FinderSettings, "localized", broken)
    assert finding(image)["reason"] == "ZeroDivisionError: a fault"


def test_topology_vectors_are_told_nothing_of_the_camera(finding, image):
    search = Search(Method.TOPOLOGY_VECTOR)
    published = replace(finding, pipeline=replace(finding.pipeline, search=search), cameras=Tilted())
    assert published.camera_of(image).attitude is None
    assert replace(finding, cameras=Tilted()).camera_of(image).attitude is not None
