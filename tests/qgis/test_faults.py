"""Faults injected by machine, a few of each kind: nothing is lost, nothing half, and the ending says which.

``python -m tools.faults`` injects hundreds; here is what CI can wait for.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="kills and full disks as Linux has them")

KILLED = ("describeimage", "updatedatabase in place")


@pytest.fixture(scope="module")
def faults(qgis_app, repository):
    """Modules of tools/faults, whatever else is called so."""
    folder = repository / "tools" / "faults"
    spec = importlib.util.spec_from_file_location(
        "semref_faults", folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    sys.modules["semref_faults"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sys.modules["semref_faults"])
    return [importlib.import_module(f"semref_faults.{name}") for name in ("cases", "readers", "trials", "writers")]


@pytest.fixture(scope="module")
def provider(qgis_app):
    from qgis.core import QgsApplication

    return QgsApplication.processingRegistry().providerById("semref")


def test_everything_that_writes_files_is_put_under_faults(faults, provider, tmp_path):
    cases = faults[0]
    found = cases.all_parameters(provider, tmp_path)
    writing = {a.name() for a in provider.algorithms() if any(p.isDestination() for p in a.parameterDefinitions())}
    assert {algorithm for algorithm, _ in found.values()} == writing - set(cases.LEFT_OUT)
    for name, (algorithm, parameters) in found.items():
        given = parameters("new", tmp_path)
        outputs = [p.name() for p in provider.algorithm(algorithm).parameterDefinitions() if p.isDestination()]
        assert set(outputs) <= set(given), name


def test_a_writer_without_inputs_is_an_error(faults, provider, tmp_path, monkeypatch):
    cases = faults[0]
    known = cases._given(tmp_path / "new")
    known.pop("describeimage")
    monkeypatch.setattr(cases, "_given", lambda _: known)
    with pytest.raises(KeyError, match="describeimage"):
        cases.all_parameters(provider, tmp_path)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_faults_lose_nothing_and_readers_see_one_state(faults, provider, tmp_path, monkeypatch):
    _, readers, trials, writers = faults
    monkeypatch.setattr(os, "fsync", lambda _: None)
    kills = 0
    plan = trials.Plan(kills=3, disks=1, most_steps=1, seed=7)
    for writer in writers.tried_writers(provider, tmp_path, list(KILLED)):
        row = trials.all_of(writer, tmp_path, plan)
        assert row.finds == []
        kills += row.counts.get("kills", 0)
        assert row.counts["two writers"] > 0 and row.counts["file limits"] > 0
    assert kills > 0 and row.counts["cancels"] > 0
    row = readers.read_while_updated(provider, tmp_path, 2)
    assert row.finds == []
    assert row.counts["whole reads"] > 0
