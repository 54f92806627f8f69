"""Times of map correlation over the whole country and within 1 km of a prior: tools/measure_correlation.py times."""

from __future__ import annotations

import os
import subprocess
import sys

from bench import inputs

PAGE = "benchmarks.md"
COUNT = 12
QUICK_COUNT = 1


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"map correlation times": "Not measured: the real data is not here."}
    command = [sys.executable, str(inputs.TOOLS / "measure_correlation.py"), "times"]
    command += ["--trials", str(run.how_many(COUNT, QUICK_COUNT))]
    environment = {**os.environ, "SEMREF_DATA": str(run.data)}
    found = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
    return {"map correlation times": f"{_ABOUT}\n\n{found.stdout.strip()}"}


_ABOUT = "Goal with two cores: ≤ 2 s over 300 km², ≤ 0.3 s within 1 km of a prior."
