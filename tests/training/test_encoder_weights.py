"""Weights from a file for the encoder: all of it or none, and the same features as the network they were trained in.

torch lives in an environment of its own (tools/training/setup_training.sh), so a program run there gives the answers.
"""

import json
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

# EfficientNet-Lite0 as its paper and TensorFlow's code describe it, with efficientnet_lite_pytorch's names of tensors:
# kernel, stride, widening, channels, blocks of each stage.
PROGRAM = '''
import json
import sys
from pathlib import Path
sys.path.append("tools")
from plugin_package import load_plugin_package
load_plugin_package()
import torch
from torch.nn import functional as F
from semref.training.encoder_weights import load_encoder_weights
from semref.training.network import pyramid_attention_network
from semref.core.errors import TrainingError

STAGES = [(3, 1, 1, 16, 1), (3, 2, 6, 24, 2), (5, 2, 6, 40, 2), (3, 2, 6, 80, 3), (5, 1, 6, 112, 3), (5, 2, 6, 192, 4),
          (3, 1, 6, 320, 1)]
path = Path(sys.argv[1])
torch.manual_seed(1671)
torch.set_num_threads(1)

def weights():
    """Random ones for every tensor."""
    made = {}
    def convolution(name, out, per_group, kernel):
        made[name + ".weight"] = torch.randn(out, per_group, kernel, kernel) / (per_group * kernel * kernel) ** 0.5
    def norm(name, count):
        made[name + ".weight"], made[name + ".bias"] = 0.5 + torch.rand(count), torch.randn(count)
        made[name + ".running_mean"], made[name + ".running_var"] = torch.randn(count), 0.5 + torch.rand(count)
        made[name + ".num_batches_tracked"] = torch.tensor(7)
    convolution("_conv_stem", 32, 3, 3)
    norm("_bn0", 32)
    block, channels = 0, 32
    for kernel, _, widening, out, count in STAGES:
        for _ in range(count):
            name, wide = f"_blocks.{block}.", channels * widening
            if widening > 1:
                convolution(name + "_expand_conv", wide, channels, 1)
                norm(name + "_bn0", wide)
            convolution(name + "_depthwise_conv", wide, 1, kernel)
            norm(name + "_bn1", wide)
            convolution(name + "_project_conv", out, wide, 1)
            norm(name + "_bn2", out)
            block, channels = block + 1, out
    convolution("_conv_head", 1280, 320, 1)
    norm("_bn1", 1280)
    made["_fc.weight"], made["_fc.bias"] = torch.randn(1000, 1280), torch.randn(1000)
    return made

def features(w, x):
    """Outputs of stages 0, 1, 2 and 4, which an encoder hands on at strides 2, 4, 8 and 16."""
    def convolved(x, name, stride=1, groups=1):
        kernel, needed = w[name + ".weight"], 0
        size = kernel.shape[-1]
        if size > 1:  # TensorFlow's "same": what is missing is added, the odd pixel behind
            needed = max((-(-x.shape[-1] // stride) - 1) * stride + size - x.shape[-1], 0)
        x = F.pad(x, [needed // 2, needed - needed // 2] * 2)
        return F.conv2d(x, kernel, stride=stride, groups=groups)
    def normed(x, name):
        return F.batch_norm(x, *(w[f"{name}.{key}"] for key in ("running_mean", "running_var", "weight", "bias")),
                            eps=1e-3)
    x = F.relu6(normed(convolved(x, "_conv_stem", 2), "_bn0"))
    block, kept = 0, []
    for stage, (_, stride, widening, _, count) in enumerate(STAGES):
        for index in range(count):
            name, y = f"_blocks.{block}.", x
            if widening > 1:
                y = F.relu6(normed(convolved(y, name + "_expand_conv"), name + "_bn0"))
            y = convolved(y, name + "_depthwise_conv", stride if index == 0 else 1, y.shape[1])
            y = F.relu6(normed(y, name + "_bn1"))
            y = normed(convolved(y, name + "_project_conv"), name + "_bn2")
            x = x + y if index else y
            block += 1
        if stage in (0, 1, 2, 4):
            kept.append(x)
    return kept

def network(name="tu-tf_efficientnet_lite0"):
    return pyramid_attention_network(name, 5, 3, False).eval()

given = weights()
torch.save(given, path)
net = network()
load_encoder_weights(net.encoder, path)
image = torch.rand(1, 3, 96, 96) * 2 - 1
with torch.inference_mode():
    pairs = zip(features(given, image), net.encoder(image)[1:5])
differences = [float((one - other).abs().max() / one.abs().max()) for one, other in pairs]

def refusal(given, net):
    torch.save(given, path)
    before = {name: tensor.clone() for name, tensor in net.encoder.state_dict().items()}
    try:
        load_encoder_weights(net.encoder, path)
    except TrainingError as error:
        assert all(torch.equal(before[name], tensor) for name, tensor in net.encoder.state_dict().items())
        return str(error)
    return "not refused"

refusals = [
    refusal({name: value for name, value in given.items() if name != "_blocks.7._bn2.bias"}, net),
    refusal({**given, "_conv_stem.weight": torch.ones(32, 1, 3, 3)}, net),
    refusal([1, 2], net),
]
first, second = network("tu-mobilenetv3_small_050"), network("tu-mobilenetv3_small_050")
refusals.append(refusal(given, first))
path.write_bytes(b"no weights")
try:
    load_encoder_weights(first.encoder, path)
except TrainingError as error:
    refusals.append(str(error))

own = {name.removeprefix("model."): torch.randn(tensor.shape).to(tensor.dtype)
       for name, tensor in first.encoder.state_dict().items()}
torch.save({**own, "classifier.weight": torch.ones(2, 2)}, path)
load_encoder_weights(first.encoder, path)
taken = [all(torch.equal(own[name.removeprefix("model.")], t) for name, t in first.encoder.state_dict().items())]
torch.save(first.encoder.state_dict(), path)
load_encoder_weights(second.encoder, path)
taken.append(all(torch.equal(t, second.encoder.state_dict()[name]) for name, t in first.encoder.state_dict().items()))
print(json.dumps({"differences": differences, "refusals": refusals, "taken": taken}))
'''


@pytest.fixture(scope="module")
def answers(tmp_path_factory, training_python):
    command = [str(training_python), "-c", PROGRAM, str(tmp_path_factory.mktemp("weights") / "weights.pth")]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def test_mapped_weights_give_the_features_of_the_network_they_come_from(answers):
    assert len(answers["differences"]) == 4
    assert max(answers["differences"]) < 1e-4


def test_weights_that_do_not_fill_the_encoder_are_refused_and_change_nothing(answers):
    expected = ("is of another encoder", "is of another encoder", "holds no weights of torch")
    expected += ("is of another encoder", "holds no weights of torch")
    assert len(answers["refusals"]) == len(expected)
    for said, part in zip(answers["refusals"], expected):
        assert part in said


def test_weights_with_the_encoders_own_names_are_taken_with_or_without_its_prefix(answers):
    assert answers["taken"] == [True, True]
