"""What QGIS writes down for workers has one answer, byte by byte, whatever happens to them."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import pytest
from built_database import NAMES
from clustered import lose_a_worker, require_nothing_after, wait_for
from made_inputs import scattered_objects, write_raster

from semref.core.assessment.assessment import Assessment
from semref.core.assessment.cells import ground_cells
from semref.core.assessment.job import AssessmentJob
from semref.core.evaluation.evaluation import TrialRanges
from semref.core.evaluation.job import EvaluationJob
from semref.core.geometry.camera import Camera
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.search import AskedImage, ImagesJob, Search
from semref.core.simulation.conditions import Conditions
from semref.core.simulation.noise import USUAL
from semref.storage.carried import read, write
from semref.storage.database.reader import read_database, read_stored_database
from semref.storage.file_states import fingerprint, state
from semref.storage.map_frames import label_map_frame
from semref.storage.rasters import GdalLabels

SIZE = 160
LABELS = scattered_objects(500, 600, 380, seed=7, background=0)
KINDS = ("images", "evaluation", "assessment")


@pytest.fixture(scope="module")
def orders(build_area, tmp_path_factory):
    """Path of the order of each kind."""
    folder = tmp_path_factory.mktemp("orders")
    database = build_area(LABELS, NAMES, SIZE, 40)
    made = {"images": images(database, folder), "evaluation": evaluation(database, folder)}
    made["assessment"] = assessment(database)
    known = {"database": fingerprint(read_database(database)), "files": {}}
    for kind, (job, pieces) in made.items():
        write(str(folder / f"{kind}.json"), (job, pieces, known))
    return {kind: folder / f"{kind}.json" for kind in made}


def images(database, folder):
    asked = []
    for n in range(9):
        labels = LABELS[20 * n : 20 * n + SIZE, 40 * n : 40 * n + SIZE]
        asked.append(AskedImage(str(write_raster(folder / f"{n}.png", labels, transform=None)), Camera()))
    asked.append(AskedImage(str(folder / "none.png"), Camera()))
    return ImagesJob(database, True, "", 1e-4, None, Search(Method.AUTOMATIC, with_matches=True)), asked


def evaluation(database, folder):
    path = str(write_raster(folder / "labels.tif", LABELS, names=NAMES))
    labels = GdalLabels(path)
    job = EvaluationJob(database, path, label_map_frame(labels, path), TrialRanges(), 3)
    planned = job.evaluation(read_database(database, with_overview=True), labels).trials(10, 3)
    return job, [(query, [Method.AUTOMATIC, Method.TOPOLOGY_VECTOR]) for query in planned]


def assessment(path):
    job = AssessmentJob(path, True, (SIZE, 120.0), Conditions(USUAL), 2, True)
    database = read_stored_database(path).database
    cells = ground_cells(database, 80.0)
    planned = [
        Assessment(database, Localizer(database), footprint, job.conditions, job.seed).plan(cells.centers, 80.0, 60)
        for footprint in job.footprints
    ]
    return job, planned


@pytest.fixture(scope="module")
def answers(cluster, orders, tmp_path_factory):
    """`answers(kind)`: the bytes that one worker's answer has."""
    folder, kept = tmp_path_factory.mktemp("found"), {}

    def answer(kind):
        if kind not in kept:
            result = cluster("order", orders[kind], "--found", folder / kind, "--local", 1)
            assert result.returncode == 0, result.stderr
            kept[kind] = (folder / kind).read_bytes()
        return kept[kind]

    return answer


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_two_workers_answer_as_one_does_though_one_of_them_is_killed(cluster, orders, answers, tmp_path, kind):
    running = cluster.start("order", orders[kind], "--found", tmp_path / "found.json", "--local", 2)
    lose_a_worker(running, "Localizing")
    assert (tmp_path / "found.json").read_bytes() == answers(kind)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_two_workers_answer_as_one_does(cluster, orders, answers, tmp_path, kind):
    result = cluster("order", orders[kind], "--found", tmp_path / "found.json", "--local", 2)
    assert result.returncode == 0, result.stderr
    assert (tmp_path / "found.json").read_bytes() == answers(kind)


def test_images_have_a_place_or_a_fault_each(answers, tmp_path):
    (tmp_path / "found.json").write_bytes(answers("images"))
    found = read(str(tmp_path / "found.json"))
    assert len(found) == 10 and sum(one.result is not None and one.result.is_fix for one in found) > 5
    assert found[0].result.matches is not None and found[0].shape_hw == (SIZE, SIZE)
    assert found[-1].result is None and "none.png" in str(found[-1].fault)


