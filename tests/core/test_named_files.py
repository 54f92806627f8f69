"""Names in untrusted files are followed only into folders that the user chose."""

import os

import pytest

from semref.core.named_files import is_elsewhere, named_file
from semref.core.segmentation.onnx_file import OnnxHeader

SHARES = r"\\host\share\a.tif", "//host/share/a.tif", r"\\?\UNC\host\share\a.tif", " //host/share/a.tif"
URLS = "/vsicurl/http://host/a.tif", "/VSIZIP/vsicurl/http://host/a.zip/a.tif", "http://host/a.tif", "file:///a.tif"
ELSEWHERE = [*SHARES, *URLS, "GPKG:/a.gpkg:table", "<GDAL_WMS/>", '{"type": "a"}']


@pytest.mark.parametrize("path", ELSEWHERE)
def test_a_path_of_another_computer_is_not_followed(path):
    assert is_elsewhere(path)


@pytest.mark.parametrize("path", ["/home/me/a.tif", r"C:\maps\a.tif", "C:/maps/a.tif", "a.tif", "../a.tif", ""])
def test_a_path_of_this_computer_is_a_path(path):
    assert not is_elsewhere(path)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "chosen" / "inner").mkdir(parents=True)
    (tmp_path / "chosen2").mkdir()
    for place in ("chosen/a.tif", "chosen/inner/b.tif", "outside.tif", "chosen2/c.tif"):
        (tmp_path / place).write_bytes(b"")
    os.symlink(tmp_path / "outside.tif", tmp_path / "chosen" / "link.tif")
    return tmp_path


@pytest.mark.parametrize("name", ["a.tif", "inner/b.tif", "./inner/../a.tif", "{folder}/chosen/inner/b.tif"])
def test_a_file_in_the_chosen_folder_is_followed(folder, name):
    found = named_file(name.format(folder=folder), [str(folder / "chosen")])
    assert os.path.isfile(found) and found.startswith(str(folder / "chosen"))


@pytest.mark.parametrize(
    "name", ["../outside.tif", "{folder}/outside.tif", "{folder}/chosen2/c.tif", "link.tif", "a\0.tif", "/etc/passwd"]
)
def test_a_file_anywhere_else_is_not(folder, name):
    assert named_file(name.format(folder=folder), [str(folder / "chosen")]) == ""


def test_a_file_that_was_chosen_itself_is_followed(folder):
    path = str(folder / "outside.tif")
    assert named_file(path, [str(folder / "chosen"), path]) == path
    assert named_file(path, []) == ""


@pytest.mark.parametrize("name", ELSEWHERE)
def test_names_elsewhere_are_not_looked_at(folder, name, monkeypatch):
    looked = []
    for function in ("stat", "lstat", "readlink"):
        known = getattr(os, function)
        monkeypatch.setattr(os, function, lambda path, *a, known=known, **k: (looked.append(str(path)), known(path))[1])
    named_file(name, [str(folder / "chosen")])
    assert [path for path in looked if not str(folder).startswith(path) and not path.startswith(str(folder))] == []


@pytest.mark.parametrize("name", ["../outside.tif", "{folder}/outside.tif", r"\\host\share\weights"])
def test_weights_of_a_model_outside_its_folder_count_as_missing(folder, name):
    name = name.format(folder=folder)
    model = str(folder / "chosen" / "model.onnx")
    assert OnnxHeader((name,)).missing_weights(model) == name
    assert OnnxHeader(("a.tif", "inner/b.tif")).missing_weights(model) == ""
