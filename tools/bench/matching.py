"""Matching one query with all windows of a database, against one plain numpy norm; and reading the database."""

from __future__ import annotations

import time

import numpy as np

from bench import inputs, page, sizes, timing

PAGE = "benchmarks.md"
QUERIES = 20
SEED = 1671


def measure(run: inputs.Run) -> dict[str, str]:
    from semref.storage.database.reader import read_database

    rows = []
    for path in _databases(run):
        database = read_database(str(path))
        vectors = database.windows.vectors
        rng = np.random.default_rng(SEED)
        queries = rng.random((QUERIES, vectors.shape[1])).astype(np.float32)
        seconds = timing.take_turns(
            {
                "semref": lambda: _time_ours(queries, vectors),
                "norm": lambda: _time_norm(queries, vectors),
                "reading": lambda: _time(lambda: read_database(str(path))),
            },
            run.repetitions,
        )
        rows.append(
            [
                f"{len(vectors):,}",
                f"{int(database.windows.described.sum()):,}",
                timing.ratios(seconds["semref"], seconds["norm"]).text(),
                f"{1e3 * np.median(seconds['semref']):.3g}",
                f"{np.median(seconds['reading']):.3g}",
                f"{_largest_difference(queries, vectors):.0e}",
            ]
        )
    header = ["windows", "with vector", "× numpy norm", "ms a query", "s reading", "largest difference"]
    return {"matching": f"{_ABOUT.format(queries=QUERIES, turns=run.repetitions)}\n\n{page.table(header, rows)}"}


_ABOUT = """\
`core.matching.vector_distances` of one query to the vectors of all windows, against
`np.linalg.norm(vectors - query, axis=1)` on the same arrays: median (least–most) of the ratio over {turns} turns of
{queries} queries. Ours computes in double precision, numpy here in single. Reading: `read_database`, everything but
the overview."""


def _databases(run: inputs.Run):
    yield sizes.paper_database(run)
    yield run.database(run.area.stride)
    if not run.quick:
        yield run.database(run.area.dense_stride)


def _time_ours(queries: np.ndarray, vectors: np.ndarray) -> float:
    from semref.core.windows.matching import vector_distances

    return _time(lambda: [vector_distances(query, vectors).argmin() for query in queries]) / len(queries)


def _time_norm(queries: np.ndarray, vectors: np.ndarray) -> float:
    return _time(lambda: [np.linalg.norm(vectors - query, axis=1).argmin() for query in queries]) / len(queries)


def _time(work) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def _largest_difference(queries: np.ndarray, vectors: np.ndarray) -> float:
    from semref.core.windows.matching import vector_distances

    exact = np.linalg.norm(vectors.astype(np.float64) - queries[0].astype(np.float64), axis=1)
    return float(np.abs(vector_distances(queries[0], vectors) - exact).max())
