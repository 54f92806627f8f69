"""Images that workers localize get the records of `python -m core localize`, in its order."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
from onboard_area import HERE, MAP, NOTHING, SIZE, write_area

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("images")
    write_area(str(folder / "area.npz"))
    for n, column in enumerate(range(0, 500, 100)):
        cv2.imwrite(str(folder / f"image_{n}.png"), np.ascontiguousarray(MAP[100 : 100 + SIZE, column : column + SIZE]))
    cv2.imwrite(str(folder / "here.png"), HERE)
    cv2.imwrite(str(folder / "nothing.png"), NOTHING)
    return folder


def core(folder, *arguments):
    order = [sys.executable, "-m", "core", "localize", str(folder), "--database", str(folder / "area.npz"), *arguments]
    # As in Dask's workers: with more threads OpenBLAS adds in another order, which shows in the last digits.
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
    return subprocess.run(order, cwd=ROOT, capture_output=True, text=True, check=False, env=environment)


@pytest.mark.parametrize("arguments", [["--json"], ["--method", "constellation"]])
def test_records_order_and_exit_code_are_those_of_one_process(cluster, folder, arguments):
    expected = core(folder, *arguments)
    found = cluster("localize", folder, "--database", folder / "area.npz", *arguments, "--local", 2)
    assert len(expected.stdout.splitlines()) == 7 and expected.returncode == 1
    assert found.stdout == expected.stdout, found.stderr
    assert found.returncode == expected.returncode


def test_a_database_that_is_none_is_refused_in_one_sentence(cluster, folder):
    result = cluster("localize", folder / "here.png", "--database", folder / "nothing.png", "--local", 1)
    assert result.returncode == 3 and result.stdout == ""
    assert "Traceback" not in result.stderr and result.stderr.strip().splitlines()[-1].startswith("cluster: ")


def test_an_option_that_neither_knows_is_refused_before_any_work(cluster, folder):
    result = cluster("localize", folder / "here.png", "--database", folder / "area.npz", "--nonsense", "--local", 1)
    assert result.returncode == 2 and "--nonsense" in result.stderr
