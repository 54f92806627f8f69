"""The parts of .ci/run: two at a time, printed in order, with a failing exit status."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = str(ROOT / "tools" / "side_by_side.sh")
WITHIN_S = 60


def run(*arguments: str) -> subprocess.CompletedProcess:
    command = ["bash", SCRIPT, *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=WITHIN_S, check=False)


def test_lanes_run_at_the_same_time_and_are_printed_in_order(tmp_path):
    """Each waits for the other, so in sequence they would never end."""
    first = f"first: until [ -e {tmp_path}/b ]; do sleep 0.1; done; echo one; touch {tmp_path}/a"
    second = f"second: echo two; touch {tmp_path}/b; until [ -e {tmp_path}/a ]; do sleep 0.1; done; echo three >&2"
    done = run(first, "last: echo four", "--", second)
    printed = [line for line in done.stdout.splitlines() if " s  " not in line]
    assert printed == ["=== first", "one", "=== last", "four", "=== second", "two", "three", "=== All"]
    assert done.returncode == 0 and done.stdout.count("passed") == 3


def test_one_that_fails_is_named_and_the_others_run_all_the_same():
    done = run("bad: echo begun; exit 3", "next: echo next", "--", "other: echo other")
    assert done.returncode == 1
    assert "FAILED: bad" in done.stderr and "FAILED (3)" in done.stdout
    assert {"begun", "next", "other"} <= set(done.stdout.splitlines())


def test_a_lane_that_is_killed_is_a_failure():
    done = run("killed: kill -9 $PPID", "never: echo never", "--", "other: echo other")
    assert done.returncode == 1
    assert "FAILED: killed\nFAILED: never" in done.stderr


def test_ci_runs_the_command_of_the_readme():
    assert "bash tools/test.sh" in (ROOT / "README.md").read_text(encoding="utf-8")
    assert ': bash tools/test.sh"' in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
