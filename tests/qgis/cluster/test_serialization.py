import json
import math

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.localization import Localization, Matches, Method, Place, Prior, Status
from semref.core.sentences import Sentence
from semref.storage.serialization import from_bytes, read, to_bytes, write

PLACE = Place((0.1 + 0.2, -1e300), math.pi)
VALUES = [
    *(None, True, -3, 1e-320, -math.inf, "ä “quoted” \n", b"\n\x00\xff", (b"", [b"a"], 1.5), ()),
    *([(1, 2.5), ["a", None]], {"a": (1,), 2: [3], (4, 5): "six"}),
    *(Method.TOPOLOGY_VECTOR, Status.NO_MATCH, Prior((1.5, 2.5), 30.0)),
    Sentence(
        "There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.",
        address="tcp://a:1",
        reason=Sentence("The image has no pixels."),
    ),
    Localization(Status.FIX, Method.CONSTELLATION, 7, best=PLACE, alternatives=(PLACE, PLACE), nadir=(1.0, 2.0)),
]
TASKS = 30


@pytest.mark.parametrize("value", VALUES, ids=str)
def test_a_value_comes_back_as_it_was(value):
    found = from_bytes(to_bytes(value))
    assert found == value and type(found) is type(value)


@pytest.mark.parametrize("kind", ["uint8", "<i8", ">f4", "bool", "complex128"])
def test_arrays_come_back_with_kind_shape_and_bits_and_may_be_changed(kind):
    array = np.arange(24).reshape(2, 3, 4).astype(kind)[:, ::2]
    found = from_bytes(to_bytes(array))
    assert found.dtype == array.dtype and found.shape == array.shape and (found == array).all()
    found[0] = 0
    number = from_bytes(to_bytes(array[0, 0, 1]))
    assert number == array[0, 0, 1] and type(number) is type(array[0, 0, 1])


def test_matches_travel_in_a_localization(tmp_path):
    matches = Matches(np.arange(3), np.ones((3, 2)), np.zeros((3, 2)), np.array([0.1, -np.inf, np.nan]))
    found = Localization(Status.FIX, Method.AUTOMATIC, error_95_m=math.nan, matches=matches)
    write(str(tmp_path / "found.json"), found)
    back = read(str(tmp_path / "found.json"))
    assert isinstance(back.matches, Matches) and back.matches.on_map.dtype == np.int64 and math.isnan(back.error_95_m)
    np.testing.assert_array_equal(back.matches.residuals, matches.residuals)


@pytest.mark.parametrize("value", [object(), ParameterError("The image has no pixels."), {1}, np.array([None]), Prior])
def test_other_values_are_refused(value):
    with pytest.raises(TypeError):
        to_bytes(value)


@pytest.mark.parametrize(
    "name", ["os:system", "core.errors:SemRefError", "core.localization:risk_of", "core..os:x", "subprocess:Popen"]
)
def test_nothing_but_core_s_values_is_restored(name):
    with pytest.raises(ValueError, match=name.partition(":")[0]):
        from_bytes(json.dumps({"object": [name, {}]}).encode() + b"\n")


class Future:
    def __init__(self, value):
        self.value = value

    def result(self):
        return "done", self.value

    def release(self):
        pass


class Client:
    """Client that returns every call's number; its workers change whenever they are counted."""

    def __init__(self, threads):
        self.threads = threads
        self.given = []

    def submit(self, function, *arguments, pure):
        if function.__name__ == "call":
            self.given.append(arguments[-1])
            return Future(arguments[-1])
        return Future(None)

    def nthreads(self):
        return {str(worker): 1 for worker in range(self.threads.pop(0) if len(self.threads) > 1 else self.threads[0])}


@pytest.mark.parametrize("threads", [[2, 1], [4, 0, 1], [1, 3, 2, 1]])
def test_results_come_in_order_whatever_workers_are_lost(threads, monkeypatch):
    pytest.importorskip("distributed", reason="Dask is not here (tools/requirements-dev.txt)")
    from semref.cluster import engine

    monkeypatch.setattr(engine, "_CHECK_EVERY_S", -1.0)
    runner = engine.DaskRunner(Client(list(threads)), "labels.tif")
    assert list(runner("task", ((number,) for number in range(TASKS)))) == [(n,) for n in range(TASKS)]
