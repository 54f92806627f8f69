"""What is wrong with a segmentation model, or with a photo for it."""

SENTENCES = {
    "segmentation.not_numbers": (
        "{path} gives values that are not numbers (NaN or infinite); it is damaged, or its standardization_mean "
        "and standardization_std are not those it was trained with."
    ),
    "segmentation.unknown_class_number": (
        "{path} gives the class number {number:g}, but it names {count} classes; take the names it was trained with."
    ),
    "segmentation.inputs_outputs": (
        "{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each."
    ),
    "segmentation.input_shape": (
        "{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue)."
    ),
    "segmentation.input_type": "{path} takes {kind} values; a segmentation network takes floats.",
    "segmentation.batch_size": "{path} takes {count} images at once; export it for one (or any number).",
    "segmentation.output_shape": (
        "{path} gives the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × "
        "{height} × {width}."
    ),
    "segmentation.output_kind": "{path} gives {kind}; a segmentation network gives one array of numbers.",
    "segmentation.tile_too_large": (
        "{path} takes images of {width} × {height} pixels; a segmentation network takes up to {most} × {most}: export "
        "it with a smaller or free size."
    ),
    "segmentation.metadata_too_long": (
        "{source} has {count} characters of metadata as {key}; no segmentation network needs more than {most}."
    ),
    "segmentation.run_failed": "{path} fails on an image of {width} × {height} pixels: {reason}.",
    "segmentation.no_onnxruntime": (
        "Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example "
        "with “python3 -m pip install onnxruntime”."
    ),
    "segmentation.no_model_file": "{path} does not exist; choose a model file (.onnx).",
    "segmentation.resolution_too_coarse": (
        "At {resolution_cm:g} cm a pixel nothing is left of the image; choose a smaller resolution."
    ),
    "segmentation.lacks_reference_class": (
        "{source} does not know the database's class {missing}, only {names}; take a model that was trained on the "
        "database's classes."
    ),
    "segmentation.not_a_segmentor": (
        "{source} is a model of type {kind} (metadata key model_type); choose a Segmentor."
    ),
    "segmentation.no_class_names": (
        "{source} does not name its classes (metadata key class_names); choose a model that does, or export it "
        "with their names."
    ),
    "segmentation.table_lacks_class": (
        "The class table lacks the class {missing} of {source}; add it, or give no class table."
    ),
    "segmentation.not_by_channel": (
        '{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.'
    ),
    "segmentation.class_value": ("{source} has {value} in class_values; class values are whole numbers from 0 to 255."),
    "segmentation.number_out_of_range": (
        "{source} has “{text}” as {key}; it must be a number from {least:g} to {most:g}: mend or remove it."
    ),
    "segmentation.image_too_small": (
        "An image of {width} × {height} pixels shows too little to be segmented; it needs {least} pixels each way "
        "at the model's resolution."
    ),
    "segmentation.names_in_model": (
        "{source} tells {channels} classes apart, but there are {count} class names in its metadata (class_names): "
        "{names}; take the names it was trained with."
    ),
    "segmentation.names_in_table": (
        "{source} tells {channels} classes apart, but there are {count} class names in the class table: {names}; "
        "take the names it was trained with."
    ),
    "segmentation.three_numbers": (
        "{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue."
    ),
    "segmentation.three_positive_numbers": (
        "{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0."
    ),
    "segmentation.class_bias": (
        '{source} has “{text}” as {key}; it must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with '
        "names of its classes, and east, north, right, down, spread in meters up to {most:g}, sun in degrees: mend or "
        "remove it."
    ),
    "segmentation.weights_apart": (
        "{path} keeps its weights in another file, so it can't be copied with its bias; export it as one file."
    ),
    "segmentation.newer_ir": (
        "{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a "
        "newer onnxruntime or export the model with an older ir_version."
    ),
    "segmentation.newer_opset": (
        "{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; "
        "install a newer onnxruntime or export the model with an older opset."
    ),
    "segmentation.weights_missing": (
        "{path} keeps its weights in another file that is missing or cut short; put it beside the model under its "
        "old name ({reason})."
    ),
    "segmentation.not_text": "{path} has names or metadata that are no text in UTF-8; export the network again.",
    "segmentation.no_onnx": "{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.",
    "segmentation.device_failed": "{device} could not be started ({reason}); the network runs on {other}.",
    "segmentation.device_missing": (
        "{device} was asked for, but this onnxruntime does not have it: it comes with the Python package {package}; "
        "the network runs on {other}."
    ),
    "segmentation.device_left_out": "its driver or its libraries could not be loaded",
    "segmentation.not_run": "{path} can't be run by onnxruntime {version}: {reason}.",
    "segmentation.aligned_corners": (
        "The network enlarges with aligned corners: what lies off the middle of a tile is shown up to some pixels "
        "farther off, and photos are taken for up to 1 % larger than they are."
    ),
    "segmentation.other_tile_size": (
        "tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels: these are "
        "used."
    ),
}
