"""The trained network keeps everything at its place.

torch lives in an environment of its own (tools/training/setup_training.sh), so a program run there gives the answers.
"""

import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]

PROGRAM = """
import json
import sys
sys.path.append("tools")
from plugin_package import load_plugin_package
load_plugin_package()
import torch
from semref.training.network import pyramid_attention_network

torch.manual_seed(1671)
torch.set_num_threads(1)
EDGE, MOVED, MARGIN = 512, 64, 192
network = pyramid_attention_network("tu-mobilenetv3_small_050", 5, 2, False).eval()
image = torch.rand(1, 3, EDGE, EDGE)
with torch.inference_mode():
    here, moved = network(image), network(torch.roll(image, (MOVED, MOVED), (2, 3)))
inside = slice(MARGIN + MOVED, EDGE - MARGIN + MOVED)
before = slice(MARGIN, EDGE - MARGIN)
difference = (moved[:, :, inside, inside] - here[:, :, before, before]).abs().max() / here.std()
print(json.dumps(float(difference)))
"""


def test_what_is_moved_in_a_tile_is_answered_moved_by_as_much(training_python):
    done = subprocess.run([str(training_python), "-c", PROGRAM], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    # The border of the tile affects all pixels slightly, through means over the whole tile.
    assert json.loads(done.stdout.splitlines()[-1]) < 0.02
