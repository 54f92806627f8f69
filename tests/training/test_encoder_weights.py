import json

import pytest

SPREADS = (5.72209, 9.58228, 9.24016, 5.84669)
"""Standard deviation of the features at strides 2, 4, 8 and 16."""

PROGRAM = """
from pathlib import Path
from semref.training.network import load_encoder_weights, packaged_weights
from semref.training.network import pyramid_attention_network
from semref.core.errors import TrainingError

path = Path(sys.argv[1])

def encoder(name="tu-mobilenetv3_small_050"):
    return pyramid_attention_network(name, 5, 3, False).eval().encoder

def saved(weights):
    torch.save(weights, path)
    return path

lite0 = encoder("tu-tf_efficientnet_lite0")
load_encoder_weights(lite0, packaged_weights())
wave = torch.sin(torch.arange(96) / 7)
image = (wave[:, None] * wave[None]).expand(1, 3, 96, 96).contiguous()
with torch.inference_mode():
    spreads = [float(level.std()) for level in lite0(image)[1:5]]

first, second = encoder(), encoder()
own = first.state_dict()
plain = {name.removeprefix("model."): tensor for name, tensor in own.items()}
forms = (own, {**plain, "classifier.weight": torch.ones(2, 2)}, {f"other.{n}": t for n, t in enumerate(own.values())})
taken = []
for weights in forms:
    other = encoder()
    load_encoder_weights(other, saved(weights))
    taken.append(all(torch.equal(tensor, other.state_dict()[name]) for name, tensor in own.items()))

def refusal(file):
    try:
        load_encoder_weights(second, file)
    except TrainingError as error:
        return str(error)
    return "not refused"

lacking = dict(list(plain.items())[1:])
refusals = [refusal(saved(lacking)), refusal(packaged_weights()), refusal(saved([1, 2]))]
path.write_bytes(b"no weights")
refusals.append(refusal(path))
print(json.dumps({"spreads": spreads, "refusals": refusals, "taken": taken}))
"""


def test_weights_are_taken_by_name_with_or_without_prefix_or_by_order_or_refused(tmp_path, with_torch):
    done = with_torch(PROGRAM, tmp_path / "weights.pth")
    assert done.returncode == 0, done.stderr
    answers = json.loads(done.stdout.splitlines()[-1])
    assert answers["spreads"] == pytest.approx(SPREADS, rel=1e-3)
    another, none = "has the weights of another encoder", "has no torch weights"
    for said, part in zip(answers["refusals"], (another, another, none, none)):
        assert part in said
    assert answers["taken"] == [True, True, True]
