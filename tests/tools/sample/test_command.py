import subprocess
import sys

import pytest


@pytest.fixture
def run(repository):
    def command(*arguments: str) -> subprocess.CompletedProcess:
        whole = [sys.executable, "-m", "tools.sample", *arguments]
        return subprocess.run(whole, cwd=repository, capture_output=True, text=True, check=False)

    return command


def test_what_was_made_is_not_made_again(run, sample):
    made = (sample / "sample.json").stat().st_mtime_ns
    ended = run()
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "", "")
    assert (sample / "sample.json").stat().st_mtime_ns == made


def test_a_folder_with_other_files_is_left_alone(run, tmp_path):
    (tmp_path / "thesis.txt").write_text("years of work", encoding="utf-8")
    ended = run(str(tmp_path))
    assert ended.returncode == 1 and str(tmp_path) in ended.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


def test_another_area_needs_a_folder_of_its_own(run):
    ended = run("--seed", "5")
    assert ended.returncode == 2 and "choose a folder" in ended.stderr
