import json

PROGRAM = """
from semref.training.network import pyramid_attention_network

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


def test_what_is_moved_in_a_tile_is_answered_moved_by_as_much(with_torch):
    done = with_torch(PROGRAM)
    assert done.returncode == 0, done.stderr
    # The border of the tile affects all pixels slightly, through means over the whole tile.
    assert json.loads(done.stdout.splitlines()[-1]) < 0.02
