"""Tasks are submitted ahead, while workers come and go."""

import pytest

TASKS = 30


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
    assert list(runner.in_order("task", ((number,) for number in range(TASKS)))) == [(n,) for n in range(TASKS)]
