"""A replacement for the training environment: it answers like the training and copies a finished model."""

import sys
from pathlib import Path

# The first line can't name a path with a space, so sh reads the second line; for Python it is a text.
TRAINER = """\
#!/bin/sh
'''exec' "{python}" "$0" "$@"
' '''
import json, os, shutil, sys, time
os.setpgrp()  # As in program.py.
def tell(event, **values):
    print(json.dumps({{"event": event, **values}}), flush=True)
if len(sys.argv) == 3:
    {ready}
    sys.exit(0)
job = json.load(open(sys.argv[3]))
folder, tested = job["folder"], 1
row = {{"epoch": 1, "training_loss": 1.5, "mean_iou": 0.4, "iou_building": 0.5, "iou_water": 0.3,
        "learning_rate": "1e-3", "seconds": 1.0}}
tell("begun", device="CPU", training=7, validation=2, weights=300000, class_weights=[0, 1])
print("a library says something", flush=True)
{training}
shutil.copy({model!r}, job["output"])
classes = [dict(value=n, name=name, color="#3366cc", role="reference")
           for n, name in enumerate(["unlabeled", "building", "water"])]
json.dump(dict(classes=classes, history=[row, {{**row, "epoch": 2}}], best_epoch=2, mean_iou=0.4, seconds=60,
               stopped_by="minutes",
               confusion=[[0, 0, 0], [0, 90 * tested, 10 * tested], [0, 20 * tested, 80 * tested]], device="CPU",
               training=7, validation=2, bytes=10 ** 6, difference=0.0, encoder="x", depth=5),
          open(os.path.join(folder, "result.json"), "w"))
tell("done", best_epoch=2)
"""
READY = 'tell("ready", torch="2.0", device="CPU")'
EPOCH = (
    'open(os.path.join(folder, "last.pt"), "w").close(); tell("step", share=0.2, epoch=1, loss=1.5); '
    'tell("epoch", share=0.5, **row)'
)


def write_trainer(path: Path, model: Path, training: str = EPOCH, ready: str = READY) -> Path:
    """Write the program; ``training`` and ``ready`` are Python code for a job and for the check."""
    path.write_text(TRAINER.format(python=sys.executable, ready=ready, training=training, model=str(model)))
    path.chmod(0o755)
    return path
