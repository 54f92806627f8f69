import re
import subprocess
import sys

import cv2
import numpy as np
import pytest
from made_models import NAMES, brightest_color, metadata, write_model
from onboard_area import CENTER, FRAME, HERE, MAP, SIZE, TABLE, write_area

from semref import core
from semref.core.database.build import BuildSettings


@pytest.fixture(scope="module")
def database():
    settings = BuildSettings(200.0, 100.0, minimum_area=30.0)
    return core.build_database(MAP, TABLE, FRAME.pixel_size, FRAME.origin, settings=settings)


def test_the_example_of_the_readme_runs(repository, tmp_path, monkeypatch, capsys):
    (example,) = re.findall(r"```python\n(.*?)```", (repository / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    write_area(str(tmp_path / "area.npz"))
    cv2.imwrite(str(tmp_path / "image.png"), HERE)
    monkeypatch.chdir(tmp_path)
    exec(compile(example, "README.md", "exec"), {})
    assert capsys.readouterr().out.startswith("fix (6002")


def test_importing_the_package_loads_no_module(repository):
    program = "import core, sys; print({'numpy', 'cv2', 'core.api'} & set(sys.modules), core.localize.__module__)"
    done = subprocess.run([sys.executable, "-c", program], cwd=repository, capture_output=True, text=True, check=True)
    assert done.stdout == "set() core.api\n"


def test_all_public_functions_are_documented():
    assert all("Args:" in getattr(core, name).__doc__ for name in core.__all__)
    with pytest.raises(AttributeError, match="nothing_like_that"):
        _ = core.nothing_like_that


def test_a_database_is_built_saved_and_opened(database, tmp_path):
    core.save_database(database, str(tmp_path / "area.npz"))
    opened = core.open_database(str(tmp_path / "area.npz"))
    assert len(opened.references) == len(database.references) and opened.overview is not None


def test_files_and_arrays_are_localized_alike(database, tmp_path):
    path = str(tmp_path / "here.png")
    cv2.imwrite(path, HERE)
    of_file, of_array = core.localize([path, HERE], database, method="constellation", sun_deg=150.0)
    assert of_file == of_array and of_file.position == pytest.approx(CENTER, abs=1)
    with pytest.raises(ValueError, match="topology vector"):
        core.localize([HERE], database, method="by chance")
    with pytest.raises(ValueError, match="need a model"):
        core.localize([np.zeros((9, 9, 3), np.uint8)], database)


def test_a_photo_is_segmented_by_the_classes_of_a_table(tmp_path):
    photo = np.zeros((40, 50, 3), np.uint8)
    photo[..., 0], photo[:, 25:, 1] = 100, 200
    model = str(write_model(tmp_path / "m.onnx", brightest_color(3), metadata=metadata()))
    (tmp_path / "t.csv").write_text("value,name\n" + "".join(f"{7 + n},{name}\n" for n, name in enumerate(NAMES)))
    table = core.read_class_table(str(tmp_path / "t.csv"))
    own, labels = core.segment(photo, model), core.segment(photo, model, table)
    assert labels.shape == (40, 50) and sorted(np.unique(labels)) == [7, 9] and len(np.unique(own)) == 2


@pytest.mark.slow
def test_the_images_of_a_flight_are_localized_together(database):
    images = [np.ascontiguousarray(MAP[row : row + SIZE, 150 : 150 + SIZE]) for row in (200, 230, 260)]
    found = core.localize_flight(images, database)
    assert [image.is_fix for image in found] == [True] * 3
    assert found[0].position[1] - found[2].position[1] == pytest.approx(60 * FRAME.pixel_size, abs=2)


def test_an_evaluation_counts_what_is_found(database):
    found = core.evaluate(database, MAP, "constellation", count=5)
    assert found.right.trials == 5 and found.wrong.successes == 0
    with pytest.raises(ValueError, match="shape"):
        core.evaluate(database, MAP[1:])