def test_trials_are_those_of_one_process(orders, answers, tmp_path):
    (tmp_path / "found.json").write_bytes(answers("evaluation"))
    found = read(str(tmp_path / "found.json"))
    job, jobs, _ = read(str(orders["evaluation"]))
    evaluation = job.evaluation(read_database(job.database, with_overview=True), GdalLabels(job.labels))
    for (query, methods), trials in zip(jobs, found):
        for trial, expected in zip(trials, evaluation.run(query, methods)):
            assert (trial.query, trial.method, trial.is_right) == (query, expected.method, expected.is_right)
            assert trial.error == pytest.approx(expected.error, rel=1e-6)
    assert sum(trial.is_right for trials in found for trial in trials) > 5


def test_simulated_images_are_those_of_one_process(orders, answers, tmp_path):
    (tmp_path / "found.json").write_bytes(answers("assessment"))
    found = read(str(tmp_path / "found.json"))
    job, planned, _ = read(str(orders["assessment"]))
    database = read_stored_database(job.database).database
    localizer = Localizer(database)
    for footprint, queries, (trials, correlated) in zip(job.footprints, planned, found):
        one = Assessment(database, localizer, footprint, job.conditions, job.seed)
        expected = [one.run(query) for query in queries[:10]]
        assert [trial.query for trial in trials] == queries
        assert [trial.status for trial in trials[:10]] == [trial.status for trial in expected]
        assert [trial.is_right for trial in trials[:10]] == [trial.is_right for trial in expected]
        failed = [number for number, trial in enumerate(trials) if not trial.is_fix]
        assert set(correlated) <= set(failed) and len(correlated) == min(len(failed), 7)
        assert all(correlated[n].query == queries[n] for n in correlated)


def test_an_interrupt_leaves_nothing(cluster, orders, tmp_path):
    running = cluster.start("order", orders["evaluation"], "--found", tmp_path / "never.json", "--local", 1)
    require_nothing_after("SIGINT", running, "Localizing", tmp_path)


def test_a_database_that_is_gone_is_said_in_one_sentence(cluster, orders, tmp_path):
    job, pieces, known = read(str(orders["images"]))
    write(
        str(tmp_path / "order.json"),
        (type(job)(str(tmp_path / "gone.gpkg"), *list(vars(job).values())[1:]), pieces, known),
    )
    result = cluster("order", tmp_path / "order.json", "--found", tmp_path / "found.json", "--local", 1)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == 3 and "gone.gpkg" in last and "Traceback" not in result.stderr
    assert not (tmp_path / "found.json").exists()


def test_an_order_is_not_replaced_by_its_answer(cluster, orders):
    before = orders["images"].read_bytes()
    result = cluster("order", orders["images"], "--found", orders["images"], "--local", 1)
    assert result.returncode == 2 and "would replace" in result.stderr
    assert orders["images"].read_bytes() == before


def test_a_database_that_is_changed_meanwhile_gives_no_answer(cluster, orders, tmp_path):
    job, pieces, known = read(str(orders["images"]))
    database = tmp_path / "area.gpkg"
    database.write_bytes(Path(job.database).read_bytes())
    write(str(tmp_path / "order.json"), (replace(job, database=str(database)), pieces, known))
    running = cluster.start("order", tmp_path / "order.json", "--found", tmp_path / "found.json", "--local", 1)
    wait_for(running, "Localizing")
    os.utime(database, (1, 1))
    _, errors = running.communicate(timeout=120)
    assert running.returncode != 0 and "was changed while it was read" in errors
    assert not (tmp_path / "found.json").exists()


@pytest.mark.parametrize("kind", KINDS)
def test_a_database_that_is_another_than_pieces_were_planned_by_gives_no_answer(cluster, orders, tmp_path, kind):
    job, pieces, known = read(str(orders[kind]))
    write(str(tmp_path / "order.json"), (job, pieces, {**known, "database": "0" * 64}))
    result = cluster("order", tmp_path / "order.json", "--found", tmp_path / "found.json", "--local", 1)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == 3 and "area.gpkg was changed while it was read" in last
    assert not (tmp_path / "found.json").exists()


def test_a_label_map_that_was_changed_before_it_begins_gives_no_answer(cluster, orders, tmp_path):
    job, pieces, known = read(str(orders["evaluation"]))
    size, moment = state(job.labels)
    files = {job.labels: (size, moment - 5)}
    write(str(tmp_path / "order.json"), (job, pieces, {**known, "files": files}))
    result = cluster("order", tmp_path / "order.json", "--found", tmp_path / "found.json", "--local", 1)
    last = result.stderr.strip().splitlines()[-1]
    assert result.returncode == 2 and "labels.tif was changed while it was read" in last
    assert not (tmp_path / "found.json").exists()
