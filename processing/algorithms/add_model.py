"""semref:addmodel: make a model of SemRef from a network of others."""

from __future__ import annotations

import json
import os
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

from ...core.errors import ModelError
from ...core.segmentation.devices import CPU
from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, cancelable
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE
from ..packages.components import NEEDED, ONNXRUNTIME
from ..threads import worker_threads
from ..translation import tr

if TYPE_CHECKING:
    from ...core.segmentation.network_facts import NetworkFacts

NO_PRESET, FLAIR_PRESET, BUILDINGS_PRESET = range(3)
FROM_0_TO_1, FROM_0_TO_255 = range(2)
CHECKPOINTS = (".pt", ".pth", ".ckpt")
SEPARATOR = ";"


class AddModel(SemRefAlgorithm):
    ID = "addmodel"
    TITLE = "Add model"
    GROUP = ANNOTATION
    TAGS = ("model", "network", "onnx", "checkpoint", "pytorch", "segmentation", "import", "deepness", "flair")
    PACKAGES = (*NEEDED, ONNXRUNTIME)
    SUMMARY = (
        "Makes a model from a segmentation network of others: an ONNX file, or a checkpoint of "
        "segmentation_models_pytorch.\n\nThe result is a copy with class names, resolution, standardization and "
        "license. Outputs of the same class are merged: their probabilities are added after a softmax over all "
        "used outputs. A checkpoint needs the training environment (Settings ▸ Options ▸ SemRef)."
    )

    PRESET = "PRESET"
    CLASSES = "CLASSES"
    PIXEL_VALUES = "PIXEL_VALUES"
    MEAN = "MEAN"
    STANDARD_DEVIATION = "STANDARD_DEVIATION"
    THRESHOLD = "THRESHOLD"
    LICENSE = "LICENSE"
    NAME = "NAME"
    ARCHITECTURE = "ARCHITECTURE"
    ENCODER = "ENCODER"
    CLASS_COUNT = "CLASS_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterFile(
                    self.INPUT, "Network", fileFilter=tr("Networks") + " (*.onnx *.pt *.pth *.ckpt)"
                ),
                "ONNX file with input 1 × 3 × height × width and an output for each class, or a checkpoint with "
                "the weights of such a network.",
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.PRESET,
                    "Preset",
                    options=(
                        tr("None"),
                        tr("FLAIR-INC RGB of IGN, 19 outputs"),
                        tr("Buildings, one output with a threshold"),
                    ),
                    defaultValue=NO_PRESET,
                ),
                "Values for all fields that are not set. Without a preset, those in the metadata of the file.",
            ),
            with_help(
                QgsProcessingParameterString(self.CLASSES, "Class of each output", optional=True),
                "Names in the order of the outputs, separated by “;”. Outputs with the same name are merged. Leave "
                "a name empty for an output that is not used, for example building;road;;road.",
            ),
            parameters.resolution("Pixel size of the images that the network was trained on.", advanced=False),
            with_help(
                QgsProcessingParameterEnum(
                    self.PIXEL_VALUES,
                    "Pixel values",
                    options=(tr("from 0 to 1"), tr("from 0 to 255")),
                    defaultValue=FROM_0_TO_1,
                ),
                "Range of the pixel values before the mean is subtracted and the result is divided.",
            ),
            with_help(
                QgsProcessingParameterString(self.MEAN, "Mean (R; G; B)", optional=True),
                "Three numbers, separated by “;”. 0;0;0 if the network takes pixel values as they are.",
            ),
            with_help(
                QgsProcessingParameterString(self.STANDARD_DEVIATION, "Standard deviation (R; G; B)", optional=True),
                "Three numbers, separated by “;”. 1;1;1 if the network takes pixel values as they are.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.THRESHOLD, "Threshold", DOUBLE, optional=True, minValue=0, maxValue=1
                ),
                "Probability from which a pixel has the class, for networks with one output. If not set, 0.5.",
            ),
            with_help(
                QgsProcessingParameterString(self.LICENSE, "License", optional=True),
                "License of the network, as its maker states it. The model card shows it.",
            ),
            with_help(
                QgsProcessingParameterString(self.NAME, "Name", optional=True),
                "Name for the list of models. If not set, the name of the file.",
            ),
            with_help(
                QgsProcessingParameterString(self.ARCHITECTURE, "Architecture of the checkpoint", "unet"),
                "Name in segmentation_models_pytorch, for example unet, fpn or deeplabv3. Not used for ONNX files.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterString(self.ENCODER, "Encoder of the checkpoint", "resnet34"),
                "Name in segmentation_models_pytorch, for example resnet34. Not used for ONNX files.",
                advanced=True,
            ),
            parameters.python_of_training(),
            with_help(
                QgsProcessingParameterFileDestination(self.OUTPUT, "Model", fileFilter=tr("ONNX models (*.onnx)")),
                "Copy of the network with metadata. The file of the network is not changed.",
            ),
            QgsProcessingOutputNumber(self.CLASS_COUNT, "Number of classes"),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.segmentation.foreign_network import stated_facts, with_facts
        from ...core.segmentation.model import SegmentationModel
        from ...core.segmentation.network import OnnxNetwork

        path, threads = values.file(self.INPUT), worker_threads()
        with tempfile.TemporaryDirectory() as folder:
            if path.lower().endswith(CHECKPOINTS):
                facts = self._facts(values, None)
                path = self._export(values, facts, folder, feedback)
            feedback.setProgressText(tr("Loading the model"))
            network = cancelable(OnnxNetwork, path, threads, CPU.key, feedback=feedback)
            facts = self._facts(values, stated_facts(network))
            data = cancelable(with_facts, network, facts, feedback=feedback)
        with outputs.file(self.OUTPUT) as temporary:
            Path(temporary).write_bytes(data)
            model = cancelable(SegmentationModel, temporary, threads, None, CPU.key, feedback=feedback)
        feedback.pushInfo(tr("Classes: {names}").format(names=", ".join(model.classes.names)))
        return {self.CLASS_COUNT: len(model.classes.names)}

    def _facts(self, values: Values, stated: NetworkFacts | None) -> NetworkFacts:
        """Return the fields that are set; the others from the preset, or as stated by the file."""
        from ...core.segmentation.network_facts import BUILDINGS, FLAIR, NetworkFacts

        preset = {FLAIR_PRESET: FLAIR, BUILDINGS_PRESET: BUILDINGS}.get(values.choice(self.PRESET))
        base = preset or stated or NetworkFacts((), 0.0)
        scale = 255 if values.choice(self.PIXEL_VALUES) == FROM_0_TO_255 else 1
        resolution_cm = values.optional_number(self.RESOLUTION)
        names = tuple(name.strip() for name in values.text(self.CLASSES).split(SEPARATOR))
        given: dict[str, Any] = {
            "classes": names if any(names) else None,
            "resolution_m": None if resolution_cm is None else resolution_cm / 100,
            "mean": tuple(number / scale for number in values.numbers(self.MEAN)) or None,
            "std": tuple(number / scale for number in values.numbers(self.STANDARD_DEVIATION)) or None,
            "threshold": values.optional_number(self.THRESHOLD),
            "license": values.text(self.LICENSE).strip() or None,
            "name": values.text(self.NAME).strip() or base.name or Path(values.file(self.INPUT)).stem,
        }
        return replace(base, **{key: value for key, value in given.items() if value is not None})

    def _export(self, values: Values, facts: NetworkFacts, folder: str, feedback: QgsProcessingFeedback) -> str:
        """Return the path of a checkpoint's network as an ONNX file in a folder. Raises SemRefError."""
        from ...core.segmentation.network_facts import require_facts
        from ...core.segmentation.onnx_file import no_model_file
        from ...training.job import CHECKPOINT_JOB
        from ..jobs.training_process import run_training
        from ..packages.training_environment import training_python

        require_facts(facts)
        path, target = values.file(self.INPUT), os.path.join(folder, "network.onnx")
        if not os.path.isfile(path):
            raise ModelError(no_model_file(path))
        python = training_python(values.file(self.PYTHON))
        job = {
            "checkpoint": os.path.abspath(path),
            "architecture": values.text(self.ARCHITECTURE).strip(),
            "encoder": values.text(self.ENCODER).strip(),
            "outputs": len(facts.classes),
            "output": target,
        }
        file = Path(folder) / "job.json"
        file.write_text(json.dumps(job), encoding="utf-8")
        feedback.setProgressText(tr("Starting the training environment"))
        run_training(python, [CHECKPOINT_JOB, str(file)], feedback, 0.0, 100.0)
        return target
