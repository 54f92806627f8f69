"""A short seeded run of tools/fuzz: each input gives a valid result or one sentence, and changes no other file."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LONGEST_S = 900

pytest.importorskip("hypothesis")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="fuzzing limits memory as Linux lets it")


def fuzz(*arguments):
    """Return (exit status, output of ``python -m tools.fuzz``)."""
    command = [sys.executable, "-m", "tools.fuzz", *arguments]
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=LONGEST_S)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.slow
def test_every_reader_keeps_its_contract():
    status, said = fuzz("--examples", "60", "--seed", "3")
    assert status == 0, said
    assert len(said.splitlines()) == 16


@pytest.mark.parametrize(("seed", "outcomes"), [(1, ("KeyError", "Broken", "MemoryError"))])
def test_what_breaks_the_contract_is_found(seed, outcomes):
    status, said = fuzz("--examples", "40", "--reader", "faulty", "--seed", str(seed))
    assert status == 1 and any(outcome in said for outcome in outcomes), said


def test_a_process_that_dies_is_reported_with_its_input():
    status, said = fuzz("--examples", "40", "--reader", "dying")
    assert status == 1 and "exit status -9 at 5" in said, said
