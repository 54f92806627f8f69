"""The example algorithm of CONTRIBUTING runs."""

import re
import textwrap

import numpy as np
from qgis.core import QgsProcessingContext


def test_the_algorithm_of_the_walk_counts_landmarks(repository, build_area, feedback, tmp_path):
    (example,) = re.findall(r"```python\n(.*?)```", (repository / "CONTRIBUTING.md").read_text("utf-8"), re.DOTALL)
    package = "semref.processing.algorithms"
    module = {"__name__": f"{package}.count_landmarks", "__package__": package}
    exec(compile(textwrap.dedent(example), "CONTRIBUTING.md", "exec"), module)
    labels = np.full((100, 100), 4, np.uint8)
    labels[10:20, 10:20] = labels[50:60, 30:42] = 1
    labels[70:90, 70:90] = 2
    area = build_area(labels, ["unlabeled", "building", "water", "bare_land", "field"], 50, 25)
    given = {"DATABASE": area, "OUTPUT": str(tmp_path / "count.txt")}
    results, succeeded = module["CountLandmarks"]().create().run(given, QgsProcessingContext(), feedback)
    assert succeeded, feedback.textLog()
    assert results == {"OUTPUT": given["OUTPUT"], "COUNT": 3}
    assert (tmp_path / "count.txt").read_text() == "3"
