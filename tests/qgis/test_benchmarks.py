"""``python -m benchmarks``, from a map to a table, on the sample area."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def shown(tmp_path, *arguments):
    """Return the output of ``python -m benchmarks run``."""
    options = ["--work", str(tmp_path), "--data", str(tmp_path / "nothing")]
    command = [sys.executable, "-m", "benchmarks", "run", *arguments, *options]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "DISPLAY": ""}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd=ROOT, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_accuracy_goes_from_the_map_to_the_table_and_goes_on(tmp_path):
    row = "sample area, 20 / 20 / 5 %"
    assert f"|{row}|1/1, " in shown(tmp_path, "localization", "--only", row, "--count", "1")
    kept = next((tmp_path / "records").glob("localization_*.jsonl"))
    assert len(kept.read_text(encoding="utf-8").splitlines()) == 2
    assert f"|{row}|2/2, " in shown(tmp_path, "localization", "--only", row, "--count", "2")
    assert len(kept.read_text(encoding="utf-8").splitlines()) == 3


@pytest.mark.parametrize("part", [(0.0, 0.5), (0.5, 1.0)])
def test_crops_of_a_half_show_nothing_of_the_other(part):
    sys.path.append(str(ROOT / "tools"))
    from plugin_package import load_plugin_package

    load_plugin_package()
    from benchmarks.ground import Wanted, memory_ground
    from benchmarks.photos import BUILDINGS_ONLY, Photos

    blocks = np.random.default_rng(5).integers(1, 3, (20, 30))
    labels = np.kron(blocks, np.ones((30, 30))).astype(np.uint8)
    ground = memory_ground(labels, BUILDINGS_ONLY, (64, 16, 3.75), 0.25)
    wanted = Wanted((0.9, 1.1), landmarks=(0, 10**9), sizes_px=(256,), is_inside=True)
    columns = tuple(round(900 * share) for share in part)
    place = Photos(ground, np.zeros((600, 900, 3), np.uint8), None, wanted, None, columns)
    rng = np.random.default_rng(3)
    for number in range(8):
        view = place.image(rng, number).view
        turned = np.radians(45 + view.heading_deg + 90 * np.arange(4))
        reach = view.footprint * np.sqrt(0.5) / 0.25
        across = ground.frame.to_pixels(view.position)[0] + reach * np.sin(turned)
        assert across.min() >= columns[0] - 1 and across.max() <= columns[1] + 1
