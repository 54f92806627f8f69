"""A short seeded run of tools/fuzz: for every input of every door a valid result or one sentence, nothing else touched.

The long run is `python -m tools.fuzz`; what it finds becomes a test of its own where it is mended.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import signal
import socket
import sys
from pathlib import Path

import pytest

from semref.core.errors import ImageError, SemRefError

TOOLS = Path(__file__).resolve().parents[2] / "tools"
# qgis_session, which the doors of QGIS need.
sys.path.append(str(TOOLS))
if sys.platform != "linux":
    pytest.skip("fuzzing limits memory as Linux lets it", allow_module_level=True)
if not os.environ.get("SEMREF_FUZZ"):
    # Each batch is forked, which a process that other tests have filled with threads doesn't survive.
    pytest.skip("runs in a process of its own: test_fuzz_alone.py", allow_module_level=True)

INPUTS = {
    **dict.fromkeys(("classes", "cameras", "plans", "waypoints", "parameters", "keys", "metadata"), 150),
    **dict.fromkeys(("labels_on_board", "photos_on_board", "label_maps", "label_images", "photos", "route_layers"), 60),
    **dict.fromkeys(("onboard", "command_line", "odometry", "logs"), 25),
    **dict.fromkeys(("databases", "flipped_bits", "watched", "flight_state"), 10),
}
IN_QGIS = {"layers": 4, "algorithms": 4, "projects": 30}
NATIVE = {"networks"}
"""A damaged network can bring onnxruntime down."""


def load(module):
    """A module of tools/fuzz; under a name that no folder has by chance."""
    if "semref_fuzz" not in sys.modules:
        folder = TOOLS / "fuzz"
        spec = importlib.util.spec_from_file_location(
            "semref_fuzz", folder / "__init__.py", submodule_search_locations=[str(folder)]
        )
        sys.modules["semref_fuzz"] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules["semref_fuzz"])
    return importlib.import_module(f"semref_fuzz.{module}")


@pytest.fixture(scope="module")
def doors(qgis_app):
    return {door.name: door for door in load("doors.all").DOORS}


def test_every_door_is_tried(doors):
    assert set(doors) == {*INPUTS, *IN_QGIS, *NATIVE}
    assert sum(door.inputs for door in doors.values()) >= 1_000_000


@pytest.mark.parametrize("name", INPUTS)
def test_the_contract_holds(doors, name, capfd):
    tally = load("runner").run(doors[name], seed=3, count=INPUTS[name])
    assert (tally.finds, tally.inputs) == ({}, INPUTS[name])


@pytest.mark.parametrize("name", IN_QGIS)
def test_the_contract_holds_in_qgis(doors, name, tmp_path, monkeypatch):
    contract, runner = load("contract"), load("runner")
    world = contract.World.made(tmp_path / "world")
    monkeypatch.chdir(tmp_path)
    make, attempt = doors[name].prepare(world)
    world.forget()
    for number in range(IN_QGIS[name]):
        verdict = contract.tried(attempt, make(runner.random_of(3, doors[name], number)), world, (SemRefError,))
        assert verdict.outcome in (contract.ACCEPTED, contract.REFUSED), verdict.told
    world.listener.close()


def test_what_breaks_the_contract_is_found(doors, tmp_path):
    """Faults of each kind, in place of a reader: the run must tell them."""
    contract, door, runner = (load(name) for name in ("contract", "door", "runner"))

    def prepare(world):
        def attempt(number):
            faults = (
                lambda: {}["missing"],
                lambda: world.secret.read_text(encoding="ascii"),
                lambda: (world.folder / "stray").write_text("x", encoding="ascii"),
                lambda: bytearray(4 << 30),
                lambda: socket.create_connection(world.listener.getsockname()),
            )
            if number < len(faults):
                faults[number]()
            elif number == len(faults):
                raise ImageError("labels.no_pixels")

        numbers = iter(range(100))
        return lambda random: next(numbers), attempt

    faulty = door.Door("faulty", "made for this test", prepare, 0, batch=1000)
    tally = runner.run(faulty, seed=1, count=7, told=lambda text: None)
    found = sorted(name.split(" ", 1)[0] for name in tally.finds)
    assert found == ["Broken", "Broken", "Broken", "KeyError", "MemoryError"]
    assert (tally.outcomes[contract.REFUSED], tally.outcomes[contract.ACCEPTED]) == (1, 1)


def test_a_process_that_dies_is_told_with_its_input(doors):
    door, runner = (load(name) for name in ("door", "runner"))

    def prepare(world):
        def attempt(number):
            if number == 5:
                os.kill(os.getpid(), signal.SIGKILL)

        return lambda random: next(numbers), attempt

    numbers = iter(range(100))
    tally = runner.run(door.Door("dying", "made for this test", prepare, 0), seed=1, count=8, told=lambda text: None)
    assert tally.finds == {"Died signal SIGKILL": [5, "signal SIGKILL"]}
    assert (tally.inputs, tally.broken) == (8, 1)
