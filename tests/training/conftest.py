"""Run programs with the Python of the training environment, where torch is."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
START = """
import json, sys
sys.path.append("tools")
from plugin_package import load_plugin_package
load_plugin_package()
import torch
torch.manual_seed(1671)
torch.set_num_threads(1)
"""


@pytest.fixture(scope="session")
def with_torch(training_python):
    """`with_torch(program, *arguments)` runs a text that begins with semref and torch imported; returns the process."""

    def run(program, *arguments) -> subprocess.CompletedProcess:
        command = [str(training_python), "-c", START + program, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, cwd=ROOT)

    return run
