"""``evaluate``: how well a database localizes, by many workers, as ``semref:evaluatelocalization`` tells it in JSON."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path
from typing import Any

from ..core.errors import ParameterError
from ..core.evaluation.as_json import evaluation_json
from ..core.evaluation.evaluation import TrialRanges
from ..core.evaluation.job import EvaluationJob
from ..core.evaluation.offered import OFFERED, ORDER
from ..core.evaluation.plan import planned
from ..core.evaluation.summary import summarize
from ..core.localization import Method
from ..storage.database.reader import read_database
from ..storage.file_states import fingerprint
from ..storage.files import written_beside
from ..storage.map_frames import label_map_frame, require_classes_of, require_crs_of
from ..storage.rasters import GdalLabels
from .engine import DaskRunner, connected
from .inputs import Teller, require_apart, require_unchanged, seen_by_workers, state
from .order import answered


def evaluate(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Evaluates the database that the command line asks for.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        What came of it, by name; of the first method.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    database_path, path = seen_by_workers(options.database), seen_by_workers(options.labels)
    read = database_path, path
    for given in read:
        require_apart(given, options.output)
    methods, ranges = _methods(options.methods), _ranges(options)
    before = {given: state(given) for given in read}
    database, labels = read_database(database_path, with_overview=True), GdalLabels(path)
    frame = label_map_frame(labels, path)
    require_crs_of(frame, database.parameters.crs, path)
    require_classes_of(labels, database.class_table, path)
    job = EvaluationJob(
        database_path, path, frame, ranges, options.seed, options.minimum_references, options.right_within
    )
    evaluation = job.evaluation(database, labels)
    for method in methods:
        evaluation.localizer.check(method)
    pieces = planned(evaluation, methods, options.trials, options.mirrored / 100, True)
    with written_beside(str(Path(options.output).absolute())) as temporary:
        with connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
            tried = answered(job, pieces, DaskRunner(client, ""), teller, fingerprint(database))
        require_unchanged(before)
        trials = [trial for of_image in tried for trial in of_image]
        text = evaluation_json(trials, methods, _settings(options, ranges), evaluation.tried_windows)
        Path(temporary).write_bytes(text.encode("utf-8"))
    first = summarize(trials, methods[0])
    return {
        "output": options.output,
        "method": methods[0].key,
        "success_rate": first.right.share,
        "median_error": first.median_error,
        "false_accept_rate": first.false_accepts.share,
    }


def _methods(text: str) -> list[Method]:
    """The methods that are named, the most important first."""
    known = {method.key.replace(" ", "-"): method for method in Method}
    asked = [part.strip() for part in text.split(";") if part.strip()]
    for name in asked:
        if name not in known:
            raise ParameterError("cluster.no_method", name=name, known=tuple(known))
    if not asked:
        raise ParameterError("cluster.no_method", name=text, known=tuple(known))
    return [method for method in ORDER if method in [known[name] for name in asked]]


def _ranges(options: Namespace) -> TrialRanges:
    """What images draw their values from. Raises ParameterError."""
    found = {}
    for name, usual in OFFERED.items():
        text = getattr(options, name)
        if text is None:
            found[name] = usual
            continue
        try:
            low, high = (float(part) for part in text.split(","))
        except ValueError:
            raise ParameterError("cluster.no_range", option=f"--{name}", text=text) from None
        found[name] = low, high
    return TrialRanges(**found)


def _settings(options: Namespace, ranges: TrialRanges) -> dict[str, Any]:
    """As the algorithm tells them."""
    return {
        "DATABASE": Path(options.database).name,
        "LABELS": Path(options.labels).name,
        "TRIALS": options.trials,
        "MIRRORED": options.mirrored,
        **{name.upper(): list(limits) for name, limits in vars(ranges).items()},
        "MINIMUM_REFERENCES": options.minimum_references,
        "RIGHT_WITHIN": options.right_within,
        "SEED": options.seed,
    }
